#include "report/page/shadow_page.h"

#include "report/page/made_up_report.h"
#include "report/page/shadow_json.h"
#include "report/page/shadow_summary.h"
#include "report/page/shadow_text.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

namespace coif {
namespace {

using nlohmann::ordered_json;

std::vector<std::string> keys_of(const ordered_json& object) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

ShadowTotal made_up_total(const char* technique, std::uint32_t layers, std::uint32_t size, double rmse) {
  ShadowTotal total{.technique = technique, .layers = layers, .size = size};
  total.hair = {rmse, -rmse / 4};
  total.worst_light = "low <sun>";
  total.worst_pose = "turn";
  total.worst_rmse = 1.5 * rmse;
  total.ms = 0.01 * size;
  total.bytes = std::uint64_t{4} * (1 + layers) * size * size;
  return total;
}

/// Hair without a head, under one light.
ShadowReport made_up_shadows() {
  ShadowReport report;
  report.device = "made-up device";
  report.spacing = 0.002;
  report.hair_points = 1234;
  report.lights = {{"low <sun>", 40, -20}};
  report.totals = {made_up_total("none", 0, 0, 0.8), made_up_total("plain", 0, 256, 0.2),
                   made_up_total("deep", 4, 256, 0.12), made_up_total("deep", 4, 512, 0.1)};
  for (const ShadowTotal& total : report.totals) {
    report.rows.push_back({.technique = total.technique,
                           .layers = total.layers,
                           .size = total.size,
                           .light = "low <sun>",
                           .pose = "turn",
                           .hair = total.hair,
                           .ms = total.ms});
  }
  return report;
}

TEST(ShadowJson, HasTheDocumentedKeysAndTypes) {
  const ordered_json json = shadow_json(made_up_heading(), made_up_shadows());
  EXPECT_EQ(json["hair_points"], 1234);
  EXPECT_EQ(keys_of(json["lights"][0]), (std::vector<std::string>{"light", "yaw", "pitch"}));
  EXPECT_EQ(keys_of(json["rows"][0]), (std::vector<std::string>{"technique", "layers", "size", "light", "pose", "rmse",
                                                                "bias", "head_rmse", "head_bias", "ms"}));
  EXPECT_EQ(keys_of(json["totals"][0]),
            (std::vector<std::string>{"technique", "layers", "size", "rmse", "bias", "head_rmse", "head_bias",
                                      "worst_light", "worst_pose", "worst_rmse", "ms", "bytes"}));
  ASSERT_EQ(json["rows"].size(), 4u);
  EXPECT_EQ(json["rows"][2]["rmse"], 0.12);
  EXPECT_TRUE(json["rows"][2]["head_rmse"].is_null()) << "there is no head";
}

TEST(ShadowSummary, NamesTheBestAndTheSmallestThatIsNearlyAsGood) {
  const std::string text = shadow_summary(made_up_shadows());
  EXPECT_NE(text.find("Nearest to the truth: deep, 4 layers, 512 (RMS 0.10"), std::string::npos) << text;
  EXPECT_NE(text.find("nearly as good: deep, 4 layers, 256"), std::string::npos) << text;
}

TEST(ShadowSummary, SaysWhereNothingWasCompared) {
  ShadowReport report = made_up_shadows();
  for (ShadowTotal& total : report.totals) total.hair = {};
  EXPECT_EQ(shadow_summary(report), "There is no hair in the light: nothing was compared.");
}

TEST(ShadowText, HasALineForEachTechnique) {
  const std::string text = shadow_text(made_up_heading(), made_up_shadows());
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  none +0.80.* - +-\n"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  deep, 4 layers, 256 +0.12.*0.18.* \\(low <sun>, turn\\) ")))
      << text;
}

TEST(ShadowPage, HasAllPartsAndEscapesNames) {
  const auto page = shadow_page(made_up_heading(), made_up_shadows());
  ASSERT_TRUE(page) << page.error().message;
  for (const char* part : {"bob &lt;b&gt;.coif", "made-up device", "low &lt;sun&gt;, turn", "deep, 4 layers, 512",
                           "1234 points of hair", "without shadows"}) {
    EXPECT_NE(page->find(part), std::string::npos) << part;
  }
  EXPECT_EQ(page->find("<sun>"), std::string::npos);
}

}  // namespace
}  // namespace coif
