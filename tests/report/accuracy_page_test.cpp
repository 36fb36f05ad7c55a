#include "report/accuracy/accuracy_report.h"
#include "report/made_up_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace coif::accuracy_page_test {

const AccuracyRow& mean_of(const std::vector<AccuracyRow>& means, const std::string& solver, std::uint32_t substeps) {
  for (const AccuracyRow& mean : means) {
    if (mean.solver == solver && mean.substeps == substeps) return mean;
  }
  ADD_FAILURE() << "no " << solver;
  return means.front();
}

const PlotSeries* series_of(const Plot& plot, const std::string& name) {
  for (const PlotSeries& series : plot.series) {
    if (series.name == name) return &series;
  }
  return nullptr;
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

TEST(AccuracyPlots, RingAndJoinTheFront) {
  const Plot plot = work_precision_figure(made_up_accuracy()).plot;
  const PlotSeries* const front = series_of(plot, "Pareto front");
  ASSERT_NE(front, nullptr);
  ASSERT_EQ(front->points.size(), 3u);
  EXPECT_EQ(front->points[0].x, 25);
  EXPECT_EQ(front->points[2].x, 120);
  EXPECT_EQ(series_of(plot, "coif")->marked.size(), 2u);
  EXPECT_EQ(series_of(plot, "thesis")->marked.size(), 1u);
  EXPECT_EQ(series_of(plot, "slow")->points.size(), 2u);
}

TEST(AccuracyPlots, OverFrameRatesUseFewestSubsteps) {
  const AccuracyReport report = made_up_accuracy();
  const Plot plot = frame_rate_figure(report, "turn").plot;
  const PlotSeries* const series = series_of(plot, "coif");
  ASSERT_NE(series, nullptr);
  ASSERT_EQ(series->points.size(), 3u);
  EXPECT_EQ(series->points[0].x, 30);
  EXPECT_DOUBLE_EQ(series->points[0].y, 2);
  EXPECT_EQ(plot.x_ticks, (std::vector<double>{30, 60, 120}));
  const Plot stretch = stretch_figure(report).plot;
  EXPECT_DOUBLE_EQ(series_of(stretch, "thesis")->points[0].y, 120);
}

TEST(AccuracyPlots, ShowTheRuntimeAndTheBestOthersOnly) {
  AccuracyReport report = made_up_accuracy();
  for (const char* name : {"worst", "better", "best"}) {
    AccuracyRow row = report.rows[0];
    row.fps = 60;
    row.solver = name;
    row.rms_error_pct = std::string(name) == "best" ? 0.1 : std::string(name) == "better" ? 0.2 : 99;
    report.rows.push_back(row);
  }
  std::vector<std::string> names;
  for (const PlotSeries& series : frame_rate_figure(report, "nod").plot.series) names.push_back(series.name);
  EXPECT_EQ(names, (std::vector<std::string>{"coif", "thesis", "best", "better"}));
}

TEST(AccuracyPlots, PointsOffTheScaleAreLeftOutAndSaidSo) {
  AccuracyReport report = made_up_accuracy();
  EXPECT_EQ(stretch_figure(report).caption.find("left out"), std::string::npos);
  report.rows[0].stretch_max_pct = 1.0e9;
  const Figure figure = stretch_figure(report);
  EXPECT_NE(figure.caption.find("above 1000 % are left out"), std::string::npos);
  EXPECT_EQ(series_of(figure.plot, "coif")->points.size(), 2u);
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

TEST(AccuracyPage, HasAllPartsAndUniqueIds) {
  const std::string page = accuracy_page(made_up_heading(), made_up_accuracy());
  EXPECT_NE(page.find("bob &lt;b&gt;.coif"), std::string::npos);
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_EQ(count_of(page, "<figure>"), 5u)
      << "work and precision, the same by its own model, one for each motion, one of the stretch";
  EXPECT_GT(expect_unique_ids(page), 8u);
}

TEST(AccuracyPage, EmptyReportIsShown) {
  const std::string page = accuracy_page({}, {});
  EXPECT_NE(page.find("no data"), std::string::npos);
  EXPECT_NE(page.find("No setting was chosen"), std::string::npos);
}

TEST(AccuracyTables, ShowADashForWhatDoesNotExist) {
  AccuracyReport report;
  report.rows.resize(1);
  report.spread.push_back({"nod", "coif"});
  report.reference.resize(1);
  report.settle.resize(1);
  report.rows[0].fps = 60;
  for (const Table& table :
       {settings_table(report), spread_table(report), page_table(reference_columns(2), report.reference),
        page_table(settle_columns(2), report.settle), page_table(accuracy_columns(2), report.rows)}) {
    ASSERT_EQ(table.rows.size(), 1u);
    EXPECT_EQ(table.rows[0].size(), table.columns.size());
    std::size_t dashes = 0;
    for (const Cell& cell : table.rows[0]) dashes += cell.text == "-";
    EXPECT_GE(dashes, 1u) << table.columns.back().title;
  }
}

TEST(AccuracyTables, ColorsCompareWithTheBudget) {
  const Table table = settings_table(made_up_accuracy());
  // coif 1 %, 0.25 %; thesis 30 %, 7.5 %; slow 2 %, 0.5 %, against 2 %.
  const CellLook looks[] = {CellLook::kGood,    CellLook::kGood, CellLook::kBad,
                            CellLook::kWarning, CellLook::kGood, CellLook::kGood};
  ASSERT_EQ(table.rows.size(), std::size(looks));
  for (std::size_t i = 0; i < std::size(looks); ++i) EXPECT_EQ(table.rows[i][4].look, looks[i]) << i;
}

TEST(AccuracyText, ShowsTheFrontAndTheBestOfEachSolver) {
  const std::string text = accuracy_text(made_up_heading(), made_up_accuracy());
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  coif +1 +30.0 +1.00 .*\\*\n"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  slow +4 +1200 +0.500 .*\n"))) << text;
  EXPECT_FALSE(std::regex_search(text, std::regex("\n  slow +1 "))) << text;
  EXPECT_NE(text.find("over 2 motions"), std::string::npos);
  EXPECT_NE(text.find("cheapest setting"), std::string::npos);
}

}  // namespace coif::accuracy_page_test
