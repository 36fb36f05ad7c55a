#include "cook/select/hair_candidates.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace coif::cook::hair_candidates_test {

using Eigen::Vector3d;

constexpr double kRadius = 0.1;
const Vector3d kCentre{0, 1.65, 0};

/// Part of a ball around the head's centre that hangs from the head: from height `low` to `high`, each -1 .. 1.
importer::SourceMesh shell(const std::string& name, double radius, double low, double high) {
  constexpr int kRows = 12, kColumns = 24;
  importer::SourceMesh mesh;
  mesh.name = name;
  mesh.node = 3;
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
  add("Body", 2, {0, 0, 0});
  model.meshes = {shell("Object_1", kRadius, -0.99, 0.99), shell(worn, 1.1 * kRadius, 0.3, 0.99)};
  return model;
}

/// What is found of the mesh, or nothing.
const HairCandidate* part_of(const HairCandidates& candidates, std::uint32_t mesh) {
  for (const HairCandidate& part : candidates.list)
    if (part.mesh == mesh) return &part;
  return nullptr;
}

TEST(HairCandidates, RankWhatCoversTheCrownAndLeavesTheFaceFreeBeforeTheHead) {
  const importer::SourceModel model = person("Object_2");
  const HairCandidates found = find_hair_candidates(model, 1.0e-5);
  ASSERT_TRUE(found.sees_head);
  const HairCandidate *cap = part_of(found, 1), *head = part_of(found, 0);
  ASSERT_TRUE(cap != nullptr && head != nullptr);
  EXPECT_EQ(found.list[0].mesh, 1u);
  EXPECT_TRUE(cap->is_whole_mesh);
  EXPECT_GT(cap->probability, 0.5);
  EXPECT_LT(head->probability, 0.2) << "a head covers its face, too";
  EXPECT_GT(head->at(Feature::kMiddle), 0.9);
}

TEST(HairCandidates, CountNamesForHairAndAgainstIt) {
  const auto probability = [](const char* worn) {
    return part_of(find_hair_candidates(person(worn), 1.0e-5), 1)->probability;
  };
  EXPECT_GT(probability("Hair"), probability("Object_2"));
  for (const char* worn : {"Hat", "knight_helmet", "Hood.001"}) EXPECT_LT(probability(worn), probability("Object_2"));
}

TEST(HairCandidates, AreMeasuredOnTheHeadsOwnPieceWhereJointsShowNoSize) {
  importer::SourceModel model = person("Object_2");
  model.nodes[1].name = "Armature";
  const HairCandidates found = find_hair_candidates(model, 1.0e-5);
  ASSERT_TRUE(found.sees_head);
  EXPECT_EQ(found.list[0].mesh, 1u);
}

TEST(HairCandidates, SeeNoHeadWithoutABone) {
  importer::SourceModel model = person("Object_2");
  for (importer::SourceNode& node : model.nodes) node.name = "Bone";
  EXPECT_FALSE(find_hair_candidates(model, 1.0e-5).sees_head);
}

TEST(HairCandidates, TellTheRecipesLineAndTheReason) {
  const importer::SourceModel model = person("Object_2");
  const HairCandidates found = find_hair_candidates(model, 1.0e-5);
  EXPECT_EQ(recipe_line(model, found.list[0], found), "\"hair\": {\"meshes\": [\"Object_2\"]}");
  EXPECT_NE(reason_for(model, found.list[0]).find("of the crown"), std::string::npos);
}

}  // namespace coif::cook::hair_candidates_test
