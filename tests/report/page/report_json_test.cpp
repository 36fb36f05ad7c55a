#include "report/page/accuracy_json.h"
#include "report/page/made_up_report.h"
#include "report/page/stability_json.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

using nlohmann::ordered_json;
using Keys = std::vector<std::string>;

Keys keys_of(const ordered_json& object) {
  Keys keys;
  for (const auto& [key, value] : object.items()) keys.push_back(key);
  return keys;
}

const Keys kHeadingKeys = {"asset", "bones", "simulated_bones", "chains", "chain_length_m", "machine", "seconds_taken"};

Keys after_heading(const Keys& keys) {
  Keys all = kHeadingKeys;
  all.insert(all.end(), keys.begin(), keys.end());
  return all;
}

TEST(AccuracyJson, HasTheDocumentedKeys) {
  const ordered_json json = accuracy_json(made_up_heading(), made_up_accuracy());
  EXPECT_EQ(keys_of(json), after_heading({"rows", "spread", "reference", "settle", "budget_rms_pct", "chosen"}));
  EXPECT_EQ(keys_of(json["rows"][0]),
            (Keys{"motion", "solver", "fps", "substeps", "ns_per_bone_frame", "rms_error_pct", "max_error_pct",
                  "stretch_max_pct", "penetration_max_pct", "segment_penetration_max_pct", "pareto"}));
  EXPECT_EQ(keys_of(json["spread"][0]), (Keys{"motion", "solver", "substeps", "frame_rate_spread_pct"}));
  EXPECT_EQ(keys_of(json["reference"][0]), (Keys{"motion", "self_difference_pct", "steps_per_second"}));
  EXPECT_EQ(keys_of(json["settle"][0]), (Keys{"solver", "settle_error_pct"}));
  EXPECT_EQ(keys_of(json["chosen"]), (Keys{"solver", "substeps", "rms_error_pct", "ns_per_bone_frame"}));
}

TEST(AccuracyJson, HoldsEveryRecord) {
  const AccuracyReport report = made_up_accuracy();
  const ordered_json json = accuracy_json(made_up_heading(), report);
  ASSERT_EQ(json["rows"].size(), report.rows.size());
  for (std::size_t i = 0; i < report.rows.size(); ++i) {
    EXPECT_EQ(json["rows"][i]["rms_error_pct"], report.rows[i].rms_error_pct);
    EXPECT_EQ(json["rows"][i]["fps"], report.rows[i].fps);
    EXPECT_EQ(json["rows"][i]["solver"], report.rows[i].solver);
  }
  EXPECT_EQ(json["spread"].size(), report.spread.size());
  EXPECT_EQ(json["reference"].size(), report.reference.size());
  EXPECT_EQ(json["chosen"]["solver"], "coif");
  EXPECT_EQ(json["chain_length_m"]["longest"], 0.5);
}

TEST(AccuracyJson, MissingNumbersAreNull) {
  AccuracyReport report;
  report.rows.resize(1);
  report.spread.resize(1);
  report.reference.resize(1);
  report.settle.resize(1);
  const ordered_json json = accuracy_json({}, report);
  EXPECT_TRUE(json["rows"][0]["rms_error_pct"].is_null());
  EXPECT_TRUE(json["rows"][0]["ns_per_bone_frame"].is_null());
  EXPECT_TRUE(json["spread"][0]["frame_rate_spread_pct"].is_null());
  EXPECT_TRUE(json["reference"][0]["self_difference_pct"].is_null());
  EXPECT_TRUE(json["settle"][0]["settle_error_pct"].is_null());
  EXPECT_TRUE(json["budget_rms_pct"].is_null());
  EXPECT_TRUE(json["chosen"].is_null());
}

TEST(StabilityJson, HasTheDocumentedKeysAndOutcomes) {
  const ordered_json json = stability_json(made_up_heading(), made_up_stability());
  EXPECT_EQ(keys_of(json), after_heading({"cases", "descriptions"}));
  EXPECT_EQ(keys_of(json["cases"][0]), (Keys{"case", "solver", "outcome", "stretch_max_pct", "penetration_max_pct",
                                             "max_speed", "settle_error_pct"}));
  Keys outcomes;
  for (const auto& row : json["cases"]) outcomes.push_back(row["outcome"]);
  EXPECT_EQ(outcomes, (Keys{"ok", "ok", "diverged", "ok", "rejected", "nan"}));
  EXPECT_TRUE(json["cases"][5]["max_speed"].is_null());
  EXPECT_EQ(json["descriptions"][1]["case"], "nan_pose");
}

}  // namespace
}  // namespace coif
