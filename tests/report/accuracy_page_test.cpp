#include "report/accuracy/accuracy_report.h"
#include "report/made_up_report.h"
#include "report/page/report_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>

namespace coif::report::accuracy_page_test {

const AccuracyRow& mean_of(const std::vector<AccuracyRow>& means, const std::string& solver, std::uint32_t substeps) {
  for (const AccuracyRow& mean : means) {
    if (mean.solver == solver && mean.substeps == substeps) return mean;
  }
  ADD_FAILURE() << "no " << solver;
  return means.front();
}

TEST(AccuracyMeans, AreOverMotionsAtTheRateNextToSixty) {
  AccuracyReport report = made_up_accuracy();
  EXPECT_EQ(main_frame_rate(report), 60);
  for (AccuracyRow& row : report.rows) {
    if (row.solver == "coif" && row.motion == "turn") row.rms_error_pct *= 7;
  }
  const auto means = means_over_motions(report, 60);
  EXPECT_EQ(means.size(), 6u);
  EXPECT_NEAR(mean_of(means, "coif", 1).rms_error_pct, std::sqrt((1.0 + 49.0) / 2), 1.0e-12);
  EXPECT_NEAR(mean_of(means, "coif", 1).ns_per_bone_frame, 30, 1.0e-12);
  EXPECT_NEAR(mean_of(means, "thesis", 4).stretch_max_pct, 60, 1.0e-12);
}

TEST(AccuracyMeans, LeaveOutMotionsInWhichLittleHappens) {
  AccuracyReport report = made_up_accuracy();
  const double before = mean_of(means_over_motions(report, 60), "coif", 1).rms_error_pct;
  for (const char* motion : {"still", "teleport"}) {
    AccuracyRow row = report.rows[0];
    row.fps = 60;
    row.motion = motion;
    row.rms_error_pct = 0;
    report.rows.push_back(row);
  }
  EXPECT_EQ(mean_of(means_over_motions(report, 60), "coif", 1).rms_error_pct, before) << "or quiet motions flatter";
  std::erase_if(report.rows, [](const AccuracyRow& row) { return row.motion != "still"; });
  ASSERT_EQ(means_over_motions(report, 60).size(), 1u) << "unless there are no others";
}

TEST(AccuracyMeans, TellWhatTheErrorIsOfTheMotion) {
  AccuracyReport report = made_up_accuracy();
  for (AccuracyRow& row : report.rows)
    row.of_motion_pct = row.rms_error_pct / 0.4;  // hair that moves by 40 % of its length
  const AccuracyRow mean = mean_of(means_over_motions(report, 60), "thesis", 1);
  EXPECT_NEAR(mean.of_motion_pct, mean.rms_error_pct / 0.4, 1e-9);
}

TEST(AccuracyMeans, FrontHoldsWhatNothingBeats) {
  const auto means = means_over_motions(made_up_accuracy(), 60);
  // 25 ns 30 %; 30 ns 1 %; 120 ns 0.25 %; "thesis x4" (100 ns, 7.5 %) and "slow" are beaten by coif.
  EXPECT_TRUE(mean_of(means, "coif", 1).pareto);
  EXPECT_TRUE(mean_of(means, "coif", 4).pareto);
  EXPECT_TRUE(mean_of(means, "thesis", 1).pareto);
  EXPECT_FALSE(mean_of(means, "thesis", 4).pareto);
  EXPECT_FALSE(mean_of(means, "slow", 1).pareto);
  EXPECT_FALSE(mean_of(means, "slow", 4).pareto);
}

TEST(AccuracyMeans, ACostThatFallsWithMoreStepsIsMarked) {
  AccuracyReport report = made_up_accuracy();
  for (const AccuracyRow& mean : means_over_motions(report, 60)) EXPECT_FALSE(mean.cost_falls) << mean.solver;
  for (AccuracyRow& row : report.rows) {
    if (row.solver == "coif" && row.substeps == 4) row.ns_per_bone_frame = 20;  // one step takes 30
  }
  for (const AccuracyRow& mean : means_over_motions(report, 60)) {
    EXPECT_EQ(mean.cost_falls, mean.solver == "coif" && mean.substeps == 4) << mean.solver << " x" << mean.substeps;
  }
  for (AccuracyRow& row : report.rows) {
    if (row.solver == "coif" && row.substeps == 4) row.ns_per_bone_frame = 29;  // within what clocks are worth
  }
  EXPECT_FALSE(mean_of(means_over_motions(report, 60), "coif", 4).cost_falls);
}

TEST(AccuracyMeans, OneFailureIsNotAveragedAway) {
  AccuracyReport report = made_up_accuracy();
  report.rows.front().fps = 60;
  report.rows.front().rms_error_pct = kNoNumber;
  const auto means = means_over_motions(report, 60);
  EXPECT_TRUE(std::isnan(mean_of(means, "coif", 1).rms_error_pct));
  EXPECT_FALSE(mean_of(means, "coif", 1).pareto);
}

TEST(AccuracyJson, MeansSayWhatIsOnTheFront) {
  const auto json = accuracy_json(made_up_heading(), made_up_accuracy());
  EXPECT_EQ(json["main_fps"], 60);
  Keys front;
  for (const auto& mean : json["means"]) {
    if (mean["pareto"] == true) front.push_back(mean["setting"]);
  }
  EXPECT_EQ(front, (Keys{"coif", "coif x4", "thesis"}));
}

TEST(AccuracyJson, TellsWhichRowsHaveTheFewestSteps) {
  const auto json = accuracy_json(made_up_heading(), made_up_accuracy());
  for (const auto& row : json["rows"]) EXPECT_EQ(row["fewest_steps"], row["substeps"] == 1) << row;
  for (const auto& mean : json["means"]) EXPECT_EQ(mean["fewest_steps"], mean["substeps"] == 1) << mean;
}

TEST(AccuracyJson, ShowsTheRuntimeAndTheBestOthersFirst) {
  AccuracyReport report = made_up_accuracy();
  for (const char* name : {"worst", "better", "best"}) {
    AccuracyRow row = report.rows[0];
    row.fps = 60;
    row.solver = name;
    row.rms_error_pct = std::string(name) == "best" ? 0.1 : std::string(name) == "better" ? 0.2 : 99;
    report.rows.push_back(row);
  }
  std::set<std::string> shown;
  const auto json = accuracy_json(made_up_heading(), report);
  for (const auto& row : json["rows"]) {
    if (row["shown_first"] == true) shown.insert(row["solver"]);
  }
  EXPECT_EQ(shown, (std::set<std::string>{"coif", "thesis", "best", "better"}));
}

TEST(AccuracyJson, TheSwingIsInMillimetresForTwoSecondsAndAHalf) {
  AccuracyReport report = made_up_accuracy();
  report.swings.longest = {"fringe", 1.0, {0.5, -0.25, kNoNumber, 1}, {0.5, 0.25, 0, 1}};
  const auto json = accuracy_json(made_up_heading(), report);
  EXPECT_EQ(json["swing_chain"], "fringe");
  ASSERT_EQ(json["swing_path"].size(), 3u);
  EXPECT_EQ(json["swing_path"][1].dump(), R"({"seconds":2.0,"behind_mm":-250.0,"artist_behind_mm":250.0})");
  EXPECT_TRUE(json["swing_path"][2]["behind_mm"].is_null());
}

TEST(AccuracySummary, NamesTheChoiceAndItsPrice) {
  const std::string text = accuracy_summary(made_up_accuracy());
  EXPECT_NE(text.find("within 2 % of the exact motion is coif with one step a frame"), std::string::npos) << text;
  EXPECT_NE(text.find("for 30.0 ns a bone"), std::string::npos) << text;
  EXPECT_NE(text.find("as published in 2011 is 30.0 % away"), std::string::npos) << text;
}

TEST(AccuracySummary, SaysThatNothingMeetsTheBudget) {
  AccuracyReport report = made_up_accuracy();
  report.chosen.reset();
  const std::string text = accuracy_summary(report);
  EXPECT_NE(text.find("No setting stays within 2 %"), std::string::npos) << text;
  EXPECT_NE(text.find("least wrong at 60 frames per second is coif with 4 sub-steps"), std::string::npos) << text;
}

TEST(AccuracySummary, WarnsOfAReferenceThatDoesNotKnowItself) {
  AccuracyReport report = made_up_accuracy();
  EXPECT_NE(reference_summary(report).find("agrees with itself to 0.250 %"), std::string::npos);
  for (const double bad : {8.0, kNoNumber}) {
    report.reference[1].self_difference_pct = bad;
    EXPECT_NE(reference_summary(report).find("in turn it does not agree with itself"), std::string::npos) << bad;
  }
}

TEST(AccuracyPage, AnEmptyReportSaysSo) {
  const std::string page = page_html(accuracy_json({}, {}), coif_accuracy_page);
  EXPECT_NE(page.find("No setting was chosen"), std::string::npos);
}

TEST(AccuracyTables, ColorsCompareWithTheBudget) {
  const auto columns = accuracy_json(made_up_heading(), made_up_accuracy())["columns"];
  for (const char* list : {"rows", "means"}) {
    const auto error = std::ranges::find_if(columns[list], [](const auto& c) { return c["key"] == "rms_error_pct"; });
    ASSERT_NE(error, columns[list].end());
    EXPECT_EQ((*error)["looks"].dump(),
              R"([{"most":2.0,"look":"good"},{"most":20.0,"look":"warning"},{"look":"bad"}])");
  }
  EXPECT_TRUE(against_budget(kNoNumber).looks.is_null()) << "without a budget nothing is coloured";
}

TEST(AccuracyText, ShowsTheFrontAndTheBestOfEachSolver) {
  const std::string text = accuracy_text(made_up_heading(), made_up_accuracy());
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  coif +1 +30.0 +1.00 .*\\*\n"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  slow +4 +1200 +0.500 .*\n"))) << text;
  EXPECT_FALSE(std::regex_search(text, std::regex("\n  slow +1 "))) << text;
  EXPECT_NE(text.find("over 2 motions"), std::string::npos);
  EXPECT_NE(text.find("cheapest setting"), std::string::npos);
}

}  // namespace coif::report::accuracy_page_test
