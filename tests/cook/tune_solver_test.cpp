// The fewest sub-steps that keep a recipe's budget, and what they were chosen from.

#include "cook/dynamics/settle_dynamics.h"

#include "cook/dynamics/chain_groups.h"
#include "cook/recipe/recipe.h"
#include "cook/told.h"
#include "cook/vrm_chain.h"
#include "lab/reference_solver.h"
#include "lab/rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace coif::cook::tune_solver_test {

constexpr float kLength = 0.4f;

AssetContents calm_chain() { return rig_of_chain({.bones = 4, .length = kLength, .damping_ratio = 1}).contents(); }

Recipe budget(double error, double error_mm = 0, double cost = 0) {
  Recipe recipe = default_recipe();
  recipe.budget_error = error;
  recipe.budget_error_mm = error_mm;
  recipe.budget_cost = cost;
  return recipe;
}

TuningRecord tuned(const Recipe& recipe) {
  const auto result = tune_solver(calm_chain(), recipe, 1, unheard());
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  if (!result || result->tuning.size() != 1) return {};
  return result->tuning[0];
}

ToolError refusal(const Recipe& recipe) {
  const auto result = tune_solver(calm_chain(), recipe, 1, unheard());
  EXPECT_FALSE(result);
  return result ? ToolError{} : result.error();
}

TEST(TuneSolver, ATighterBudgetTakesAtLeastAsManySubSteps) {
  float before = 0;
  std::set<float> rates;
  for (const double error : {5.0, 1.0, 0.5, 0.3, 0.2}) {
    const TuningRecord tuning = tuned(budget(error));
    EXPECT_EQ(tuning.met, 1u);
    EXPECT_FLOAT_EQ(tuning.asked_error, float(error / 100));
    EXPECT_LE(tuning.reached_error, tuning.asked_error);
    EXPECT_GE(tuning.substep_rate, before) << error;
    rates.insert(before = tuning.substep_rate);
  }
  EXPECT_GT(rates.size(), 1u) << "or the budget decides nothing";
}

TEST(TuneSolver, NoFewerSubStepsWouldDo) {
  const auto result = tune_solver(calm_chain(), budget(0.3), 1, unheard());
  ASSERT_TRUE(result);
  const TuningRecord& chosen = result->tuning[0];
  ASSERT_GT(chosen.substep_rate, chosen.slowest_rate);
  for (const QualityRecord& row : result->quality) {
    const bool slower =
        row.frame_rate == chosen.slowest_rate && row.frame_rate * float(row.substeps) < chosen.substep_rate;
    if (slower) {
      EXPECT_GT(row.rms_error, chosen.asked_error) << row.substeps;
    }
  }
}

TEST(TuneSolver, AnErrorInMillimetresIsAShareOfTheLength) {
  const TuningRecord by_share = tuned(budget(0.3));
  const TuningRecord by_length = tuned(budget(0, 0.3 / 100 * kLength * 1000));
  EXPECT_NEAR(by_length.asked_error, by_share.asked_error, 1e-7f);
  EXPECT_EQ(by_length.substep_rate, by_share.substep_rate);
  EXPECT_NEAR(tuned(budget(0.3, 100)).asked_error, by_share.asked_error, 1e-7f) << "with both, both are kept";
  EXPECT_NEAR(tuned(budget(100, 1.2)).asked_error, by_share.asked_error, 1e-6f);
}

TEST(TuneSolver, ACostLimitsTheSubSteps) {
  const TuningRecord free = tuned(budget(0.3));
  const TuningRecord limited = tuned(budget(0, 0, 0.75 * free.cost));
  EXPECT_LE(limited.cost, 0.75f * free.cost);
  EXPECT_LT(limited.substep_rate, free.substep_rate);
  EXPECT_EQ(limited.met, 1u);
  EXPECT_EQ(limited.asked_error, 0.0f);
  EXPECT_GT(limited.substep_rate, limited.slowest_rate) << "what may be spent buys accuracy";
  EXPECT_LE(tuned(budget(0, 0, 100 * free.cost)).substep_rate, free.substep_rate) << "but no more than can be seen";
}

TEST(TuneSolver, ACostMayBeSpentToTheLast) {
  const TuningRecord free = tuned(budget(0.3));
  EXPECT_EQ(tuned(budget(0.3, 0, double(free.cost))).substep_rate, free.substep_rate);
}

