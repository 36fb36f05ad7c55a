#include "animation/glb_reader.h"
#include "base/json.h"
#include "report/accuracy/accuracy_report.h"
#include "report/made_up_report.h"
#include "report/page/report_heading.h"
#include "report/stability/stability_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coif::report::report_json_test {

TEST(NumberText, IsADashWhereThereIsNoNumber) {
  for (const double none : {std::nan(""), HUGE_VAL, -HUGE_VAL}) {
    EXPECT_EQ(number_text(none), "-");
    EXPECT_EQ(percent_text(none), "-");
    EXPECT_TRUE(number_json(none).is_null());
  }
  EXPECT_EQ(percent_text(12.34), "12.3 %");
  EXPECT_EQ(number_json(0.5), 0.5);
}

TEST(NumberText, IsNearTheNumberAtEverySize) {
  for (double number = 1.3e-4; number < 1.0e12; number *= 7.7) {
    for (const double signed_number : {number, -number}) {
      EXPECT_NEAR(std::stod(number_text(signed_number)), signed_number, 0.04 * number) << number_text(signed_number);
    }
    if (number > 1.0e-3 && number < 1.0e6) {
      EXPECT_EQ(number_text(number).find('e'), std::string::npos) << number_text(number);
    }
  }
  EXPECT_EQ(number_text(0), "0");
  EXPECT_EQ(number_text(1.0e-14), "<0.0001");
}

TEST(ReportHeading, MeasuresChainsFromTheRigidBoneToTheirFurthestTip) {
  const animation::OpenAsset file(small_asset());  // a chain of two bones and one of one bone, 0.1 m each
  ASSERT_TRUE(file.asset().is_open());
  const ReportHeading heading = heading_of(file.asset(), "small.coif");
  EXPECT_EQ(heading.asset, "small.coif");
  EXPECT_EQ(heading.bones, 5u);
  EXPECT_EQ(heading.simulated_bones, 3u);
  EXPECT_EQ(heading.chains, 2u);
  EXPECT_NEAR(heading.shortest_chain, 0.1, 1.0e-6);
  EXPECT_NEAR(heading.longest_chain, 0.2, 1.0e-6);
}

TEST(ReportHeading, IsOneLineEvenWhereTheMachineIsNotKnown) {
  ReportHeading heading;
  heading.asset = "a.coif";
  heading.chains = 1;
  EXPECT_EQ(heading_text(heading),
            "a.coif: 0 bones, 0 of them simulated, in 1 chain of 0 to 0 m (median 0); measured in 0.0 s");
  heading.machine = "processor";
  EXPECT_TRUE(heading_text(heading).ends_with(" s on processor"));
}

using nlohmann::ordered_json;
const Keys kHeadingKeys = {"asset", "bones", "simulated_bones", "chains", "chain_length_m", "machine", "seconds_taken"};

/// The heading's keys, those of the report, and those that every report ends with.
Keys with_heading(const Keys& keys) {
  Keys all = kHeadingKeys;
  all.insert(all.end(), keys.begin(), keys.end());
  for (const char* key : {"report", "title", "about", "finding", "view", "columns"}) all.emplace_back(key);
  return all;
}

TEST(AccuracyJson, HasTheDocumentedKeys) {
  const ordered_json json = accuracy_json(made_up_heading(), made_up_accuracy());
  EXPECT_EQ(keys_of(json), with_heading({"rows", "spread", "reference", "own_reference", "settle", "swings", "stroke",
                                         "conditioned_share", "tells_velocities", "budget_rms_pct", "chosen",
                                         "main_fps", "means", "swing_chain", "swing_path", "view_motions", "notes"}));
  EXPECT_EQ(keys_of(json["rows"][0]), (Keys{"motion",
                                            "solver",
                                            "fps",
                                            "substeps",
                                            "ns_per_bone_frame",
                                            "code",
                                            "rms_error_pct",
                                            "own_error_pct",
                                            "model_distance_pct",
                                            "max_error_pct",
                                            "worst_second_pct",
                                            "of_motion_pct",
                                            "stretch_max_pct",
                                            "penetration_max_pct",
                                            "segment_penetration_max_pct",
                                            "pareto",
                                            "cost_falls",
                                            "setting",
                                            "fewest_steps",
                                            "shown_first"}));
  EXPECT_EQ(keys_of(json["spread"][0]), (Keys{"motion", "solver", "substeps", "setting", "frame_rate_spread_pct"}));
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
  EXPECT_EQ(keys_of(json), with_heading({"cases", "descriptions", "totals", "outcomes"}));
  EXPECT_EQ(keys_of(json["cases"][0]),
            (Keys{"case", "solver", "outcome", "stretch_max_pct", "penetration_max_pct", "limit_max_rad",
                  "link_stretch_max_pct", "max_speed", "rest_speed", "settle_error_pct"}));
  Keys outcomes;
  for (const auto& row : json["cases"]) outcomes.push_back(row["outcome"]);
  EXPECT_EQ(outcomes, (Keys{"ok", "ok", "diverged", "ok", "rejected", "nan"}));
  EXPECT_TRUE(json["cases"][5]["max_speed"].is_null());
  EXPECT_EQ(json["descriptions"][1]["case"], "nan_pose");
}

}  // namespace coif::report::report_json_test
