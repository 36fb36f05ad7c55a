#include "report/measure_stability.h"

#include "report/stress_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

namespace coif {
namespace {

const MeasuredSolver& solver(std::string_view name) { return *find_measured_solver(name); }

Stress gentle() {
  Stress stress;
  stress.about = {"gentle", ""};
  stress.rig = StressRig{.bones_per_chain = 3};
  stress.head = [](double) { return HeadPose{}; };
  stress.steps = 30;
  return stress;
}

StabilityRow run(const Stress& stress, std::string_view name) {
  const StressAsset made(*stress.rig);
  EXPECT_TRUE(made.is_open());
  return StressSubject(stress, made.asset(), sample_of(rig_of(made.asset()), kMaxBones)).run(solver(name));
}

TEST(StressCases, HaveNamesOfTheirOwnAndRigsThatTheFormatAllows) {
  std::set<std::string> names;
  for (const Stress& stress : stress_cases()) {
    EXPECT_TRUE(names.insert(stress.about.name).second) << stress.about.name;
    EXPECT_FALSE(stress.about.description.empty()) << stress.about.name;
    EXPECT_TRUE(stress.head) << stress.about.name;
    EXPECT_FALSE(stress.dt.empty()) << stress.about.name;
    const bool is_allowed = !stress.rig || StressAsset(*stress.rig).is_open();
    EXPECT_TRUE(is_allowed) << stress.about.name;
  }
  EXPECT_GT(names.size(), 40u);
}

TEST(StressRig, BranchesAsDeepAsItSays) {
  const StressAsset tree(StressRig{.chains = 1, .bones_per_chain = 15, .branching = 2});
  ASSERT_TRUE(tree.is_open());
  const Rig rig = rig_of(tree.asset());
  EXPECT_EQ(rig.tips.size(), 8u);
  EXPECT_EQ(rig.bones[14].parent, 12);
}

TEST(StressRun, GentleCaseIsOkAndSettles) {
  for (const char* name : {"coif", "thesis", "xpbd"}) {
    const StabilityRow row = run(gentle(), name);
    EXPECT_EQ(row.outcome, Outcome::kOk) << name;
    EXPECT_LT(row.max_speed, 5) << name;
    EXPECT_LT(row.settle_error_pct, 30) << name;
  }
  EXPECT_LT(run(gentle(), "coif").settle_error_pct, 0.01);
}

TEST(StressRun, RefusedStepsAreARejection) {
  for (const double bad : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    Stress stress = gentle();
    stress.dt = {1.0 / 60, bad};
    EXPECT_EQ(run(stress, "coif").outcome, Outcome::kRejected) << bad;
    EXPECT_EQ(run(stress, "implicit").outcome, Outcome::kRejected) << bad;
  }
}

TEST(StressRun, ExplodingSolverIsFound) {
  Stress stress = gentle();
  stress.dt = {0.5};
  stress.steps = 100;
  const Outcome outcome = run(stress, "mass-spring").outcome;
  EXPECT_TRUE(outcome == Outcome::kDiverged || outcome == Outcome::kNan) << name_of(outcome);
}

TEST(MeasureStability, HasARowForEveryCaseAndSolver) {
  const StressAsset hair(StressRig{.bones_per_chain = 3});
  int told = 0;
  const auto report = measure_stability(hair.asset(), {.solvers = {"tridiagonal"}}, [&told](const auto&) { ++told; });
  ASSERT_TRUE(report);
  EXPECT_EQ(report->rows.size(), report->stress_cases.size());
  EXPECT_EQ(std::size_t(told), report->rows.size());
  for (std::size_t i = 0; i < report->rows.size(); ++i) {
    EXPECT_EQ(report->rows[i].stress_case, report->stress_cases[i].name);
    EXPECT_EQ(report->rows[i].solver, "tridiagonal");
  }
}

TEST(MeasureStability, RefusesUnknownSolversAndBaldHeads) {
  const StressAsset hair(StressRig{.bones_per_chain = 3}), bald(StressRig{.chains = 0});
  EXPECT_EQ(measure_stability(hair.asset(), {.solvers = {"magic"}}, nullptr).error().kind, ToolError::Kind::kUsage);
  EXPECT_EQ(measure_stability(bald.asset(), {}, nullptr).error().kind, ToolError::Kind::kBadInput);
}

}  // namespace
}  // namespace coif
