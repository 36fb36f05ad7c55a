#include "report/page/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <unistd.h>
#include <utility>

namespace coif::plot_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

std::size_t count_of(const std::string& text, const std::string& word) {
  std::size_t count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++count;
  return count;
}

Plot plot_of(std::vector<PlotPoint> points) {
  Plot plot;
  plot.title = "title";
  plot.series.emplace_back();
  plot.series[0].name = "series";
  plot.series[0].points = std::move(points);
  plot.series[0].style = PlotSeries::Style::kPoints;
  return plot;
}

/// Points in the SVG, with the one in the legend: gnuplot places a shape for each.
std::size_t drawn_points(const std::string& svg) { return count_of(svg, " transform='translate("); }

TEST(PlotScript, LeavesOutWhatTheAxesCannotShow) {
  Plot plot = plot_of({{1, 2}, {kNan, 3}, {4, kInfinity}, {0, 77}, {88, 0}, {-5, 66}});
  EXPECT_NE(plot_script(plot).find("\n0 77\n"), std::string::npos);
  EXPECT_EQ(plot_script(plot).find("nan"), std::string::npos);
  EXPECT_EQ(plot_script(plot).find("inf"), std::string::npos);
  plot.log_x = true;
  EXPECT_EQ(plot_script(plot).find("\n0 77\n"), std::string::npos);
  EXPECT_EQ(plot_script(plot).find("\n-5 66\n"), std::string::npos);
  EXPECT_NE(plot_script(plot).find("\n88 0\n"), std::string::npos);
  plot.log_y = true;
  EXPECT_EQ(plot_script(plot).find("\n88 0\n"), std::string::npos);
  EXPECT_NE(plot_script(plot).find("\n1 2\n"), std::string::npos);
}

TEST(PlotScript, TextsCannotLeaveTheirQuotes) {
  Plot plot = plot_of({{1, 1}});
  plot.title = "a'b\nsystem('x')\\";
  const std::string script = plot_script(plot);
  EXPECT_NE(script.find("set title 'a\u2019b system(\u2019x\u2019)\\'\n"), std::string::npos) << script;
}

TEST(Draw, EveryPointThatFitsIsInThePicture) {
  const auto two = draw(plot_of({{1, 2}, {3, 4}}));
  const auto four = draw(plot_of({{1, 2}, {3, 4}, {kNan, 4}, {5, 1}, {6, kInfinity}, {7, 2}}));
  ASSERT_TRUE(two && four) << (two ? four : two).error().message;
  EXPECT_EQ(drawn_points(*four), drawn_points(*two) + 2);
}

TEST(Draw, HostileNamesStayText) {
  const auto file = std::filesystem::temp_directory_path() / "coif_plot_test_hostile";
  std::filesystem::remove(file);
  const std::string name = "'; system('touch " + file.string() + "'); `touch " + file.string() + "` @x {/Bold y}_2 " +
                           "</text><script>\n! touch " + file.string() + "\nEND\n\"{{{ # \\";
  Plot plot = plot_of({{1, 2}, {3, 4}});
  plot.title = plot.x_label = plot.y_label = plot.series[0].name = name;
  plot.markers = {{true, 2, name}, {false, 3, name}};
  const auto svg = draw(plot);
  ASSERT_TRUE(svg) << svg.error().message;
  EXPECT_FALSE(std::filesystem::exists(file));
  EXPECT_EQ(svg->find("<script"), std::string::npos);
  EXPECT_EQ(count_of(*svg, "{/Bold y}_2"), 6u);
}

TEST(Draw, GivesOneElementInThePagesColors) {
  const auto svg = draw(plot_of({{1, 2}, {3, 4}}));
  ASSERT_TRUE(svg) << svg.error().message;
  EXPECT_TRUE(svg->starts_with("<svg"));
  EXPECT_EQ(svg->find("<title>"), std::string::npos);
  EXPECT_EQ(svg->find("black"), std::string::npos);
  EXPECT_NE(svg->find("currentColor"), std::string::npos);
}

TEST(Draw, DegeneratePlotsAreDrawn) {
  const std::vector<std::vector<PlotPoint>> kinds = {
      {}, {{5, 5}}, {{0, 0}}, {{kNan, kNan}}, {{1.0e-300, 1.0e-300}, {1.0e300, 1.0e300}}, {{3, 7}, {3, 7}}};
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    for (const bool logarithmic : {false, true}) {
      Plot plot = plot_of(kinds[i]);
      plot.log_x = plot.log_y = logarithmic;
      plot.markers = {{true, 3, "vertical"}, {false, 0, "at zero"}, {true, kNan, "nowhere"}};
      const auto svg = draw(plot);
      EXPECT_TRUE(svg) << i << " " << logarithmic << ": " << svg.error().message;
    }
  }
  EXPECT_NE(draw(plot_of({}))->find("no data"), std::string::npos);
}

TEST(Draw, MissingProgramIsAnErrorWithItsCure) {
  const Plotter plotter{"no-such-gnuplot"};
  const auto svg = draw(plot_of({{1, 2}}), plotter);
  ASSERT_FALSE(svg);
  EXPECT_EQ(svg.error().kind, ToolError::Kind::kUnsupported);
  EXPECT_NE(svg.error().message.find("apt-get install gnuplot-nox"), std::string::npos);
  EXPECT_EQ(check_plotter(plotter).error().message, svg.error().message);
  EXPECT_TRUE(check_plotter());
}

/// An executable script that stands in for gnuplot.
class Impostor {
 public:
  explicit Impostor(const std::string& script)
      : path_(std::filesystem::temp_directory_path() / ("coif_plot_test_" + std::to_string(getpid()))) {
    std::ofstream(path_) << "#!/bin/sh\n" << script << "\n";
    std::filesystem::permissions(path_, std::filesystem::perms::owner_all);
  }
  Impostor(const Impostor&) = delete;
  Impostor& operator=(const Impostor&) = delete;
  ~Impostor() { std::filesystem::remove(path_); }

  [[nodiscard]] ToolError error_of_draw() const {
    Plotter plotter{path_.string()};
    plotter.patience = std::chrono::milliseconds(500);
    const auto svg = draw(plot_of({{1, 2}}), plotter);
    return svg ? ToolError{ToolError::Kind::kUsage, "drew"} : svg.error();
  }

 private:
  std::filesystem::path path_;
};

TEST(Draw, BadProgramIsAnErrorThatSaysWhy) {
  const std::pair<const char*, const char*> cases[] = {
      {"sleep 600", "killed"},
      {"echo no terminal svg >&2; exit 1", "status 1: no terminal svg"},
      {"echo hello", "wrote no picture"},
      {"kill -SEGV $$", "signal 11"}};
  for (const auto& [script, words] : cases) {
    const ToolError error = Impostor(script).error_of_draw();
    EXPECT_EQ(error.kind, ToolError::Kind::kInternal) << script;
    EXPECT_NE(error.message.find(words), std::string::npos) << error.message;
  }
}

}  // namespace coif::plot_test
