#include "cook/select/hair_evidence.h"

#include "cook/built_models.h"
#include "cook/recipe/recipe.h"
#include "cook/select/select_hair.h"

#include <cmath>

namespace coif::cook::bare_body_test {

/// A ball of the size of a head, open below a share of its height, whose vertices no two triangles share.
importer::SourceMesh ball(float open_below, const Eigen::Vector3f& radii = {0.09f, 0.12f, 0.1f}) {
  constexpr int kRings = 24, kSectors = 32;
  const auto at = [&](int ring, int sector) {
    const float polar = float(M_PI) * float(ring) / kRings,
                around = 2 * float(M_PI) * float(sector % kSectors) / kSectors;
    return Eigen::Vector3f(Eigen::Vector3f(0, 1.6f, 0) +
                           radii.cwiseProduct(Eigen::Vector3f(std::sin(polar) * std::sin(around), std::cos(polar),
                                                              std::sin(polar) * std::cos(around))));
  };
  importer::SourceMesh mesh;
  mesh.name = "Mesh_0";
  for (int ring = 0; ring < kRings; ++ring) {
    if (std::cos(M_PI * (ring + 1) / kRings) < double(2 * open_below - 1)) break;
    for (int sector = 0; sector < kSectors; ++sector) {
      for (const Eigen::Vector3f corner : {at(ring, sector), at(ring + 1, sector), at(ring + 1, sector + 1),
                                           at(ring, sector), at(ring + 1, sector + 1), at(ring, sector + 1)}) {
        mesh.triangles.push_back(std::uint32_t(mesh.positions.size()));
        mesh.positions.push_back(corner);
      }
    }
  }
  return mesh;
}

importer::SourceModel model_of(std::vector<importer::SourceMesh> meshes) {
  importer::SourceModel model;
  model.path = "export.glb";
  add_node(model, "Mesh_0", importer::kNoIndex, {0, 0, 0});
  model.meshes = std::move(meshes);
  return model;
}

std::string refusal_of(const importer::SourceModel& model) {
  Findings findings;
  const auto choice = choose_hair(model, default_recipe(), findings);
  return choice ? "" : choice.error().message;
}

TEST(ChooseHair, NoHairIsInventedFromAHeadWhateverItIsCalled) {
  for (const float open_below : {0.0f, 0.12f}) {
    const std::string why = refusal_of(model_of({ball(open_below)}));
    EXPECT_NE(why.find("there is no hair, only what looks like a body: mesh 'Mesh_0'"), std::string::npos)
        << open_below << why;
    EXPECT_NE(why.find("Object > Convert > Mesh"), std::string::npos) << why;
  }
  // In pieces: eyeballs of half a centimetre beside it.
  importer::SourceMesh eye = ball(0, {0.012f, 0.012f, 0.012f});
  EXPECT_NE(refusal_of(model_of({ball(0.1f), eye})), "");
}

TEST(ChooseHair, AnEmptyNodeCalledHairIsNamedInTheRefusal) {
  importer::SourceModel model = model_of({ball(0)});
  add_node(model, "HairCurves", importer::kNoIndex, {0, 0, 0});
  EXPECT_NE(refusal_of(model).find("node 'HairCurves' has no mesh"), std::string::npos) << refusal_of(model);
}

TEST(ChooseHair, HairThatTheFileHidesIsNotCalledAbsent) {
  importer::SourceModel model = model_of({ball(0)});
  add_node(model, "HairCards", importer::kNoIndex, {0, 0, 0});
  model.warnings.emplace_back("S213", "1 mesh left out, since the file hides it: 'HairCards'");
  EXPECT_NE(refusal_of(model).find("the file hides other meshes"), std::string::npos) << refusal_of(model);
  EXPECT_EQ(refusal_of(model).find("has no mesh"), std::string::npos) << refusal_of(model);
}

TEST(ChooseHair, AFigureThatStandsOnTheGroundIsABody) {
  importer::SourceMesh figure = ball(0, {0.35f, 0.85f, 0.05f});  // Flat, so that it is no full form.
  for (Eigen::Vector3f& p : figure.positions) p.y() += 0.85f - 1.6f;
  EXPECT_NE(refusal_of(model_of({figure})), "");
}

TEST(ChooseHair, HairOfOnePieceIsHair) {
  EXPECT_EQ(refusal_of(model_of({ball(0.45f)})), "") << "a cap of one sheet";
  EXPECT_EQ(refusal_of(model_of({make_strip({})})), "");
  importer::SourceModel named = model_of({ball(0)});
  named.meshes[0].name = "afro_hair";
  EXPECT_EQ(refusal_of(named), "") << "somebody says that it is";
  named.meshes[0].name = "Mesh_0";
  named.path = "out/hair_07.glb";
  EXPECT_EQ(refusal_of(named), "") << "so does the file's name";
}

}  // namespace coif::cook::bare_body_test
