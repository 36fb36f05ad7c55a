#include "report/page/plot.h"

#include "report/made_up_report.h"
#include "report/page/plot_axis.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>
#include <utility>

namespace coif::plot_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

Plot plot_of(std::vector<PlotPoint> points) {
  Plot plot;
  plot.title = "title";
  plot.add("series", std::move(points), PlotSeries::Style::kPoints);
  return plot;
}

/// Centres of round points, the one in the legend last.
std::vector<PlotPoint> circles(const std::string& svg) {
  std::vector<PlotPoint> places;
  const std::regex circle("<circle cx=\"([-0-9.]+)\" cy=\"([-0-9.]+)\" r=\"3.5\"");
  for (std::sregex_iterator it(svg.begin(), svg.end(), circle), end; it != end; ++it) {
    places.push_back({std::stod((*it)[1]), std::stod((*it)[2])});
  }
  return places;
}

/// Where the tick with this label is, by the middle of the label below or the end of the one on the left.
double tick_place(const std::string& svg, const std::string& label, bool is_x) {
  const std::regex text("<text x=\"([0-9.]+)\" y=\"([0-9.]+)\" text-anchor=\"" + std::string(is_x ? "middle" : "end") +
                        "\">" + label + "</text>");
  std::smatch found;
  EXPECT_TRUE(std::regex_search(svg, found, text)) << label << "\n" << svg;
  return found.empty() ? kNan : is_x ? std::stod(found[1]) : std::stod(found[2]) - 4.5;
}

TEST(Plot, PointsLieWhereTheTicksSay) {
  const std::string svg = draw(plot_of({{0, 2}, {10, 4}, {2.5, 3}}));
  const auto at = circles(svg);
  ASSERT_EQ(at.size(), 4u);
  EXPECT_NEAR(at[0].x, tick_place(svg, "0", true), 0.02);
  EXPECT_NEAR(at[1].x, tick_place(svg, "10", true), 0.02);
  EXPECT_NEAR(at[2].x, 0.75 * at[0].x + 0.25 * at[1].x, 0.02);
  EXPECT_NEAR(at[0].y, tick_place(svg, "2", false), 0.02);
  EXPECT_NEAR(at[1].y, tick_place(svg, "4", false), 0.02);
  EXPECT_NEAR(at[2].y, 0.5 * (at[0].y + at[1].y), 0.02);
  EXPECT_LT(at[1].y, at[0].y) << "larger values are higher";
}

TEST(Plot, LogarithmicAxesGiveEveryFactorTheSameWay) {
  Plot plot = plot_of({{1, 0.01}, {10, 0.1}, {100, 10}});
  plot.log_x = plot.log_y = true;
  const std::string svg = draw(plot);
  const auto at = circles(svg);
  ASSERT_EQ(at.size(), 4u);
  EXPECT_NEAR(at[1].x - at[0].x, at[2].x - at[1].x, 0.03);
  EXPECT_NEAR(2 * (at[1].y - at[0].y), at[2].y - at[1].y, 0.05);
  EXPECT_NEAR(at[1].x, tick_place(svg, "10", true), 0.02);
  EXPECT_NEAR(at[2].y, tick_place(svg, "10", false), 0.02);
}

TEST(PlotAxis, TicksAreRoundNumbersWithinTheRange) {
  PlotAxis linear(false), few(true), many(true), fixed(true), empty(true), below(false);
  linear.add(42);
  linear.close();
  EXPECT_EQ(linear.ticks(), (std::vector<double>{0, 5, 10, 15, 20, 25, 30, 35, 40}));
  below.add(-3);
  below.add(1);
  below.close();
  EXPECT_EQ(below.ticks(), (std::vector<double>{-3, -2.5, -2, -1.5, -1, -0.5, 0, 0.5, 1}));
  few.add(3);
  few.add(80);
  few.close();
  EXPECT_EQ(few.ticks(), (std::vector<double>{5, 10, 20, 50}));
  many.add(0.5);
  many.add(50000);
  many.close();
  EXPECT_EQ(many.ticks(), (std::vector<double>{1, 10, 100, 1000, 10000}));
  fixed.add(24);
  fixed.add(240);
  fixed.close({1, 24, 60, 240, 1000});
  EXPECT_EQ(fixed.ticks(), (std::vector<double>{24, 60, 240}));
  empty.close();
  EXPECT_EQ(empty.ticks().size(), 10u) << "1 to 10";
}

