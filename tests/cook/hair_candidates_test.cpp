#include "cook/select/hair_candidates.h"
#include "cook/built_models.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace coif::cook::hair_candidates_test {

constexpr double kRadius = 0.1;

importer::SourceMesh shell(const std::string& name, double radius, double low, double high) {
  importer::SourceMesh mesh = make_shell(radius, low, high);
  mesh.name = name;
  mesh.node = 3;
  return mesh;
}

/// A bald head on a neck, and `worn` over its crown.
importer::SourceModel person(const std::string& worn) {
  importer::SourceModel model = make_spine();
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
