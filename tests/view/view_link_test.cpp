#include "report/page/report_page.h"

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

namespace coif::view::view_link_test {

TEST(ViewLink, IsRelativeToTheReport) {
  EXPECT_EQ(report::relative_url("bob.html", "report.html"), "bob.html");
  EXPECT_EQ(report::relative_url("/a/pages/bob.html", "/a/reports/out.html"), "../pages/bob.html");
  EXPECT_EQ(report::relative_url("./x/../bob.html", "out.html"), "bob.html");
}

TEST(ViewLink, NamesMeanThemselvesWhateverIsInThem) {
  EXPECT_EQ(report::relative_url("javascript:alert(1).html", "out.html"), "javascript%3Aalert%281%29.html");
  EXPECT_EQ(report::relative_url("a b#c?d%e\"<\xC3\xA4.html", "out.html"), "a%20b%23c%3Fd%25e%22%3C%C3%A4.html");
}

TEST(ViewLink, SaysOnlyWhatIsSet) {
  EXPECT_EQ(report::view_url("bob.html", {}), "bob.html");
  EXPECT_EQ(report::view_url("bob.html", {.motion = "turn", .beside = "thesis", .rate = 30}),
            "bob.html#motion=turn&plays=1&rate=30&beside=thesis");
  EXPECT_EQ(report::view_url("bob.html", {.solver = "a&b=c"}), "bob.html#solver=a%26b%3Dc");
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

report::ReportHeading heading_with_page() {
  report::ReportHeading heading = report::made_up_heading();
  heading.view = "bob.html";
  heading.view_name = "<bob>.html";
  return heading;
}

TEST(ViewLink, AccuracyReportsOpenThePageWithWhatTheyMeasured) {
  report::AccuracyReport report = report::made_up_accuracy();
  expect_known(report::view_url("bob.html", report::accuracy_link(report)));
  const auto links = report::motion_links(heading_with_page(), report);
  EXPECT_EQ(links.size(), 6u) << "one for each of two motions and three frame rates";
  for (const auto& link : links) {
    const std::string url = link["url"];
    expect_known(url);
    EXPECT_NE(url.find("motion=" + link["motion"].get<std::string>()), std::string::npos) << url;
    EXPECT_NE(url.find("rate=" + link["text"].get<std::string>()), std::string::npos) << url;
  }
}

TEST(ViewLink, WhatThePageHasNotIsNotLinked) {
  report::AccuracyReport report = report::made_up_accuracy();
  for (report::AccuracyRow& row : report.rows) {
    row.fps = 1000;
    if (row.solver == "coif") row.solver = "verlet";
    if (row.motion == "turn") row.motion = "walk.glb:head";
  }
  EXPECT_TRUE(report::motion_links(heading_with_page(), report).empty()) << "too fast for the page's slider";
  const std::string url = report::view_url("bob.html", report::accuracy_link(report));
  expect_known(url);
  EXPECT_NE(url.find("solver=thesis"), std::string::npos) << url;
  report.rows.resize(1);
  report.rows[0].fps = 60;
  report.rows[0].motion = "walk.glb:head";
  EXPECT_TRUE(report::motion_links(heading_with_page(), report).empty());
}

TEST(ViewLink, IsInTheHeadingWhereThereIsAPage) {
  const auto view = report::accuracy_json(heading_with_page(), report::made_up_accuracy())["view"];
  ASSERT_EQ(view.size(), 1u);
  EXPECT_TRUE(view[0]["url"].get<std::string>().starts_with("bob.html#motion="));
  EXPECT_EQ(view[0]["text"], "<bob>.html");
  EXPECT_TRUE(report::accuracy_json(report::made_up_heading(), report::made_up_accuracy())["view"].empty());
}

}  // namespace coif::view::view_link_test