TEST(Plot, LeavesOutWhatTheAxesCannotShow) {
  Plot plot = plot_of({{1, 2}, {kNan, 3}, {4, kInfinity}, {0, 77}, {88, 0}, {-5, 66}});
  EXPECT_EQ(circles(draw(plot)).size(), 4u + 1);
  EXPECT_EQ(draw(plot).find("nan"), std::string::npos);
  EXPECT_EQ(draw(plot).find("inf"), std::string::npos);
  plot.log_x = true;
  EXPECT_EQ(circles(draw(plot)).size(), 2u + 1);
  plot.log_y = true;
  EXPECT_EQ(circles(draw(plot)).size(), 1u + 1);
}

TEST(Plot, StylesAreLinesPointsAndRings) {
  Plot plot;
  plot.add("line", {{1, 1}, {2, 2}}, PlotSeries::Style::kLine);
  plot.add("front", {{1, 2}, {2, 1}}, PlotSeries::Style::kDashedLine);
  plot.add("both", {{1, 3}, {2, 4}}).marked = {{2, 4}};
  plot.add("nothing");
  const std::string svg = draw(plot);
  EXPECT_EQ(count_of(svg, "<polyline"), 3u);
  EXPECT_EQ(count_of(svg, "<polygon"), 3u) << "two triangles and the one of the legend";
  EXPECT_EQ(count_of(svg, "r=\"8.5\""), 1u);
  EXPECT_EQ(count_of(svg, ">front</text>"), 1u);
  EXPECT_EQ(count_of(svg, ">nothing</text>"), 0u) << "what has no points needs no name";
}

TEST(Plot, HostileNamesStayText) {
  const std::string name = "'; </text><script>\n\"{{{ & # \\ \x1b\xff";
  Plot plot = plot_of({{1, 2}, {3, 4}});
  plot.title = plot.x_label = plot.y_label = plot.series[0].name = name;
  plot.markers = {{true, 2, name}, {false, 3, name}};
  const std::string svg = draw(plot);
  EXPECT_EQ(svg.find("<script"), std::string::npos);
  EXPECT_EQ(svg.find('\x1b'), std::string::npos);
  EXPECT_EQ(count_of(svg, "&#39;; &lt;/text&gt;&lt;script&gt; &quot;{{{ &amp; # \\  \xEF\xBF\xBD</text>"), 6u) << svg;
  expect_well_formed(svg);
}

TEST(Plot, IsOneElementInThePagesColors) {
  const std::string svg = draw(plot_of({{1, 2}, {3, 4}}), "third_");
  EXPECT_TRUE(svg.starts_with("<svg") && svg.ends_with("</svg>"));
  EXPECT_EQ(svg.find("<title>"), std::string::npos) << "browsers would show it as a tip over the plot";
  EXPECT_EQ(svg.find("black"), std::string::npos);
  EXPECT_NE(svg.find("currentColor"), std::string::npos);
  EXPECT_NE(svg.find("aria-labelledby=\"third_title\""), std::string::npos);
  EXPECT_NE(svg.find("id=\"third_title\" text-anchor=\"middle\">title</text>"), std::string::npos);
  expect_well_formed(svg);
}

TEST(Plot, DegeneratePlotsAreDrawn) {
  const std::vector<std::vector<PlotPoint>> kinds = {{},
                                                     {{5, 5}},
                                                     {{0, 0}},
                                                     {{kNan, kNan}},
                                                     {{1.0e-300, 1.0e-300}, {1.0e300, 1.0e300}},
                                                     {{5e-324, -5e-324}, {1e308, -1e308}},
                                                     {{3, 7}, {3, 7}}};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (const bool logarithmic : {false, true}) {
      Plot plot = plot_of(kinds[i]);
      plot.log_x = plot.log_y = logarithmic;
      plot.markers = {{true, 3, "vertical"}, {false, 0, "at zero"}, {true, kNan, "nowhere"}};
      const std::string svg = draw(plot);
      EXPECT_EQ(svg.find("nan"), std::string::npos) << i << " " << logarithmic;
      EXPECT_LT(count_of(svg, "<path"), 200u) << i << " " << logarithmic;
      expect_well_formed(svg);
    }
  }
  EXPECT_NE(draw(plot_of({})).find("no data"), std::string::npos);
}

}  // namespace coif::plot_test
