// Parts of a model that a recipe takes by points on them, and what is decided where nothing says what is hair.

#include "cook/built_models.h"
#include "cook/recipe/recipe.h"
#include "cook/select/crown_view.h"
#include "cook/select/hair_candidates.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace coif::cook::hair_parts_test {

constexpr double kRadius = 0.1;

/// A head and a cap of hair in one mesh, on a rig without a word about hair.
importer::SourceModel merged_person() {
  importer::SourceModel model = make_spine();
  importer::SourceMesh mesh = make_shell(kRadius, -0.99, 0.99);
  mesh.name = "Mesh";
  mesh.node = 3;
  append_piece(mesh, make_shell(1.1 * kRadius, 0.3, 0.99), 0);
  model.meshes.push_back(mesh);
  model.path = "person.glb";
  return model;
}

constexpr double kFace = 0.25;  ///< Share of the circle around a head.

/// Only a shell, on one node without a word.
importer::SourceModel shell(double open) {
  importer::SourceModel model;
  model.nodes.push_back({"Node", importer::kNoIndex, Eigen::Affine3d::Identity()});
  model.path = "model.glb";
  importer::SourceMesh mesh = make_shell(kRadius, -0.7, 0.99, open);
  mesh.name = "Mesh";
  model.meshes.push_back(mesh);
  return model;
}

Told<tl::expected<HairChoice, ToolError>> choice_of(const importer::SourceModel& model, const Recipe& recipe) {
  return told([&](Findings& findings) { return choose_hair(model, recipe, findings); });
}

TEST(HairParts, TheLineOfEachPartTakesThatPartAndNothingElse) {
  const importer::SourceModel model = merged_person();
  const HairCandidates found = find_hair_candidates(model, 1.0e-5);
  ASSERT_EQ(found.list.size(), 2u);
  for (const HairCandidate& part : found.list) {
    const std::string line = recipe_line(model, part, found);
    const auto recipe = nlohmann::json::parse("{" + line + "}");
    ASSERT_TRUE(recipe["hair"].contains("parts")) << line;
    Recipe asked = default_recipe();
    asked.hair_parts = recipe["hair"]["parts"].get<std::vector<std::array<double, 3>>>();
    const auto chosen = choice_of(model, asked);
    ASSERT_TRUE(chosen.made);
    EXPECT_EQ(chosen.made->taken[0], part.taken) << line;
  }
}

TEST(HairParts, AMeshWithANameOfItsOwnIsTakenByIt) {
  importer::SourceModel model = merged_person();
  HairChoice all;
  all.taken = {std::vector<bool>(model.meshes[0].triangles.size() / 3, true)};
  EXPECT_EQ(recipe_line(model, all, find_hair_candidates(model, 1.0e-5)), "\"hair\": {\"meshes\": [\"Mesh\"]}");
  model.meshes.push_back(model.meshes[0]);
  all.taken.emplace_back();
  EXPECT_NE(recipe_line(model, all, find_hair_candidates(model, 1.0e-5)).find("\"parts\""), std::string::npos)
      << "the name says two meshes";
}

TEST(HairParts, APointOnNothingIsAnErrorThatSaysWhereToFindOne) {
  Recipe recipe = default_recipe();
  recipe.hair_parts = {{0, 1.75, 0}, {0, 9, 0}};
  const auto chosen = choice_of(merged_person(), recipe);
  ASSERT_FALSE(chosen.made);
  EXPECT_EQ(chosen.made.error().kind, ToolError::Kind::kBadInput);
  EXPECT_NE(chosen.made.error().message.find("[0, 9, 0]"), std::string::npos) << chosen.made.error().message;
  EXPECT_NE(chosen.made.error().message.find("--list candidates"), std::string::npos);
}

TEST(HairParts, RecipesWithPointsAreReadAndOthersAreRefused) {
  const auto good = parse_recipe(R"({"hair": {"parts": [[0, 1.7, 0.1], [1, 2, 3]]}})", "r.json");
  ASSERT_TRUE(good);
  EXPECT_EQ(good->hair_parts.size(), 2u);
  for (const char* bad : {R"({"hair": {"parts": [[0, 1.7]]}})", R"({"hair": {"parts": [0, 1, 2]}})",
                          R"({"hair": {"parts": [["a", 1, 2]]}})", R"({"hair": {"parts": [[1e30, 1, 2]]}})"}) {
    EXPECT_FALSE(parse_recipe(bad, "r.json")) << bad;
  }
}

TEST(WholeModel, IsHairWhereItLeavesAFaceOpenAndInDoubtWhereItGoesRound) {
  EXPECT_GT(open_face(shell(kFace)), 0.15);
  EXPECT_EQ(open_face(shell(0)), 0);
  for (const double open : {kFace, 0.0}) {
    Findings findings;
    (void)choose_hair(shell(open), default_recipe(), findings);
    ASSERT_EQ(findings.decisions.size(), 1u);
    EXPECT_EQ(findings.decisions[0].what, "hair");
    EXPECT_EQ(findings.decisions[0].key, "\"hair\": {\"meshes\": [\"Mesh\"]}");
    EXPECT_EQ(findings.decisions[0].probability >= kSureEnough, open > 0);
    EXPECT_EQ(findings.warnings.empty(), open > 0);
  }
}

TEST(WholeModel, TheNameOfAFileMakesNoHairOfAHead) {
  importer::SourceModel model = shell(0);
  model.path = "long_hair.glb";
  Findings findings;
  (void)choose_hair(model, default_recipe(), findings);
  ASSERT_EQ(findings.warnings.size(), 1u);
  EXPECT_EQ(findings.warnings[0].code, "S202");
}

}  // namespace coif::cook::hair_parts_test
