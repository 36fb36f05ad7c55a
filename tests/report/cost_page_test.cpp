#include "base/text.h"
#include "report/cost/cost_report.h"
#include "report/made_up_report.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace coif::cost_page_test {

using nlohmann::ordered_json;
CostReport rigid_report() {
  CostReport report;
  report.asset = made_up_cost().asset;
  report.rendering.note = "no device";
  return report;
}

TEST(CostJson, HasTheDocumentedKeysAndTypes) {
  const ordered_json json = cost_json(made_up_heading(), made_up_cost());
  EXPECT_EQ(json["asset"], "bob <b>.coif");
  EXPECT_EQ(json["instruction_set"], "AVX9");
  EXPECT_EQ(keys_of(json["simulation"][0]), (Keys{"heads", "solver", "substeps", "us_per_frame", "ns_per_bone_frame",
                                                  "spread_pct", "bytes", "bytes_per_head"}));
  EXPECT_EQ(keys_of(json["features"][0]),
            (Keys{"feature", "description", "heads", "us_per_frame", "ns_per_bone_frame", "spread_pct", "change_pct"}));
  EXPECT_EQ(keys_of(json["left_out"][0]), (Keys{"heads", "what", "why"}));
  EXPECT_EQ(keys_of(json["memory"]), (Keys{"bytes_per_head", "bytes_shared"}));
  EXPECT_EQ(keys_of(json["file"]), (Keys{"bytes", "chunks", "framing_bytes"}));
  EXPECT_EQ(keys_of(json["file"]["chunks"][0]), (Keys{"id", "what", "bytes", "use"}));
  EXPECT_TRUE(json["simulation"][0]["heads"].is_number_unsigned());
  EXPECT_EQ(json["file"]["chunks"][1]["use"], "drawing");
  EXPECT_TRUE(json["rendering_note"].is_null());
}

TEST(CostJson, HoldsEveryRow) {
  const CostReport report = made_up_cost();
  const ordered_json json = cost_json(made_up_heading(), report);
  ASSERT_EQ(json["simulation"].size(), report.simulation.size());
  for (std::size_t i = 0; i < report.simulation.size(); ++i) {
    EXPECT_EQ(json["simulation"][i]["us_per_frame"], report.simulation[i].us_per_frame);
    EXPECT_EQ(json["simulation"][i]["bytes"], report.simulation[i].bytes);
  }
  EXPECT_EQ(json["rendering"].size(), report.rendering.rows.size());
}

TEST(CostJson, WithoutADeviceRenderingIsEmptyAndSaysWhy) {
  const ordered_json json = cost_json(made_up_heading(), rigid_report());
  EXPECT_TRUE(json["rendering"].is_array());
  EXPECT_TRUE(json["rendering"].empty());
  EXPECT_EQ(json["rendering_note"], "no device");
  EXPECT_TRUE(json["simulation"].empty());
}

TEST(CostRows, SeparateCrowdsFromSubsteps) {
  const CostReport report = made_up_cost();
  EXPECT_EQ(names_of(report.simulation, &SimulationCostRow::solver), (Keys{"coif", "thesis"}));
  std::vector<std::uint32_t> heads, substeps;
  for (const SimulationCostRow& row : scaling_of(report, "coif")) heads.push_back(row.heads);
  for (const SimulationCostRow& row : substeps_of(report, "thesis")) substeps.push_back(row.substeps);
  EXPECT_EQ(heads, (std::vector<std::uint32_t>{1, 10, 100}));
  EXPECT_EQ(substeps, (std::vector<std::uint32_t>{1, 2, 4}));
  EXPECT_EQ(drawings_of(report, "opaque", true).size(), 2u);
}

TEST(CostRows, UnitsNeedFewDigits) {
  EXPECT_EQ(time_text(840), "840 ns");
  EXPECT_EQ(time_text(12345), "12.3 us");
  EXPECT_EQ(time_text(4.567e6), "4.57 ms");
  EXPECT_EQ(time_text(4.2e12), "4200 s");
  EXPECT_EQ(bytes_text(12), "12.0 bytes");
  EXPECT_EQ(bytes_text(1.5e6), "1.50 MB");
}

TEST(CostPlots, ScalingIsDoublyLogarithmic) {
  const Plot time = crowd_time_figure(made_up_cost()).plot;
  EXPECT_TRUE(time.log_x && time.log_y);
  ASSERT_EQ(time.series.size(), 2u);
  ASSERT_EQ(time.series[0].points.size(), 3u);
  EXPECT_EQ(time.series[0].points[2].x, 100);
  EXPECT_EQ(time.series[0].points[2].y, 200);
}

