#include "report/page/view_link.h"

#include "base/json.h"
#include "models/drawn_card.h"
#include "report/accuracy/accuracy_report.h"
#include "report/made_up_report.h"
#include "view/page/view_settings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <sstream>
#include <string>

namespace coif::view_link_test {

TEST(ViewLink, IsRelativeToTheReport) {
  EXPECT_EQ(relative_url("bob.html", "report.html"), "bob.html");
  EXPECT_EQ(relative_url("/a/pages/bob.html", "/a/reports/out.html"), "../pages/bob.html");
  EXPECT_EQ(relative_url("./x/../bob.html", "out.html"), "bob.html");
}

TEST(ViewLink, NamesMeanThemselvesWhateverIsInThem) {
  EXPECT_EQ(relative_url("javascript:alert(1).html", "out.html"), "javascript%3Aalert%281%29.html");
  EXPECT_EQ(relative_url("a b#c?d%e\"<\xC3\xA4.html", "out.html"), "a%20b%23c%3Fd%25e%22%3C%C3%A4.html");
}

TEST(ViewLink, SaysOnlyWhatIsSet) {
  EXPECT_EQ(view_url("bob.html", {}), "bob.html");
  EXPECT_EQ(view_url("bob.html", {.motion = "turn", .beside = "thesis", .rate = 30}),
            "bob.html#motion=turn&plays=1&rate=30&beside=thesis");
  EXPECT_EQ(view_url("bob.html", {.solver = "a&b=c"}), "bob.html#solver=a%26b%3Dc");
}

/// Each setting of the link is a control's word or a number in its range.
void expect_known(const std::string& url) {
  const DrawnAsset asset(card_contents(std::array{DrawnCard{}}));
  const auto controls = nlohmann::json::parse(controls_json(*asset));
  const std::size_t begin = url.find('#');
  ASSERT_NE(begin, std::string::npos) << url;
  std::istringstream settings(url.substr(begin + 1));
  for (std::string setting; std::getline(settings, setting, '&');) {
    const std::string name = setting.substr(0, setting.find('=')), value = setting.substr(setting.find('=') + 1);
    const auto row = std::ranges::find_if(controls, [&](const auto& c) { return c["name"] == name; });
    ASSERT_NE(row, controls.end()) << setting;
    if ((*row)["kind"] == "choice") {
      const std::string words = "|" + (*row)["words"].get<std::string>() + "|";
      EXPECT_NE(words.find("|" + value + "|"), std::string::npos) << setting;
    } else {
      EXPECT_GE(std::stod(value), (*row)["low"].get<double>()) << setting;
      EXPECT_LE(std::stod(value), (*row)["high"].get<double>()) << setting;
    }
  }
}

ReportHeading heading_with_page() {
  ReportHeading heading = made_up_heading();
  heading.view = "bob.html";
  heading.view_name = "<bob>.html";
  return heading;
}

TEST(ViewLink, AccuracyReportsOpenThePageWithWhatTheyMeasured) {
  AccuracyReport report = made_up_accuracy();
  expect_known(view_url("bob.html", accuracy_link(report)));
  for (const std::string& motion : names_of(report.rows, &AccuracyRow::motion)) {
    const auto links = motion_links(heading_with_page(), report, motion);
    EXPECT_EQ(links.size(), 3u) << "one for each frame rate";
    for (const PageLink& link : links) {
      expect_known(link.url);
      EXPECT_NE(link.url.find("motion=" + motion), std::string::npos) << link.url;
    }
  }
}

TEST(ViewLink, WhatThePageHasNotIsNotLinked) {
  AccuracyReport report = made_up_accuracy();
  for (AccuracyRow& row : report.rows) {
    row.fps = 1000;
    if (row.solver == "coif") row.solver = "verlet";
    if (row.motion == "turn") row.motion = "walk.glb:head";
  }
  EXPECT_TRUE(motion_links(heading_with_page(), report, "nod").empty()) << "too fast for the page's slider";
  EXPECT_TRUE(motion_links(heading_with_page(), report, "walk.glb:head").empty());
  const std::string url = view_url("bob.html", accuracy_link(report));
  expect_known(url);
  EXPECT_NE(url.find("solver=thesis"), std::string::npos) << url;
}

TEST(ViewLink, IsInTheHeadingWhereThereIsAPage) {
  const std::string with = accuracy_page(heading_with_page(), made_up_accuracy());
  EXPECT_NE(with.find("See it move: <a href=\"bob.html#motion="), std::string::npos);
  EXPECT_NE(with.find("&lt;bob&gt;.html</a>"), std::string::npos) << "escaped";
  const std::string without = accuracy_page(made_up_heading(), made_up_accuracy());
  EXPECT_EQ(without.find("<a "), std::string::npos);
}

}  // namespace coif::view_link_test
