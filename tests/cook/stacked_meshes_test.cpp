// Meshes of the hair that seem to be levels of detail of each other.

#include "cook/built_models.h"
#include "cook/recipe/recipe.h"
#include "cook/select/select_hair.h"
#include "cook/told.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>

namespace coif::cook::stacked_meshes_test {

/// Two meshes that are hair, on nodes of their own, of so many rows of triangles in one place.
importer::SourceModel two_meshes(std::uint32_t rows, std::uint32_t other_rows,
                                 const Eigen::Vector3f& other_root = {0, 0, 0}) {
  importer::SourceModel model = make_wig();
  const std::uint32_t nodes[] = {add_node(model, "Hair_High", 0, {0, 0, 0}), add_node(model, "Hair_Low", 0, {0, 0, 0})};
  model.meshes.clear();
  for (const std::uint32_t node : nodes) {
    const bool is_other = node == nodes[1];
    importer::SourceMesh mesh = make_strip({.root = is_other ? other_root : Eigen::Vector3f(0, 0, 0),
                                            .along = {0, -1, 0},
                                            .rows = is_other ? other_rows : rows});
    mesh.name = model.nodes[node].name;
    mesh.node = node;
    model.meshes.push_back(std::move(mesh));
  }
  return model;
}

bool tells_of_stacked(const importer::SourceModel& model, const std::string& text) {
  const auto hair = told([&](Findings& findings) { return select_hair(model, default_recipe(), findings); });
  return std::ranges::any_of(hair.warnings,
                             [&](const Diagnostic& w) { return w.message.find(text) != std::string::npos; });
}

TEST(StackedMeshes, OfOneShapeAreWarnedOf) {
  EXPECT_TRUE(
      tells_of_stacked(two_meshes(20, 5), "mesh 'Hair_Low' (10 triangles) lies on mesh 'Hair_High' (40 triangles)"));
  EXPECT_TRUE(tells_of_stacked(two_meshes(5, 20), "\"hair\": {\"meshes\": [\"Hair_Low\"]}"));
  EXPECT_FALSE(tells_of_stacked(two_meshes(20, 20), "lies on")) << "as many: they are merged";
  EXPECT_FALSE(tells_of_stacked(two_meshes(20, 5, {0, 0, 0.05f}), "lies on")) << "behind it";
  EXPECT_FALSE(tells_of_stacked(two_meshes(20, 5, {0, -0.5f, 0}), "lies on")) << "lower";
}

}  // namespace coif::cook::stacked_meshes_test