TEST(TuneSolver, OfManyChainsThoseThatTellTheMostTellOfAll) {
  // The stiff ones between them are not run: only the softest and the longest are.
  TestRig rig;
  const TestRig calm = rig_of_chain({.bones = 4, .length = kLength, .damping_ratio = 1});
  for (int chain = 0; chain < 8; ++chain) {
    std::uint32_t parent = 0;
    for (int i = 1; i <= 4; ++i) {
      const DynamicsRecord& soft = calm.dynamics[std::size_t(i)];
      const float stiffer = chain == 5 ? 1 : 4;
      parent = rig.add({.parent = parent,
                        .joint = {0, 0.02f, -0.12f},
                        .rest_direction = {0, -0.8f, -0.6f},
                        .length = kLength / 4 * (chain == 2 ? 1.01f : 1),
                        .stiffness = stiffer * soft.stiffness,
                        .damping = std::sqrt(stiffer) * soft.damping,
                        .torsion = 20});
    }
  }
  const AssetContents many = rig.contents(), telling = chains_alone(many, std::vector<std::uint32_t>{2, 5});
  const auto all = tune_solver(many, budget(1), 2, unheard()), two = tune_solver(telling, budget(1), 2, unheard());
  ASSERT_TRUE(all && two);
  ASSERT_EQ(all->quality.size(), two->quality.size());
  for (std::size_t i = 0; i < all->quality.size(); ++i) {
    EXPECT_NEAR(all->quality[i].rms_error, two->quality[i].rms_error, 1e-6f);
    EXPECT_GT(all->quality[i].cost, two->quality[i].cost) << "all of them cost";
  }
}

TEST(TuneSolver, AnImpossibleBudgetIsRefusedWithBothFigures) {
  const ToolError too_accurate = refusal(budget(1e-6));
  EXPECT_EQ(too_accurate.kind, ToolError::Kind::kOverBudget);
  EXPECT_NE(too_accurate.message.find("1e-06 % of the chain's length was asked for and 0."), std::string::npos)
      << too_accurate.message;
  EXPECT_NE(too_accurate.message.find(" with 480 sub-steps a second; "), std::string::npos)
      << "sixteen in each of thirty frames: " << too_accurate.message;

  const ToolError too_cheap = refusal(budget(0, 0, 7));
  EXPECT_EQ(too_cheap.kind, ToolError::Kind::kOverBudget);
  const float least = tuned(budget(50)).cost;
  EXPECT_TRUE(too_cheap.message.starts_with("\"budget\": 7 ns per frame were allowed; the least is with " +
                                            std::to_string(int(least))))
      << too_cheap.message;

  const ToolError both = refusal(budget(0.3, 0, least));
  EXPECT_EQ(both.kind, ToolError::Kind::kOverBudget);
  EXPECT_NE(both.message.find("0.3 % "), std::string::npos) << both.message;
  EXPECT_NE(both.message.find(std::to_string(int(least)) + " ns per frame were allowed"), std::string::npos)
      << both.message;
}

TEST(TuneSolver, ABudgetMayBeOnTheFurthestFrameOrTheWorstSecond) {
  const TuningRecord by_mean = tuned(budget(0.3));
  Recipe recipe = budget(0);
  recipe.budget_max_error = 1.5;
  const auto by_most = tune_solver(calm_chain(), recipe, 1, unheard());
  ASSERT_TRUE(by_most) << by_most.error().message;
  for (const QualityRecord& row : by_most->quality) {
    const bool is_chosen = float(row.substeps) == std::ceil(by_most->tuning[0].substep_rate / row.frame_rate);
    EXPECT_TRUE(!is_chosen || row.max_error <= 0.015f) << row.max_error;
  }
  recipe.budget_max_error = 0;
  recipe.budget_worst_second = 0.3;
  EXPECT_GE(tuned(recipe).substep_rate, by_mean.substep_rate) << "no second is worse than the worst";
  recipe.budget_worst_second = 1e-6;
  EXPECT_NE(refusal(recipe).message.find("a worst second of 1e-06 % of the chain's length was asked for"),
            std::string::npos);
  recipe.budget_worst_second = 0;
  recipe.budget_max_error = 1e-6;
  EXPECT_NE(refusal(recipe).message.find("a largest error of 1e-06 %"), std::string::npos);
}

TEST(TuneSolver, WithoutABudgetNothingIsRefused) {
  AssetContents wild = rig_of_chain({.bones = 8, .length = 0.8f, .stiffness = 20}).contents();
  const auto result = tune_solver(wild, default_recipe(), 2, unheard());
  ASSERT_TRUE(result) << result.error().message;
  ASSERT_EQ(result->tuning.size(), 1u);
  EXPECT_EQ(result->tuning[0].met, 0u) << "such hair has no exact motion to be near";
  EXPECT_GT(result->tuning[0].reached_error, result->tuning[0].asked_error);
  EXPECT_TRUE(std::isfinite(result->tuning[0].reached_error));
  wild.tuning = result->tuning;
  wild.quality = result->quality;
  EXPECT_TRUE(lab::OpenedAsset(wild).asset().is_open()) << "whatever was measured, the asset is one";
}

TEST(TuneSolver, RigidHairHasNothingToTune) {
  const auto result = tune_solver(TestRig().contents(), budget(1e-6, 0, 1), 1, unheard());
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->tuning.empty());
  EXPECT_TRUE(result->quality.empty());
}

