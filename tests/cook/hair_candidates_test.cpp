#include "cook/select/under_hair.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace coif::cook::crown_cover_test {

using Eigen::Vector3d;

constexpr double kRadius = 0.1;
const Vector3d kCentre{0, 1.65, 0};

/// Part of a ball around the head's centre that hangs from the head: from height `low` to `high`, each -1 .. 1.
importer::SourceMesh shell(const std::string& name, double radius, double low, double high) {
  constexpr int kRows = 12, kColumns = 24;
  importer::SourceMesh mesh;
  mesh.name = name;
  mesh.node = 2;
  for (int row = 0; row <= kRows; ++row) {
    const double y = low + (high - low) * row / kRows, across = std::sqrt(1 - y * y);
    for (int column = 0; column <= kColumns; ++column) {
      const double turn = 2 * std::numbers::pi * column / kColumns;
      const Vector3d at = kCentre + radius * Vector3d(across * std::sin(turn), y, across * std::cos(turn));
      mesh.positions.push_back(at.cast<float>());
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t a = row * (kColumns + 1) + column, b = a + kColumns + 1;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
  return mesh;
}

/// A bald head on a neck, and `worn` over its crown.
importer::SourceModel person(const std::string& worn) {
  importer::SourceModel model;
  const auto add = [&](const char* name, std::uint32_t parent, const Vector3d& place) {
    model.nodes.push_back({name, parent, Eigen::Affine3d(Eigen::Translation3d(place))});
  };
  add("Hips", importer::kNoIndex, {0, 1, 0});
  add("Neck", 0, {0, 1.48, 0});
  add("Head", 1, {0, 1.555, -0.015});
  model.meshes = {shell("Object_1", kRadius, -0.99, 0.99), shell(worn, 1.1 * kRadius, 0.3, 0.99)};
  return model;
}

HairChoice nothing_of(const importer::SourceModel& model) {
  return {std::vector<std::vector<bool>>(model.meshes.size())};
}

TEST(CrownCover, IsWhatLiesOverTheCrownAndLeavesTheFaceFree) {
  const importer::SourceModel model = person("Object_2");
  const CrownCover cover = find_crown_cover(model, nothing_of(model), 2, 1.0e-5);
  ASSERT_TRUE(cover.found);
  EXPECT_TRUE(cover.choice.taken[0].empty()) << "a head covers its face, too";
  EXPECT_TRUE(cover.choice.takes(1, 0));
}

TEST(CrownCover, IsNotAskedForWhereHairCoversTheCrown) {
  const importer::SourceModel model = person("Object_2");
  HairChoice hair = nothing_of(model);
  hair.taken[1].assign(model.meshes[1].triangles.size() / 3, true);
  EXPECT_FALSE(find_crown_cover(model, hair, 2, 1.0e-5).found);
}

TEST(CrownCover, IsNoHatAndNothingWithoutJointsOfAHead) {
  for (const char* worn : {"Hat", "knight_helmet", "Hood.001"}) {
    const importer::SourceModel model = person(worn);
    EXPECT_FALSE(find_crown_cover(model, nothing_of(model), 2, 1.0e-5).found) << worn;
  }
  importer::SourceModel model = person("Object_2");
  model.nodes[0].name = model.nodes[1].name = "Armature";
  EXPECT_FALSE(find_crown_cover(model, nothing_of(model), 2, 1.0e-5).found);
  EXPECT_FALSE(find_crown_cover(model, nothing_of(model), importer::kNoIndex, 1.0e-5).found);
}

}  // namespace coif::cook::crown_cover_test
