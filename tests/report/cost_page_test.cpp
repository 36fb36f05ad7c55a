#include "base/text.h"
#include "report/cost/cost_report.h"
#include "report/made_up_report.h"
#include "report/page/report_page.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

namespace coif::report::cost_page_test {

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
  EXPECT_EQ(keys_of(json["simulation"][0]),
            (Keys{"heads", "solver", "substeps", "us_per_frame", "us_per_head", "ns_per_bone_frame", "spread_pct",
                  "bytes", "bytes_per_head", "heads_in_1_ms", "usual_steps", "usual_heads"}));
  EXPECT_EQ(keys_of(json["features"][0]), (Keys{"feature", "description", "heads", "us_per_frame", "us_per_head",
                                                "ns_per_bone_frame", "spread_pct", "change_pct"}));
  EXPECT_EQ(keys_of(json["left_out"][0]), (Keys{"heads", "what", "why"}));
  EXPECT_EQ(keys_of(json["memory"]), (Keys{"bytes_per_head", "bytes_shared"}));
  EXPECT_EQ(keys_of(json["file"]), (Keys{"bytes", "chunks", "framing_bytes", "drawing_bytes", "other_bytes"}));
  EXPECT_EQ(keys_of(json["file"]["chunks"][0]), (Keys{"id", "what", "bytes", "share_pct", "use"}));
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

TEST(CostJson, RowsSayWhichComparisonTheyBelongTo) {
  const ordered_json rows = cost_json(made_up_heading(), made_up_cost())["simulation"];
  std::vector<int> scaling, substeps;
  for (const auto& row : rows) {
    if (row["solver"] != "coif") continue;
    if (row["usual_steps"] == true) scaling.push_back(row["heads"]);
    if (row["usual_heads"] == true) substeps.push_back(row["substeps"]);
  }
  EXPECT_EQ(scaling, (std::vector<int>{1, 10, 100}));
  EXPECT_EQ(substeps, (std::vector<int>{1, 2, 4}));
  EXPECT_EQ(rows[2]["us_per_head"], 2);
  EXPECT_EQ(rows[2]["heads_in_1_ms"], 500);
}

TEST(CostJson, PartsAddUpToTheFile) {
  const ordered_json json = cost_json(made_up_heading(), made_up_cost());
  ASSERT_EQ(json["file_parts"].size(), 4u) << "two chunks, what is between them, the whole";
  EXPECT_EQ(json["file_parts"][0]["share_pct"], 48);
  EXPECT_EQ(json["file_parts"][3]["bytes"], 1000);
  EXPECT_EQ(json["file_parts"][3]["use"], "") << "a sum is for nothing";
  EXPECT_EQ(json["file"]["drawing_bytes"], 400);
  EXPECT_EQ(json["file"]["other_bytes"], 600);
  EXPECT_EQ(json["memory_of_crowds"].size(), 3u);
}

TEST(CostJson, UnsteadyTimesStandOut) {
  const ordered_json columns = cost_json(made_up_heading(), made_up_cost())["columns"];
  for (const char* list : {"simulation", "features", "rendering", "distances", "table_1"}) {
    const auto spread = std::ranges::find_if(columns[list], [](const auto& c) { return c["key"] == "spread_pct"; });
    ASSERT_NE(spread, columns[list].end()) << list;
    EXPECT_EQ((*spread)["looks"], half_spread().looks) << list;
  }
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

TEST(CostJson, NotesNameWhatWasLeftOut) {
  const ordered_json notes = cost_json(made_up_heading(), made_up_cost())["notes"];
  ASSERT_EQ(notes["left_out"].size(), 1u);
  EXPECT_EQ(notes["left_out"][0]["about"], "drawing");
  EXPECT_EQ(notes["left_out"][0]["text"], left_out_text(made_up_cost(), kDrawnCrowd));
}

TEST(CostPage, RigidHairWithoutADeviceStillHasItsBytes) {
  const ordered_json json = cost_json(made_up_heading(), rigid_report());
  EXPECT_EQ(json["rendering_note"], "no device");
  EXPECT_EQ(json["file_parts"][1]["what"], "texels");
  EXPECT_TRUE(json["memory_of_crowds"].empty());
  EXPECT_NE(page_html(json, coif_cost_page).find("Nothing was drawn: {rendering_note}."), std::string::npos);
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

bool has_column(const ordered_json& columns, const std::string& title) {
  return std::ranges::any_of(columns, [&title](const auto& column) { return column["title"] == title; });
}

TEST(DrawingJson, HasTheDocumentedKeysAndTypes) {
  const ordered_json json = cost_json(made_up_heading(), report_with_thesis_table());
  EXPECT_EQ(keys_of(json["rendering"][0]),
            (Keys{"heads", "transparency", "samples", "lod", "simulation", "strand_terms", "triangles", "ms_per_frame",
                  "spread_pct", "gpu_ms_per_frame", "device", "ms_per_head"}));
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

TEST(DrawingJson, TheDeviceHasAColumnWhereItTellsItsTime) {
  const ordered_json columns = cost_json(made_up_heading(), report_with_thesis_table())["columns"];
  EXPECT_EQ(columns["rendering"].back()["title"], "on the device");
  EXPECT_EQ(columns["rendering"].back()["missing"], "not measured");
  EXPECT_FALSE(has_column(columns["table_1"], "on the device"));
}

TEST(DrawingJson, WhatWasPublishedStandsBeside) {
  const ordered_json json = cost_json(made_up_heading(), report_with_thesis_table());
  ASSERT_EQ(json["table_1_published"].size(), 4u);
  EXPECT_EQ(json["table_1_published"][3]["transparent_fps"], 7);
  EXPECT_EQ(json["table_1_published"][3]["opaque_fps"], 8);
  EXPECT_EQ(json["table_1_setup"]["thesis_device"], kThesisTableDevice);
  EXPECT_EQ(json["table_1_setup"]["width"], 64);
}

TEST(DrawingJson, SaysThatTheDeviceDoesNotTellItsTime) {
  CostReport report = made_up_cost();
  report.rendering.rows.pop_back();
  report.rendering.device = "llvmpipe (made up)";
  const ordered_json json = cost_json(made_up_heading(), report), notes = json["notes"];
  EXPECT_NE(notes["device_time"].get<std::string>().find("itself: not measured"), std::string::npos);
  EXPECT_NE(notes["device"].get<std::string>().find("not on a graphics card"), std::string::npos);
  EXPECT_TRUE(json["table_1_setup"].is_null()) << "nobody asked for it";
}

TEST(DrawingJson, SaysWhichCrowdsAreMissing) {
  CostReport report = made_up_cost();
  report.left_out.push_back({200, kThesisTable, "one frame takes a minute"});
  report.left_out.push_back({512, kDistances, "one frame takes an hour"});
  const ordered_json notes = cost_json(made_up_heading(), report)["notes"]["left_out"];
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_EQ(notes[1]["text"],
            "Not measured: distance of 512 heads; one frame takes an hour. More --time takes in more.");
  EXPECT_EQ(notes[2]["text"], "Not measured: Table 1 of 200 heads; one frame takes a minute.");
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

}  // namespace coif::report::cost_page_test