TEST(TuneSolver, TheTableHasEveryFrameRateInOrder) {
  Recipe recipe = budget(1);
  recipe.slowest_rate = 24;
  recipe.fastest_rate = 144;
  const auto result = tune_solver(calm_chain(), recipe, 1, unheard());
  ASSERT_TRUE(result);
  std::set<float> rates;
  std::vector<std::pair<float, std::uint32_t>> keys;
  for (const QualityRecord& row : result->quality) {
    rates.insert(row.frame_rate);
    keys.emplace_back(row.frame_rate, row.substeps);
    EXPECT_GE(row.max_error, row.rms_error);
    EXPECT_LT(row.stretch, 1e-5f);
    EXPECT_GT(row.cost, 0.0f);
  }
  EXPECT_EQ(rates, (std::set<float>{24, 60, 144}));
  EXPECT_TRUE(std::ranges::is_sorted(keys));
  EXPECT_EQ(std::ranges::adjacent_find(keys), keys.end()) << "each is measured once";
  EXPECT_EQ(result->tuning[0].slowest_rate, 24.0f);
  EXPECT_EQ(result->tuning[0].fastest_rate, 144.0f);
}

TEST(TuneSolver, ThreadsAndRepetitionDoNotChangeTheResult) {
  Findings first, again;
  const auto one = tune_solver(calm_chain(), budget(0.3), 1, first);
  ASSERT_TRUE(one);
  for (const unsigned threads : {1u, 2u, 7u}) {
    again = {};
    const auto other = tune_solver(calm_chain(), budget(0.3), threads, again);
    ASSERT_TRUE(other);
    EXPECT_EQ(std::memcmp(one->tuning.data(), other->tuning.data(), sizeof(TuningRecord)), 0);
    ASSERT_EQ(one->quality.size(), other->quality.size());
    EXPECT_EQ(std::memcmp(one->quality.data(), other->quality.data(), one->quality.size() * sizeof(QualityRecord)), 0);
    EXPECT_EQ(first.notes, again.notes);
  }
}

/// A passive chain whose joints are as stiff as no reference can follow in the work that a cook may take.
AssetContents hopelessly_stiff_chain() {
  AssetContents contents = rig_of_chain({.bones = 8, .length = kLength, .damping_ratio = 1}).contents();
  for (ChainRecord& chain : contents.chains) chain.model = ChainModel::kPassive;
  for (DynamicsRecord& bone : contents.dynamics) {
    bone.stiffness = 1e12f;
    bone.damping = 1e6f;
    bone.torsion = kShortestArc;
  }
  return contents;
}

TEST(TuneSolver, TakesNoMoreWorkThanACookMay) {
  std::vector<std::string> notes[2];
  for (const unsigned threads : {1u, 2u}) {
    const auto result =
        told([&](Findings& findings) { return tune_solver(hopelessly_stiff_chain(), budget(0), threads, findings); });
    ASSERT_TRUE(result.made);
    EXPECT_TRUE(result.made->tuning.empty()) << "nothing is known of it";
    ASSERT_EQ(result.warnings.size(), 1u);
    EXPECT_NE(result.warnings[0].message.find("not tuned: "), std::string::npos) << result.warnings[0].message;
    ASSERT_EQ(result.notes.size(), 1u);
    EXPECT_NE(result.notes[0].find("1 chain was not run"), std::string::npos) << result.notes[0];
    notes[threads - 1] = result.notes;
  }
  EXPECT_EQ(notes[0], notes[1]);
}

TEST(TuneSolver, StoresTheNamesOfItsMotions) {
  const auto result = tune_solver(calm_chain(), budget(1), 1, unheard());
  ASSERT_TRUE(result);
  ASSERT_EQ(result->motions.size(), 10u);
  EXPECT_STREQ(result->motions[0].name, "still");
  EXPECT_STREQ(result->motions[9].name, "lie");
  for (const QualityRecord& row : result->quality) EXPECT_LT(row.worst_motion, result->motions.size());
}

TEST(ReferenceWork, IsBoundedByMultiplesOfAFirstRun) {
  const lab::OpenedAsset opened(calm_chain());
  const lab::Rig rig = lab::rig_of(opened.asset());
  lab::ReferenceSettings settings{.sample_times = {0.5, 1.0},
                                  .steps_per_second = 360,
                                  .most_steps_per_second = 1e6,
                                  .wanted_self_difference_pct = 0};
  const double first = lab::first_run_work(rig, {}, settings);
  EXPECT_GE(first, 360.0 * double(rig.bones.size()));
  for (const double most : {0.5, 2.0, 4.0, 40.0}) {
    settings.most_work = most;
    const lab::ReferenceRun run = lab::solve_reference(rig, {}, *motion::path_of(motion::Motion::kNod), settings);
    EXPECT_LE(double(run.bone_steps), most * first + double(rig.bones.size())) << most;
    EXPECT_TRUE(run.was_cut());
    EXPECT_EQ(run.is_solved(), most > 3) << "two runs are three times the first";
    EXPECT_EQ(std::isfinite(run.places.back().x()), most > 3);
  }
}

}  // namespace coif::cook::tune_solver_test
