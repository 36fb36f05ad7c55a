#include "cook/merge_back_faces.h"

#include "cook/built_models.h"
#include "cook/select_hair.h"
#include "cook/weld.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

/// A strip and its copy with every triangle turned round, in vertices of its own.
SourceMesh doubled_strip() {
  SourceMesh mesh = make_strip({});
  SourceMesh back = mesh;
  for (std::size_t t = 0; t < back.triangles.size(); t += 3) std::swap(back.triangles[t + 1], back.triangles[t + 2]);
  append_piece(mesh, back, 0);
  return mesh;
}

MergedFaces merge(HairMesh& mesh) { return merge_back_faces(mesh, weld_places(mesh.positions, 0)); }

TEST(MergeBackFaces, ACopyTurnedRoundBecomesAFlag) {
  HairMesh mesh = hair_from(doubled_strip());
  const MergedFaces merged = merge(mesh);
  EXPECT_EQ(merged.back_faces, 8u);
  EXPECT_EQ(merged.copies, 0u);
  EXPECT_EQ(mesh.triangle_count(), 8u);
  EXPECT_TRUE(mesh.double_sided);
}

TEST(MergeBackFaces, ACopyThatLooksTheSameWayIsNoBack) {
  SourceMesh strip = make_strip({});
  append_piece(strip, make_strip({}), 0);
  HairMesh mesh = hair_from(strip);
  const MergedFaces merged = merge(mesh);
  EXPECT_EQ(merged.copies, 8u);
  EXPECT_EQ(merged.back_faces, 0u);
  EXPECT_FALSE(mesh.double_sided);
}

TEST(MergeBackFaces, KeepsTheWindingOfTheFirst) {
  HairMesh mesh = hair_from(doubled_strip());
  const std::vector<std::uint32_t> first(mesh.triangles.begin(), mesh.triangles.begin() + 24);
  merge(mesh);
  EXPECT_EQ(mesh.triangles, first);
}

TEST(MergeBackFaces, TheReportSaysHowManyThereWere) {
  SourceModel model = make_wig();
  SourceMesh back = model.meshes[0];
  for (std::size_t t = 0; t < back.triangles.size(); t += 3) std::swap(back.triangles[t + 1], back.triangles[t + 2]);
  model.meshes.push_back(back);
  const auto hair = select_hair(model, default_recipe());
  ASSERT_TRUE(hair);
  EXPECT_EQ(hair->mesh.triangle_count(), 10u);
  EXPECT_EQ(hair->left_out.at(0).text(),
            "10 triangles that only were the back of others: the hair is drawn double-sided (120 bytes)");
}

TEST(ClosedSurfaces, ABoxIsClosedAndAStripIsNot) {
  HairMesh box;
  for (int i = 0; i < 8; ++i) box.positions.emplace_back(float(i & 1), float(i >> 1 & 1), float(i >> 2 & 1));
  box.triangles = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                   2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
  EXPECT_TRUE(is_closed(box, weld_places(box.positions, 0)));
  const HairMesh strip = hair_from(make_strip({}));
  EXPECT_FALSE(is_closed(strip, weld_places(strip.positions, 0)));
}

}  // namespace
}  // namespace coif
