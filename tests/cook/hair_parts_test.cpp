// Parts of a model that a recipe takes by points on them, and what is decided where nothing says what is hair.

#include "cook/built_models.h"
#include "cook/recipe/recipe.h"
#include "cook/select/crown_view.h"
#include "cook/select/hair_candidates.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace coif::cook::hair_parts_test {

using Eigen::Vector3d;

constexpr double kRadius = 0.1;
const Vector3d kCentre{0, 1.65, 0};

/// A turn around the upright axis, radians, that a shell leaves open at the front.
enum class Opening { kNone, kFace };

/// Adds a shell around the head's centre from height `low` to `high`, each -1..1, as a piece of its own.
void add_shell(double radius, double low, double high, Opening opening, importer::SourceMesh& mesh) {
  constexpr int kRows = 12, kColumns = 36;
  const double open = opening == Opening::kFace ? 0.25 : 0;
  const auto first = std::uint32_t(mesh.positions.size());
  for (int row = 0; row <= kRows; ++row) {
    const double y = low + (high - low) * row / kRows, across = std::sqrt(1 - y * y);
    for (int column = 0; column <= kColumns; ++column) {
      const double turn = 2 * std::numbers::pi * (open / 2 + (1 - open) * column / kColumns);
      const Vector3d at = kCentre + radius * Vector3d(across * std::sin(turn), y, across * std::cos(turn));
      mesh.positions.push_back(at.cast<float>());
    }
  }
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t column = 0; column < kColumns; ++column) {
      const std::uint32_t a = first + row * (kColumns + 1) + column, b = a + kColumns + 1;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  }
}

/// A head and a cap of hair in one mesh, on a rig without a word about hair.
importer::SourceModel merged_person() {
  importer::SourceModel model;
  const auto add = [&](const char* name, std::uint32_t parent, const Vector3d& place) {
    model.nodes.push_back({name, parent, Eigen::Affine3d(Eigen::Translation3d(place))});
  };
  add("Hips", importer::kNoIndex, {0, 1, 0});
  add("Neck", 0, {0, 1.48, 0});
  add("Head", 1, {0, 1.555, -0.015});
  add("Mesh", 2, {0, 0, 0});
  importer::SourceMesh mesh;
  mesh.name = "Mesh";
  mesh.node = 3;
  add_shell(kRadius, -0.99, 0.99, Opening::kNone, mesh);
  add_shell(1.1 * kRadius, 0.3, 0.99, Opening::kNone, mesh);
  model.meshes.push_back(mesh);
  model.path = "person.glb";
  return model;
}

/// Only shells, on one node without a word.
importer::SourceModel shells(Opening opening) {
  importer::SourceModel model;
  model.nodes.push_back({"Node", importer::kNoIndex, Eigen::Affine3d::Identity()});
  model.path = "model.glb";
  importer::SourceMesh mesh;
  mesh.name = "Mesh";
  add_shell(kRadius, -0.7, 0.99, opening, mesh);
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
  EXPECT_GT(open_face(shells(Opening::kFace)), 0.15);
  EXPECT_EQ(open_face(shells(Opening::kNone)), 0);
  for (const Opening opening : {Opening::kFace, Opening::kNone}) {
    Findings findings;
    (void)choose_hair(shells(opening), default_recipe(), findings);
    ASSERT_EQ(findings.decisions.size(), 1u);
    EXPECT_EQ(findings.decisions[0].what, "hair");
    EXPECT_EQ(findings.decisions[0].key, "\"hair\": {\"meshes\": [\"Mesh\"]}");
    EXPECT_EQ(findings.decisions[0].probability >= kSureEnough, opening == Opening::kFace);
    EXPECT_EQ(findings.warnings.empty(), opening == Opening::kFace);
  }
}

TEST(WholeModel, TheNameOfAFileMakesNoHairOfAHead) {
  importer::SourceModel model = shells(Opening::kNone);
  model.path = "long_hair.glb";
  Findings findings;
  (void)choose_hair(model, default_recipe(), findings);
  ASSERT_EQ(findings.warnings.size(), 1u);
  EXPECT_EQ(findings.warnings[0].code, "S202");
}

}  // namespace coif::cook::hair_parts_test