TEST(CostPlots, SubstepsAreOfOneHead) {
  const Plot plot = substeps_figure(made_up_cost()).plot;
  EXPECT_EQ(plot.series[1].points[2].x, 4);
  EXPECT_EQ(plot.series[1].points[2].y, 4);
  const Plot bone = bone_time_figure(made_up_cost()).plot;
  EXPECT_EQ(bone.series[0].points[0].y, 200);
}

TEST(CostTables, RowsHaveAsManyCellsAsThereAreColumns) {
  const CostReport report = made_up_cost();
  for (const Table& table :
       {page_table(simulation_columns(), report.simulation), page_table(memory_columns(), report.simulation),
        page_table(feature_columns(), report.features), page_table(chunk_columns(1000), report.asset.chunks)}) {
    EXPECT_FALSE(table.rows.empty());
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.columns[0].title;
  }
}

TEST(CostTables, UnsteadyTimesStandOut) {
  const Table table = page_table(feature_columns(), made_up_cost().features);
  EXPECT_EQ(table.rows[0][3].look, CellLook::kPlain);
  EXPECT_EQ(table.rows[1][3].look, CellLook::kWarning);
  EXPECT_EQ(table.rows[1][5].text, "-25 %");
}

TEST(CostSummary, SaysWhatOneHeadAndACrowdCost) {
  const std::string text = cost_summary(made_up_cost());
  EXPECT_NE(text.find("Simulating one head takes 2.00 us of one core a frame (coif with 1 step, 200 ns a bone)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("100 heads take 200 us"), std::string::npos) << text;
  EXPECT_NE(text.find("Each head of a large crowd takes 500 bytes"), std::string::npos) << text;
  EXPECT_NE(text.find("Drawing one head at 64 x 48 takes 500 us, 10 heads 5.00 ms, on made-up device."),
            std::string::npos)
      << text;
}

TEST(CostSummary, NamesOnceWhatWasLeftOut) {
  EXPECT_EQ(left_out_text(made_up_cost(), kDrawnCrowd),
            "Not measured: drawing of 100, 1000 heads; one frame takes too long. More --time takes in more.");
  EXPECT_EQ(left_out_text(made_up_cost(), "coif"), "");
}

TEST(CostSummary, RigidHairCostsNothing) {
  EXPECT_EQ(cost_summary(rigid_report()), "The hair is rigid: simulating it costs nothing.");
}

TEST(CostPage, HasAllParts) {
  const std::string page = cost_page(made_up_heading(), made_up_cost());
  for (const char* part : {"bob &lt;b&gt;.coif", "not with those of another machine", "AVX9", "no-colliders",
                           "made-up device", "Not measured: drawing of 100, 1000 heads", "texels"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(count_of(page, "<figure>"), 5u);
}

TEST(CostPage, RigidHairWithoutADeviceStillHasItsBytes) {
  const std::string page = cost_page(made_up_heading(), rigid_report());
  EXPECT_NE(page.find("Nothing was drawn: no device."), std::string::npos);
  EXPECT_NE(page.find("texels"), std::string::npos);
  EXPECT_EQ(page.find("<figure>"), std::string::npos);
}

TEST(CostText, HasALineForEveryRow) {
  const std::string text = cost_text(made_up_heading(), made_up_cost());
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  coif +1 +100 +200 +2.00 +200 +4.00 %\n"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  no-colliders +15.0 +1.50 +-25 % +60.0 %\n"))) << text;
  EXPECT_NE(cost_text(made_up_heading(), rigid_report()).find("not drawn: no device"), std::string::npos);
}

CostReport report_with_thesis_table() {
  CostReport report = made_up_cost();
  report.rendering.thesis_table = made_up_thesis_table();
  return report;
}

bool has_column(const Table& table, const std::string& title) {
  return std::ranges::find(table.columns, title, &Column::title) != table.columns.end();
}

TEST(DrawingJson, HasTheDocumentedKeysAndTypes) {
  const ordered_json json = cost_json(made_up_heading(), report_with_thesis_table());
  EXPECT_EQ(keys_of(json["rendering"][0]),
            (Keys{"heads", "transparency", "samples", "lod", "simulation", "strand_terms", "triangles", "ms_per_frame",
                  "spread_pct", "gpu_ms_per_frame", "device"}));
  EXPECT_TRUE(json["rendering"][0]["simulation"].is_boolean());
  EXPECT_TRUE(json["rendering"][0]["transparency"].is_string());
  EXPECT_EQ(json["rendering"][8]["device"], "made-up device");
  EXPECT_EQ(keys_of(json["distances"][0]),
            (Keys{"heads", "times_as_far", "screen_share", "lod", "triangles_per_head", "covered_pixels_per_head",
                  "ms_per_head", "spread_pct", "gpu_ms_per_head", "finest_ms_per_head", "saved_pct"}));
  EXPECT_EQ(json["distances"][1]["saved_pct"], 75);
  EXPECT_EQ(keys_of(json["table_1"][0]), (Keys{"heads", "transparency", "simulation", "ms_per_frame", "spread_pct",
                                               "step_ms", "gpu_ms_per_frame", "fps", "thesis_fps", "device"}));
  EXPECT_EQ(keys_of(json["table_1_ratios"][0]), (Keys{"heads", "transparency_on_off", "thesis_transparency_on_off",
                                                      "simulation_on_off", "thesis_simulation_on_off"}));
  EXPECT_EQ(json["table_1"][1]["transparency"], "opaque");
  EXPECT_EQ(json["table_1"][1]["simulation"], true);
}

TEST(DrawingJson, WhatTheDeviceDoesNotTellIsNull) {
  const ordered_json json = cost_json(made_up_heading(), report_with_thesis_table());
  EXPECT_TRUE(json["rendering"][0]["gpu_ms_per_frame"].is_null());
  EXPECT_EQ(json["rendering"][8]["gpu_ms_per_frame"], 0.125);
  EXPECT_TRUE(json["table_1"][0]["gpu_ms_per_frame"].is_null());
  EXPECT_TRUE(json["distances"][0]["gpu_ms_per_head"].is_null());
}

TEST(DrawingJson, WithoutTheThesisTableItIsEmpty) {
  const ordered_json json = cost_json(made_up_heading(), made_up_cost());
  EXPECT_TRUE(json["table_1"].is_array());
  EXPECT_TRUE(json["table_1"].empty());
  EXPECT_TRUE(json["table_1_ratios"].empty());
}

TEST(ThesisTable, RowsStandBesideWhatWasPublished) {
  const ordered_json rows = cost_json(made_up_heading(), report_with_thesis_table())["table_1"];
  ASSERT_EQ(rows.size(), 8u);
  EXPECT_EQ(rows[0]["heads"], 20);
  EXPECT_EQ(rows[0]["ms_per_frame"], 90);
  EXPECT_NEAR(rows[0]["fps"].get<double>(), 1000.0 / 90, 1e-9);
  EXPECT_EQ(rows[0]["thesis_fps"], 53);
  EXPECT_EQ(rows[1]["thesis_fps"], 58) << "opaque";
  EXPECT_EQ(rows[3]["thesis_fps"], 58) << "simulation makes no difference there";
  EXPECT_TRUE(rows[4]["thesis_fps"].is_null()) << "seven heads it did not measure";
}

TEST(ThesisTable, RatiosAreOfFramesThatDifferInNothingElse) {
  const auto ratios = ratios_of(made_up_thesis_table());
  ASSERT_EQ(ratios.size(), 2u);
  for (const ThesisTableRatio& ratio : ratios) {
    EXPECT_DOUBLE_EQ(ratio.transparency_on_off, 1.5);
    EXPECT_DOUBLE_EQ(ratio.simulation_on_off, 1.5);
  }
  EXPECT_NEAR(ratios[0].published_transparency.value(), 58.0 / 53, 1e-9);
  EXPECT_EQ(ratios[0].published_simulation, 1);
  EXPECT_EQ(ratios[1].published_transparency, std::nullopt);
}

TEST(ThesisTable, SimulationIsComparedInTheSameFrames) {
  ThesisTable table = made_up_thesis_table();
  for (ThesisTableRow& row : table.rows) {
    if (!row.simulation) row.ms_per_frame *= 2;  // held up by something else
  }
  for (const ThesisTableRatio& ratio : ratios_of(table)) EXPECT_DOUBLE_EQ(ratio.simulation_on_off, 1.5);
}

TEST(ThesisTable, ACrowdWithAWayMissingHasNoRatio) {
  ThesisTable table = made_up_thesis_table();
  table.rows.erase(table.rows.begin() + 1);
  const auto ratios = ratios_of(table);
  ASSERT_EQ(ratios.size(), 1u);
  EXPECT_EQ(ratios[0].heads, 7u);
}

template <typename Row>
void expect_full_rows(const Columns<Row>& columns, const std::vector<Row>& records) {
  const Table table = page_table(columns, records);
  EXPECT_FALSE(table.rows.empty());
  for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.columns[0].title;
}

TEST(DrawingTables, RowsHaveAsManyCellsAsThereAreColumns) {
  const RenderingCost rendering = report_with_thesis_table().rendering;
  const auto& thesis = rendering.thesis_table;
  expect_full_rows(rendering_columns("", rendering.rows), rendering.rows);
  expect_full_rows(cost_distance_columns(rendering.distances), rendering.distances);
  expect_full_rows(thesis_columns("", thesis.rows), thesis.rows);
  expect_full_rows(ratio_columns(), ratios_of(thesis));
}

TEST(DrawingTables, TheDeviceHasAColumnWhereItTellsItsTime) {
  const auto rows = made_up_cost().rendering.rows;
  const Table table = page_table(rendering_columns("", rows), rows);
  EXPECT_TRUE(has_column(table, "on the device"));
  EXPECT_EQ(table.rows[0].back().text, "not measured");
  EXPECT_EQ(table.rows[8].back().text, "125 us");
  const auto thesis = made_up_thesis_table().rows;
  EXPECT_FALSE(has_column(page_table(thesis_columns("", thesis), thesis), "on the device"));
}

TEST(DrawingPlots, DrawingIsDoublyLogarithmic) {
  const Plot plot = drawing_figure(made_up_cost()).plot;
  EXPECT_TRUE(plot.log_x && plot.log_y);
  ASSERT_EQ(plot.series.size(), 4u);
  for (const PlotSeries& series : plot.series) EXPECT_EQ(series.points.size(), 2u) << series.name;
}

TEST(DrawingPlots, ThesisStandsBesideWhatWasMeasured) {
  const Plot plot = thesis_table_figure(made_up_thesis_table()).plot;
  ASSERT_EQ(plot.series.size(), 4u);
  EXPECT_EQ(plot.series[0].points.size(), 2u);
  ASSERT_EQ(plot.series[2].points.size(), 4u);
  EXPECT_EQ(plot.series[2].points[3].y, 7);
  EXPECT_EQ(plot.series[3].points[3].y, 8);
}

TEST(DrawingPlots, DistancesShowBothLevels) {
  const Plot plot = distances_figure(made_up_cost().rendering).plot;
  ASSERT_EQ(plot.series.size(), 2u);
  EXPECT_EQ(plot.series[0].points[1].y, 4);
  EXPECT_EQ(plot.series[1].points[1].y, 1);
  EXPECT_EQ(plot.series[1].points[1].x, 20);
}

TEST(DrawingPage, NamesTheThesisTablesDeviceAndWhatWasMeasuredHere) {
  const std::string page = cost_page(made_up_heading(), report_with_thesis_table());
  for (const char* part : {"Table 1 of the thesis", kThesisTableDevice, "Here: made-up device, 64 x 48",
                           "thesis: frames a second", "What does distance spare?"}) {
    EXPECT_NE(page.find(part), std::string::npos) << part;
  }
}

TEST(DrawingPage, SaysThatTheDeviceDoesNotTellItsTime) {
  CostReport report = made_up_cost();
  report.rendering.rows.pop_back();
  report.rendering.device = "llvmpipe (made up)";
  const std::string page = cost_page(made_up_heading(), report);
  EXPECT_NE(page.find("Time on the device itself: not measured"), std::string::npos);
  EXPECT_NE(page.find("draws on the processor, not on a graphics card"), std::string::npos);
  EXPECT_EQ(page.find("Table 1 of the thesis"), std::string::npos) << "nobody asked for it";
}

TEST(DrawingPage, SaysWhichCrowdsAreMissing) {
  CostReport report = made_up_cost();
  report.left_out.push_back({200, kThesisTable, "one frame takes a minute"});
  report.left_out.push_back({512, kDistances, "one frame takes an hour"});
  const std::string page = cost_page(made_up_heading(), report);
  EXPECT_NE(page.find("Not measured: Table 1 of 200 heads; one frame takes a minute."), std::string::npos);
  EXPECT_NE(page.find("Not measured: distance of 512 heads; one frame takes an hour. More --time takes in more."),
            std::string::npos);
}

TEST(DrawingSummary, SaysWhatTransparencyAndSimulationCost) {
  const std::string text = cost_summary(report_with_thesis_table());
  EXPECT_NE(text.find("frames with transparency take 1.50 times as long as without (there 1.09 to 1.14"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("frames with simulation 1.500 times (there 1)"), std::string::npos) << text;
  EXPECT_EQ(cost_summary(made_up_cost()).find("thesis:"), std::string::npos);
}

TEST(DrawingText, HasALineForEveryRow) {
  const std::string text = cost_text(made_up_heading(), report_with_thesis_table());
  for (const char* line :
       {"\n  blend +1 +4 +1 +no +no +100 +0.250 +2.00 % +0.125\n",
        "\n  blend +10 +1 +0 +yes +no +3000 +5.00 +40.0 % +not measured\n",
        "\n  20.0 % +10 +40.0 +1 +100 +1.00 +4.00 +75 %\n",
        "\n +20 +yes +yes +90.0 +2.00 % +30.0 +not measured +11.1 +53\n",
        "\n +7 +no +no +14.0 +2.00 % +0 +not measured +71.4 +-\n",
        "\n +20 heads: with transparency 1.50 times as long \\(thesis 1.09\\), with simulation 1.500 "
        "times \\(thesis 1.00\\)\n"}) {
    EXPECT_TRUE(std::regex_search(text, std::regex(line))) << line << text;
  }
}

}  // namespace coif::cost_page_test
