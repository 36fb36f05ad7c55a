#include "cook/recipe/decision.h"

#include "cook/built_models.h"
#include "cook/cook.h"
#include "cook/select/head.h"
#include "cook/select/select_hair.h"
#include "cook/told.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

namespace coif::cook::decision_test {

Decision sure_to(double probability) {
  return {"head", "here", "two eyes", probability, "\"head.center\"", {{"eyes", 1.0}}};
}

TEST(Decisions, AreNotedWhereSureAndWarnedOfWhereInDoubt) {
  Findings sure, unsure;
  sure.decide(sure_to(kSureEnough));
  unsure.decide(sure_to(kSureEnough - 0.01));
  EXPECT_TRUE(sure.warnings.empty());
  ASSERT_EQ(sure.notes.size(), 1u);
  ASSERT_EQ(unsure.warnings.size(), 1u);
  EXPECT_TRUE(unsure.notes.empty());
  EXPECT_EQ(unsure.warnings[0].code, "S227");
  EXPECT_NE(unsure.warnings[0].message.find("in the recipe, \"head.center\" says it"), std::string::npos);
}

TEST(Decisions, NeverSayThatAGuessIsCertain) { EXPECT_NE(sure_to(1).text().find("99 % sure"), std::string::npos); }

TEST(Decisions, AskBelowAQuarterUnlessTheirCodeIsAcknowledged) {
  Findings findings;
  findings.decide(sure_to(kAskBelow));
  EXPECT_EQ(findings.question({}), nullptr);
  findings.decide(sure_to(kAskBelow - 0.01));
  EXPECT_EQ(findings.question({}), &findings.decisions[1]);
  EXPECT_EQ(findings.question(std::array<std::string, 1>{"S227"}), nullptr);
  EXPECT_NE(findings.question(std::array<std::string, 1>{"S228"}), nullptr);
  Findings of_facing;
  of_facing.decide({"facing", "+Z", "nothing shows it", 0.1, "\"head.faces\"", {}});
  EXPECT_EQ(of_facing.question({}), nullptr) << "the asset shows it";
}

TEST(Decisions, ComeBackFromJson) {
  const Decision said = sure_to(0.3);
  const auto back = nlohmann::json(said).get<Decision>();
  EXPECT_EQ(back.text(), said.text());
  EXPECT_EQ(back.features, said.features);
  EXPECT_THROW((void)nlohmann::json::object().get<Decision>(), nlohmann::json::exception);
}

TEST(Decisions, OddsAddUp) {
  static constexpr std::array kWeights{FeatureWeight{"a", 2.0}, FeatureWeight{"b", -1.0}};
  static constexpr Logistic kTable{0.5, kWeights};
  EXPECT_NEAR(kTable.probability({{"a", 0.5}, {"b", 1.5}, {"unknown", 9}}), 0.5, 1e-12);
  EXPECT_GT(kTable.probability({{"a", 1}}), kTable.probability({{"a", 0}}));
}

/// A few strips at one side of nothing: where is the head?
importer::SourceModel tuft() {
  importer::SourceModel model;
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  importer::SourceMesh mesh;
  mesh.name = "hair";
  for (std::uint32_t s = 0; s < 4; ++s) {
    for (std::uint32_t row = 0; row < 6; ++row) {
      for (const float side : {0.0f, 0.01f})
        mesh.positions.emplace_back(0.02f * float(s) + side, 1.6f - 0.05f * float(row), 0.004f * float(row * s));
      const std::uint32_t v = 12 * s + 2 * row;
      if (row < 5) mesh.triangles.insert(mesh.triangles.end(), {v, v + 2, v + 1, v + 1, v + 2, v + 3});
    }
  }
  model.meshes.push_back(std::move(mesh));
  return model;
}

const Decision* decision_on(const Findings& findings, const std::string& what) {
  const auto found = std::ranges::find(findings.decisions, what, &Decision::what);
  return found == findings.decisions.end() ? nullptr : &*found;
}

TEST(Decisions, AHeadThatNothingShowsIsLessSureThanOneWithJoints) {
  const auto head_of = [](const importer::SourceModel& model, const Recipe& recipe) {
    return told([&](Findings& findings) {
      const auto hair = select_hair(model, recipe, unheard());
      const auto bone = find_head_bone(model, *hair, recipe.head_bone);
      FittedHead head = fit_head(model, *hair, *bone, recipe, findings);
      head.faces_backwards = faces_backwards(model, *hair, head, recipe, findings);
      return head;
    });
  };
  const auto bare = head_of(tuft(), default_recipe());
  ASSERT_NE(decision_on(bare, "head"), nullptr);
  EXPECT_LT(decision_on(bare, "head")->probability, kSureEnough);

  importer::SourceModel rigged = tuft();
  add_node(rigged, "spine", 0, {0.03f, 1.2f, 0});
  add_node(rigged, "neck", 1, {0.03f, 1.42f, 0});
  add_node(rigged, "head", 2, {0.03f, 1.5f, 0});
  rigged.meshes[0].node = 3;
  const auto with_joints = head_of(rigged, default_recipe());
  EXPECT_GT(decision_on(with_joints, "head")->probability, decision_on(bare, "head")->probability);

  Recipe said = default_recipe();
  said.head_center = {0.03, 1.55, 0};
  said.head_radii = {0.08, 0.1, 0.09};
  said.head_faces = Faces::kMinusZ;
  const auto by_recipe = head_of(tuft(), said);
  EXPECT_TRUE(by_recipe.decisions.empty()) << "the recipe decided";
  EXPECT_TRUE(by_recipe.made.faces_backwards);
}

}  // namespace coif::cook::decision_test
