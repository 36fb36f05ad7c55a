#include "base/encodings.h"
#include "report/made_up_report.h"
#include "report/order/order_report.h"
#include "report/shadow/shadow_report.h"

#include <gtest/gtest.h>

#include <regex>
#include <string>
#include <vector>

namespace coif::report::order_page_test {

using nlohmann::ordered_json;
std::vector<std::uint8_t> bytes_of(const std::string& text) { return {text.begin(), text.end()}; }

TEST(Base64, IsThatOfTheRfc) {
  EXPECT_EQ(base64({}), "");
  EXPECT_EQ(base64(bytes_of("f")), "Zg==");
  EXPECT_EQ(base64(bytes_of("fo")), "Zm8=");
  EXPECT_EQ(base64(bytes_of("foobar")), "Zm9vYmFy");
  EXPECT_EQ(base64(std::vector<std::uint8_t>{0xFB, 0xFF, 0xFE}), "+//+");
}

TEST(OrderJson, HasTheDocumentedKeysAndTypes) {
  const ordered_json json = order_json(made_up_heading(), made_up_order());
  EXPECT_EQ(json["asset"], "bob <b>.coif");
  EXPECT_EQ(json["views"], 4);
  EXPECT_EQ(json["orders"], 3);
  EXPECT_EQ(keys_of(json["rows"][0]),
            (Keys{"order", "pose", "faces", "psnr_db", "rmse", "worst_psnr_db", "bad_pixels_pct", "popping",
                  "median_psnr_db", "ms_per_frame", "sorting_ns", "bytes"}));
  EXPECT_EQ(keys_of(json["modes"][0]), (Keys{"transparency", "samples", "pose", "psnr_db", "rmse", "worst_psnr_db",
                                             "bad_pixels_pct", "popping", "median_psnr_db", "ms_per_frame"}));
  EXPECT_EQ(keys_of(json["thresholds"][0]), (Keys{"opaque_threshold", "is_own", "psnr_db", "rmse", "worst_psnr_db",
                                                  "bad_pixels_pct", "median_psnr_db"}));
  EXPECT_EQ(keys_of(json["distance"][0]), (Keys{"pixels", "coverage_pct", "lod", "lod_coverage_pct"}));
  EXPECT_EQ(keys_of(json["reference"][0]), (Keys{"against", "psnr_db", "max_difference"}));
  EXPECT_EQ(keys_of(json["worst"][0]), (Keys{"name", "pose", "yaw", "pitch", "psnr_db", "caption", "png"}));
  EXPECT_EQ(keys_of(json["left_out"][0]), (Keys{"what", "why"}));
  EXPECT_EQ(keys_of(json["gain_over_head_db"]), (Keys{"rest", "turn"}));
}

TEST(OrderJson, HoldsEveryRow) {
  const OrderReport report = made_up_order();
  const ordered_json json = order_json(made_up_heading(), report);
  ASSERT_EQ(json["rows"].size(), report.rows.size());
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    EXPECT_EQ(json["rows"][i]["psnr_db"], report.rows[i].error.psnr_db);
    EXPECT_EQ(json["rows"][i]["median_psnr_db"], report.rows[i].error.median_psnr_db);
    EXPECT_EQ(json["rows"][i]["faces"], report.rows[i].faces_together ? "together" : "apart");
  }
  EXPECT_TRUE(json["rows"][2]["popping"].is_null());
  EXPECT_TRUE(json["rows"][0]["sorting_ns"].is_null()) << "one order for all sides";
  EXPECT_EQ(json["rows"][1]["sorting_ns"], 7);
  EXPECT_EQ(json["solver"], "coif");
  EXPECT_EQ(json["gain_over_head_db"]["turn"], 20);
}

TEST(OrderJson, LargeErrorsStandOut) {
  EXPECT_EQ(decibels().looks.dump(), R"([{"least":40,"look":"good"},{"least":30,"look":"neutral"},{"look":"bad"}])");
  const ordered_json json = order_json(made_up_heading(), made_up_order());
  for (const auto& [list, columns] : json["columns"].items()) {
    for (const auto& column : columns) {
      const bool is_psnr = column["key"].get<std::string>().ends_with("psnr_db");
      EXPECT_EQ(column.contains("looks"), is_psnr) << list << " " << column;
    }
  }
}

TEST(OrderJson, ViewsGoFromBestToWorst) {
  const ordered_json views = order_json(made_up_heading(), made_up_order())["view_errors"];
  ASSERT_EQ(views.size(), 6u * 4);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(views[i]["order"], "head");
    EXPECT_LE(views[i]["psnr_db"], views[i - 1]["psnr_db"]);
    EXPECT_GT(views[i]["views_pct"], views[i - 1]["views_pct"]);
  }
}

