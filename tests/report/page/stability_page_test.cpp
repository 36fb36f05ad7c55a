#include "report/page/stability_page.h"

#include "report/page/made_up_report.h"
#include "report/page/stability_text.h"
#include "report/page/stability_totals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

namespace coif {
namespace {

TEST(StabilityTotals, CountOutcomesAndTakeTheWorstOfWhatEndedWell) {
  const auto totals = stability_totals(made_up_stability());
  ASSERT_EQ(totals.size(), 3u);
  using Counts = std::array<unsigned, 4>;
  EXPECT_EQ(totals[0].count, (Counts{2, 0, 0, 0}));
  EXPECT_EQ(totals[1].count, (Counts{1, 1, 0, 0}));
  EXPECT_EQ(totals[2].count, (Counts{0, 0, 1, 1}));
  EXPECT_EQ(totals[0].stretch_max_pct, 0.25);
  EXPECT_EQ(totals[0].settle_error_pct, 0.75);
  EXPECT_EQ(totals[1].stretch_max_pct, 132);
  EXPECT_TRUE(std::isnan(totals[2].stretch_max_pct)) << "what diverged must not count among the good";
}

TEST(StabilityTotals, SummaryTellsSafeFromBroken) {
  const std::string text = stability_summary(made_up_stability());
  EXPECT_NE(text.find("2 cases of stress"), std::string::npos) << text;
  EXPECT_NE(text.find("refused the input: coif, thesis. Broke down: slow (in 2)."), std::string::npos) << text;
}

TEST(StabilityPage, HasARowForEachCaseAndAColumnForEachSolver) {
  const std::string html = stability_page(made_up_heading(), made_up_stability());
  const std::regex row(
      "<tr><td>turn_10fps</td><td class=\"prose\">head shaken at 10 frames per second</td>"
      "<td class=\"good\">ok<br>stretch 0 %<br>inside 0 %</td>"
      "<td class=\"good\">ok<br>stretch 132 %<br>inside 7.00 %</td>"
      "<td class=\"warning\">diverged<br>stretch 4.0e\\+09 %<br>inside 100 %</td></tr>");
  EXPECT_TRUE(std::regex_search(html, row)) << html;
  EXPECT_NE(html.find("<td class=\"neutral\">rejected</td><td class=\"bad\">nan</td></tr>"), std::string::npos);
  EXPECT_NE(html.find("<th scope=\"col\">slow</th>"), std::string::npos);
  EXPECT_EQ(html.find("<b>"), std::string::npos);
}

TEST(StabilityPage, ShowsADashForWhatDoesNotExist) {
  StabilityReport report = made_up_stability();
  report.rows.erase(report.rows.begin());
  const std::string html = stability_page(made_up_heading(), report);
  EXPECT_NE(
      html.find("<td class=\"prose\">head shaken at 10 frames per second</td><td class=\"good\">ok<br>stretch 132"),
      std::string::npos);
  EXPECT_NE(html.find("<td class=\"good\">ok<br>stretch 0.250 %<br>inside 0 %</td>"), std::string::npos);
  EXPECT_TRUE(std::regex_search(html, std::regex("<td>-</td>")));
  EXPECT_TRUE(std::regex_search(html, std::regex("nan</td><td class=\"number\">-</td><td class=\"number\">-</td>")));
}

TEST(StabilityText, HasALineForEachSolver) {
  const std::string text = stability_text(made_up_heading(), made_up_stability());
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  coif +2 +0 +0 +0 +0.250 +0 +0.750\n"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  slow +0 +0 +1 +1 +- +- +-\n"))) << text;
}

}  // namespace
}  // namespace coif
