#include "cook/select_hair.h"

#include "cook/built_models.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

/// The wig with a body: a second mesh that no hair bone moves.
SourceModel wig_with_body() {
  SourceModel model = make_wig();
  SourceMesh body = make_strip({.root = {0, 1.4f, 0}, .along = {0, -1, 0}, .rows = 6});
  body.name = "body";
  body.node = 0;
  model.meshes.push_back(body);
  return model;
}

TEST(SelectHair, TakesWhatIsCalledHairAndSaysWhatItLeft) {
  const auto hair = select_hair(wig_with_body(), default_recipe());
  ASSERT_TRUE(hair);
  EXPECT_EQ(hair->mesh.triangle_count(), 10u);
  ASSERT_EQ(hair->left_out.size(), 1u);
  EXPECT_EQ(hair->left_out[0].text(), "mesh 'body' (12 triangles): not hair");
}

TEST(SelectHair, TakesEverythingWhereNothingIsCalledHair) {
  SourceModel model = wig_with_body();
  model.meshes[0].name = "thing";
  for (SourceNode& node : model.nodes) node.name = "node";
  EXPECT_EQ(select_hair(model, default_recipe())->mesh.triangle_count(), 22u);
}

TEST(SelectHair, CutsHairOutOfAMergedMeshByItsBones) {
  SourceModel model = make_wig();
  append_piece(model.meshes[0], make_strip({.root = {1, 1, 1}}), 1);
  Recipe recipe = default_recipe();
  recipe.hair_bones = {"hair_*"};
  const auto hair = select_hair(model, recipe);
  ASSERT_TRUE(hair);
  EXPECT_EQ(hair->mesh.triangle_count(), 10u) << "the piece keeps its root, which follows the scalp";
  EXPECT_EQ(hair->left_out[0].text(), "mesh 'hair', 8 triangles: of pieces that are not hair");
}

TEST(SelectHair, APatternThatMatchesNothingNamesWhatThereIs) {
  Recipe recipe = default_recipe();
  recipe.hair_meshes = {"wig*"};
  const auto hair = select_hair(wig_with_body(), recipe);
  ASSERT_FALSE(hair);
  EXPECT_EQ(hair.error().message,
            "wig.glb: recipe key \"hair.meshes\": nothing is called 'wig*'; there are: body, hair");
  EXPECT_EQ(hair.error().kind, ToolError::Kind::kBadInput);
}

TEST(SelectHair, TrianglesWithoutAreaAreLeftOut) {
  SourceModel model = make_wig();
  model.meshes[0].triangles.insert(model.meshes[0].triangles.end(), {0, 0, 1, 2, 2, 2});
  const auto hair = select_hair(model, default_recipe());
  EXPECT_EQ(hair->mesh.triangle_count(), 10u);
  EXPECT_EQ(hair->left_out[0].text(), "mesh 'hair', 2 triangles: without area");
}

TEST(SelectHair, AModelWithoutAreaSaysSo) {
  SourceModel model = make_wig();
  for (Eigen::Vector3f& p : model.meshes[0].positions) p = {0, 1, 0};
  const auto hair = select_hair(model, default_recipe());
  ASSERT_FALSE(hair);
  EXPECT_EQ(hair.error().message, "wig.glb: all 10 triangles are without area; scale the model up or export it again");
}

TEST(SelectHair, MeshesWithAndWithoutTextureCoordinatesJoin) {
  SourceModel model = make_wig();
  SourceMesh bare = make_strip({.root = {0.2f, 1.6f, 0}});
  bare.uvs.clear();
  bare.node = 1;
  model.meshes.push_back(bare);
  const auto hair = select_hair(model, default_recipe());
  ASSERT_TRUE(hair);
  EXPECT_EQ(hair->mesh.triangle_count(), 18u);
  EXPECT_EQ(hair->mesh.uvs.size(), hair->mesh.positions.size());
}

}  // namespace
}  // namespace coif
