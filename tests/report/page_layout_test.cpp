#include "report/cards/cards_report.h"
#include "report/made_up_report.h"
#include "report/page/report_page.h"
#include "report/shadow/shadow_report.h"

#include <gtest/gtest.h>

#include <functional>
#include <string>

namespace coif::report::page_layout_test {

using nlohmann::ordered_json;

constexpr const char* kHostile = "</script><script>alert(\"1\" & '2')</script>\x1b\xff@SCRIPT@";

/// The value under "a.0.b"; null where there is none.
ordered_json value_at(const ordered_json& report, std::string path) {
  for (char& c : path) c = c == '.' ? '/' : c;
  const ordered_json::json_pointer pointer("/" + path);
  return report.contains(pointer) ? report.at(pointer) : ordered_json();
}

/// Calls `look` with each object within `value`.
void walk(const ordered_json& value, const std::function<void(const ordered_json&)>& look) {
  if (value.is_object()) look(value);
  if (value.is_structured()) {
    for (const auto& inner : value) walk(inner, look);
  }
}

void expect_keys_of_a_record(const ordered_json& report, const ordered_json& of, const std::vector<std::string>& keys) {
  const ordered_json list = value_at(report, of["rows"]);
  ASSERT_TRUE(list.is_array()) << "no list: " << of.dump();
  ASSERT_FALSE(list.empty()) << "the made-up report has none: " << of.dump();
  for (const std::string& key : keys) EXPECT_TRUE(list[0].contains(key)) << key << " of " << of.dump();
}

std::vector<std::string> keys_that_choose(const ordered_json& of) {
  std::vector<std::string> keys;
  for (const char* which : {"where", "not"}) {
    if (!of.contains(which)) continue;
    for (const auto& [key, value] : of[which].items()) keys.push_back(key);
  }
  for (const char* name : {"by", "color_by", "on", "ring", "x", "y", "down", "across"}) {
    if (of.contains(name) && of[name].is_string()) keys.push_back(of[name]);
  }
  return keys;
}

void expect_chart_fits(const ordered_json& report, const ordered_json& chart) {
  for (const auto& series : chart["series"]) {
    std::vector<std::string> keys = keys_that_choose(series);
    for (const char* axis : {"x", "y"}) {
      if (!series.contains(axis)) keys.push_back(chart[axis]["key"]);
    }
    expect_keys_of_a_record(report, series, keys);
    EXPECT_TRUE(series.contains("by") || series.contains("name")) << series.dump();
  }
}

/// Every list and key that the layout speaks of is in the report.
void expect_layout_fits(const ordered_json& report, const char* layout) {
  const ordered_json parts = ordered_json::parse(layout);
  walk(parts, [&](const ordered_json& part) {
    if (part.contains("chart")) expect_chart_fits(report, part["chart"]);
    if (part.contains("table")) expect_keys_of_a_record(report, part["table"], keys_that_choose(part["table"]));
    if (part.contains("table") && !part["table"].contains("columns")) {
      EXPECT_FALSE(report["columns"][part["table"]["rows"].get<std::string>()].empty()) << part.dump();
    }
    if (part.contains("pivot")) {
      std::vector<std::string> keys = keys_that_choose(part["pivot"]);
      for (const auto& cell : part["pivot"]["cells"]) keys.push_back(cell["key"]);
      expect_keys_of_a_record(report, part["pivot"], keys);
    }
    if (part.contains("if")) {
      for (const auto& path : part["if"].is_array() ? part["if"] : ordered_json{part["if"]}) {
        EXPECT_TRUE(report.contains(
            ordered_json::json_pointer("/" + path.get<std::string>().substr(0, path.get<std::string>().find('.')))))
            << path;
      }
    }
  });
}

/// With a row in every list.
AccuracyReport full_accuracy() {
  AccuracyReport report = made_up_accuracy();
  report.own_reference.push_back({"slow", "nod", 0.5});
  report.swings.rows.push_back({"fringe"});
  report.swings.longest = {"fringe", 0.5, {0.1, 0.2}, {0.1, 0.2}};
  report.stroke.push_back({60});
  return report;
}

TEST(PageLayout, SpeaksOfWhatReportsHave) {
  CostReport cost = made_up_cost();
  cost.rendering.thesis_table = made_up_thesis_table();
  ShadowReport shadows;
  shadows.lights = {{"sun", 40, 20}};
  shadows.rows = {{.technique = "plain", .size = 256, .light = "sun"}};
  shadows.totals = {{.technique = "plain", .size = 256}};
  const ReportHeading heading = made_up_heading();
  expect_layout_fits(accuracy_json(heading, full_accuracy()), coif_accuracy_page);
  expect_layout_fits(stability_json(heading, made_up_stability()), coif_stability_page);
  expect_layout_fits(cost_json(heading, cost), coif_cost_page);
  expect_layout_fits(order_json(heading, made_up_order()), coif_order_page);
  expect_layout_fits(shadow_json(heading, shadows), coif_shadows_page);
  CardsReport cards;
  cards.rows.resize(1);
  cards.summary.resize(1);
  cards.asset.resize(1);
  cards.ablation.resize(1);
  expect_layout_fits(cards_json(heading, cards), coif_cards_page);
}

/// What lies in an element <script> of the page, by its id.
ordered_json data_of(const std::string& page, const std::string& id) {
  const std::size_t begin = page.find('>', page.find("id=\"" + id + "\"")) + 1;
  return ordered_json::parse(page.substr(begin, page.find("</script>", begin) - begin));
}

TEST(ReportPage, HoldsTheReportAndItsLayout) {
  const ordered_json report = accuracy_json(made_up_heading(), full_accuracy());
  const std::string page = page_html(report, coif_accuracy_page);
  EXPECT_EQ(data_of(page, "report"), report);
  EXPECT_EQ(data_of(page, "layout"), ordered_json::parse(coif_accuracy_page));
  EXPECT_NE(page.find("<title>Error against run time: bob &lt;b&gt;.coif</title>"), std::string::npos);
}

TEST(ReportPage, NoTextBecomesMarkup) {
  const ordered_json report{{"title", kHostile}, {"finding", kHostile}};
  const std::string page = page_html(report, R"([{"summary": "{finding}"}, {"text": "</script>"}])");
  EXPECT_EQ(count_of(page, "alert(\"1\""), 0u);
  EXPECT_EQ(count_of(page, "<script>alert"), 0u);
  EXPECT_EQ(count_of(page, "</script>"), 4u) << "report, layout, charts and script";
  const std::string found = data_of(page, "report")["finding"];
  EXPECT_TRUE(found.starts_with("</script><script>alert(\"1\" & '2')</script>\x1b\xEF\xBF\xBD@SCRIPT@")) << found;
}

TEST(ReportPage, NeedsNothingBesideItself) {
  const std::string page = page_html({{"title", "title"}}, R"([{"chart": {}}])");
  for (const char* word : {" src=\"", "@import", "url(", "<link", "<script src"}) {
    EXPECT_EQ(page.find(word), std::string::npos) << word;
  }
  EXPECT_NE(page.find("default-src 'none'; img-src data:; style-src 'unsafe-inline'; script-src 'sha256-"),
            std::string::npos);
  EXPECT_NE(page.find("Chart.js v"), std::string::npos) << "with whose work it is";
  EXPECT_NE(page.find("MIT License"), std::string::npos);
}

TEST(ReportPage, IsSmallWithoutCharts) {
  const std::string page = page_html({{"title", "title"}}, R"([{"heading": "one"}])");
  EXPECT_EQ(page.find("Chart.js v"), std::string::npos);
  EXPECT_EQ(count_of(page, "'sha256-"), 1u);
  EXPECT_LT(page.size(), 40000u);
}

}  // namespace coif::report::page_layout_test
