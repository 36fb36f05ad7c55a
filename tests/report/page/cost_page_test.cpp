#include "report/page/cost_page.h"

#include "report/page/cost_json.h"
#include "report/page/cost_plots.h"
#include "report/page/cost_rows.h"
#include "report/page/cost_summary.h"
#include "report/page/cost_tables.h"
#include "report/page/cost_text.h"
#include "report/page/made_up_cost.h"
#include "report/page/made_up_report.h"

#include <gtest/gtest.h>

#include <regex>

namespace coif {
namespace {

using nlohmann::ordered_json;
using Keys = std::vector<std::string>;

Keys keys_of(const ordered_json& object) {
  Keys keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

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
  EXPECT_EQ(solvers_of(report), (std::vector<std::string>{"coif", "thesis"}));
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
  for (const Table& table : {scaling_table(report), substeps_table(report), features_table(report),
                             memory_table(report), chunks_table(report)}) {
    EXPECT_FALSE(table.rows.empty());
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size()) << table.columns[0].title;
  }
}

TEST(CostTables, UnsteadyTimesStandOut) {
  const Table table = features_table(made_up_cost());
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
  const auto page = cost_page(made_up_heading(), made_up_cost());
  ASSERT_TRUE(page) << page.error().message;
  for (const char* part : {"bob &lt;b&gt;.coif", "not with those of another machine", "AVX9", "no-colliders",
                           "made-up device", "Not measured: drawing of 100, 1000 heads", "texels"}) {
    EXPECT_NE(page->find(part), std::string::npos) << part;
  }
  const std::regex figure("<figure>");
  EXPECT_EQ(std::distance(std::sregex_iterator(page->begin(), page->end(), figure), std::sregex_iterator()), 5);
}

TEST(CostPage, RigidHairWithoutADeviceStillHasItsBytes) {
  const auto page = cost_page(made_up_heading(), rigid_report());
  ASSERT_TRUE(page) << page.error().message;
  EXPECT_NE(page->find("Nothing was drawn: no device."), std::string::npos);
  EXPECT_NE(page->find("texels"), std::string::npos);
  EXPECT_EQ(page->find("<figure>"), std::string::npos);
}

TEST(CostPage, MissingPlotterIsAnErrorWithItsCure) {
  const auto page = cost_page(made_up_heading(), made_up_cost(), {"no-such-gnuplot"});
  ASSERT_FALSE(page);
  EXPECT_NE(page.error().message.find("apt-get install gnuplot-nox"), std::string::npos);
}

TEST(CostText, HasALineForEveryRow) {
  const std::string text = cost_text(made_up_heading(), made_up_cost());
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  coif +1 +100 +200 +2.00 +200 +4.00 %\n"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  no-colliders +15.0 +1.50 +-25 % +60.0 %\n"))) << text;
  EXPECT_NE(cost_text(made_up_heading(), rigid_report()).find("not drawn: no device"), std::string::npos);
}

}  // namespace
}  // namespace coif
