#include "report/made_up_report.h"
#include "report/stability/measure_stability.h"
#include "report/stability/stability_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <set>

namespace coif::report::stability_test {

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
  return StressSubject(stress, made.asset(), lab::sample_of(lab::rig_of(made.asset()), kMaxBones)).run(solver(name));
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
  EXPECT_GT(names.size(), 60u);
}

TEST(StressRig, BranchesAsDeepAsItSays) {
  const StressAsset tree(StressRig{.chains = 1, .bones_per_chain = 15, .branching = 2});
  ASSERT_TRUE(tree.is_open());
  const lab::Rig rig = lab::rig_of(tree.asset());
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
  for (const double bad : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    Stress stress = gentle();
    stress.dt = {1.0 / 60, bad};
    EXPECT_EQ(run(stress, "coif").outcome, Outcome::kRejected) << bad;
    EXPECT_EQ(run(stress, "implicit").outcome, Outcome::kRejected) << bad;
  }
}

TEST(StressRun, StepsOfNoTimeAndOfHalfASecondAreTakenByTheRuntime) {
  for (const double odd : {0.0, 0.5, 1.0}) {
    Stress stress = gentle();
    stress.dt = {1.0 / 60, odd};
    EXPECT_EQ(run(stress, "coif").outcome, Outcome::kOk) << odd;
  }
}

TEST(StressRun, ExplodingSolverIsFound) {
  Stress stress = gentle();
  stress.dt = {0.5};
  stress.steps = 100;
  const Outcome outcome = run(stress, "mass-spring").outcome;
  EXPECT_TRUE(outcome == Outcome::kDiverged || outcome == Outcome::kNan) << name_of(outcome);
}

TEST(StressRun, HairThatIsHeldHangsStillInBothModels) {
  for (const Stress& stress : stress_cases()) {
    if (stress.about.description.find("and held") == std::string::npos) continue;
    for (const char* solver : {"cascade", "passive"}) {
      const StressAsset hair(
          StressRig{.bones_per_chain = 7, .bone_length = 0.06, .root_resistance = 0.01, .damping_ratio = 0.4});
      const StressSubject subject(stress, hair.asset(), lab::sample_of(lab::rig_of(hair.asset()), 64));
      const StabilityRow row = subject.run(*find_measured_solver(solver));
      EXPECT_EQ(row.outcome, Outcome::kOk) << stress.about.name << ", " << solver;
      EXPECT_LT(row.rest_speed, 0.05) << stress.about.name << ", " << solver;
      EXPECT_GT(row.max_speed, 0.1) << "it was moved";
    }
  }
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

TEST(StabilityTotals, CountOutcomesAndTakeTheWorstOfWhatEndedWell) {
  const auto totals = stability_totals(made_up_stability());
  ASSERT_EQ(totals.size(), 3u);
  using Counts = std::array<unsigned, 5>;
  EXPECT_EQ(totals[0].count, (Counts{2, 0, 0, 0, 0}));
  EXPECT_EQ(totals[1].count, (Counts{1, 1, 0, 0, 0}));
  EXPECT_EQ(totals[2].count, (Counts{0, 0, 0, 1, 1}));
  EXPECT_EQ(totals[0].stretch_max_pct, 0.25);
  EXPECT_EQ(totals[0].rest_speed, 0.02);
  EXPECT_EQ(totals[0].settle_error_pct, 0.75);
  EXPECT_EQ(totals[1].stretch_max_pct, 132);
  EXPECT_TRUE(std::isnan(totals[2].stretch_max_pct)) << "what diverged must not count among the good";
}

TEST(StabilityTotals, SummaryTellsSafeFromBroken) {
  const std::string text = stability_summary(made_up_stability());
  EXPECT_NE(text.find("2 cases of stress"), std::string::npos) << text;
  EXPECT_NE(text.find("refused the input: coif, thesis. Broke down: slow (in 2)."), std::string::npos) << text;
}

TEST(StabilityTotals, HairThatDoesNotRestIsAFailure) {
  StabilityReport report = made_up_stability();
  report.rows.front().outcome = Outcome::kRestless;
  const std::string text = stability_summary(report);
  EXPECT_NE(text.find("Broke down: " + report.rows.front().solver + " (in 1)"), std::string::npos) << text;
}

TEST(StabilityJson, HasTotalsAndWhatOutcomesMean) {
  const auto json = stability_json(made_up_heading(), made_up_stability());
  ASSERT_EQ(json["totals"].size(), 3u);
  EXPECT_EQ(json["totals"][1]["solver"], "thesis");
  EXPECT_EQ(json["totals"][1]["rejected"], 1);
  EXPECT_EQ(json["totals"][1]["stretch_max_pct"], 132);
  EXPECT_TRUE(json["totals"][2]["settle_error_pct"].is_null());
  ASSERT_EQ(json["outcomes"].size(), kOutcomes.size());
  EXPECT_EQ(json["outcomes"][4]["outcome"], "nan");
  EXPECT_NE(json["outcomes"][4]["meaning"].get<std::string>().find("disappears"), std::string::npos);
}

TEST(StabilityJson, ColoursSayHowBadOutcomesAre) {
  const auto looks = outcome_format().looks;
  EXPECT_EQ(looks.dump(), R"([{"is":"ok","look":"good"},{"is":"rejected","look":"neutral"},)"
                          R"({"is":"restless","look":"warning"},{"is":"diverged","look":"warning"},)"
                          R"({"is":"nan","look":"bad"}])");
}

TEST(StabilityText, HasALineForEachSolver) {
  const std::string text = stability_text(made_up_heading(), made_up_stability());
  EXPECT_TRUE(
      std::regex_search(text, std::regex("\n  coif +2 +0 +0 +0 +0 +0.250 +0 +<0.0001 +10.0 +0.02[0-9]* +0.750\n")))
      << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  slow +0 +0 +0 +1 +1 +- +- +- +- +- +-\n"))) << text;
}

}  // namespace coif::report::stability_test