TEST(OrderSummary, SaysHowExactTheOwnOrderIsAndWhatToChange) {
  const std::string text = order_summary(made_up_order());
  EXPECT_NE(text.find("own order (view) is 40.0 dB from exact order (median of 4 views 41.0, worst 35.0)"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("+20.0 dB rest, +20.0 dB turn"), std::string::npos) << text;
  EXPECT_NE(text.find("An opaque threshold of 0.90 instead of 0.80 would give 41.0 dB"), std::string::npos) << text;
  EXPECT_NE(text.find("At 16 pixels only 62 % of the hair is left"), std::string::npos) << text;
}

TEST(OrderSummary, PraisesWhatNeedsNoChange) {
  OrderReport report = made_up_order();
  report.thresholds = {{0.8, true, report.rows[1].error}};
  report.distance.pop_back();
  const std::string text = order_summary(report);
  EXPECT_NE(text.find("No other opaque threshold is better than 0.80."), std::string::npos) << text;
  EXPECT_NE(text.find("stays as dense far away as near by"), std::string::npos) << text;
}

TEST(OrderText, HasALineForEveryRow) {
  const std::string text = order_text(made_up_heading(), made_up_order());
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  turn +view +40.0 +41.0 +35.0 .* 1.50 +7\n"))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  rest +opaque +18.0 "))) << text;
  EXPECT_TRUE(std::regex_search(text, std::regex("\n  0.800 .*the asset's\n"))) << text;
  EXPECT_NE(text.find("left out: bones: this program <cannot>"), std::string::npos) << text;
}

TEST(OrderJson, HasItsPicturesAndWhatTheyShow) {
  const ordered_json json = order_json(made_up_heading(), made_up_order());
  EXPECT_EQ(json["worst"][0]["png"], "AQID");
  EXPECT_EQ(json["worst"][0]["caption"], "head, rest: 15.0 dB from yaw 90, pitch 0 degrees");
  EXPECT_EQ(json["left_out"][0]["why"], "this program <cannot>");
  EXPECT_EQ(json["notes"]["device"], "made-up device");
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
  EXPECT_EQ(keys_of(json["rows"][0]),
            (std::vector<std::string>{"technique", "layers", "size", "kind", "name", "light", "pose", "rmse", "bias",
                                      "max", "head_rmse", "head_bias", "ms", "read_ns", "bytes"}));
  EXPECT_EQ(
      keys_of(json["totals"][0]),
      (std::vector<std::string>{"technique", "layers", "size", "kind", "name", "rmse", "bias", "max", "head_rmse",
                                "head_bias", "worst_light", "worst_pose", "worst_rmse", "ms", "read_ns", "bytes"}));
  for (const char* key : {"truth_aside", "truth_rmse", "truth_compared"}) EXPECT_TRUE(json.contains(key)) << key;
  ASSERT_EQ(json["rows"].size(), 4u);
  EXPECT_EQ(json["rows"][2]["rmse"], 0.12);
  EXPECT_TRUE(json["rows"][2]["head_rmse"].is_null()) << "there is no head";
}

TEST(ShadowSummary, NamesTheBestAndTheSmallestThatIsNearlyAsGood) {
  const std::string text = shadow_summary(made_up_shadows());
  EXPECT_NE(text.find("Nearest to the truth: deep, 4 layers, 512 (RMS 0.10"), std::string::npos) << text;
  EXPECT_NE(text.find("nearly as good: deep, 4 layers, 256"), std::string::npos) << text;
}

TEST(ShadowSummary, TellsTheGainOverAPlainMapOfAsManyBytes) {
  ShadowReport report;
  report.totals = {made_up_total("plain", 0, 256, 0.2), made_up_total("plain", 0, 512, 0.1),
                   made_up_total("deep-shadow", 6, 256, 0.05)};
  report.totals[2].bytes = 2 * report.totals[0].bytes;  // half way: plain has 0.2 / sqrt(2)
  EXPECT_NE(shadow_summary(report).find("as many bytes: 2.83 x (deep-shadow, 6 layers, 256)."), std::string::npos)
      << shadow_summary(report);
  report.totals[2].bytes = 5 * report.totals[0].bytes;
  EXPECT_EQ(shadow_summary(report).find("as many bytes"), std::string::npos) << "no plain map was as large";
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

TEST(ShadowJson, NamesMapsWithAndWithoutTheirSize) {
  const ordered_json json = shadow_json(made_up_heading(), made_up_shadows());
  EXPECT_EQ(json["totals"][3]["kind"], "deep, 4 layers");
  EXPECT_EQ(json["totals"][3]["name"], "deep, 4 layers, 512");
  EXPECT_NE(json["notes"]["method"].get<std::string>().find("1234 points of hair"), std::string::npos);
}

}  // namespace coif::report::order_page_test
