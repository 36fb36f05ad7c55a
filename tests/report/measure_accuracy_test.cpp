#include "report/accuracy/measure_accuracy.h"

#include "lab/hair_segment.h"
#include "motion/head_path.h"
#include "report/stability/measure_stability.h"
#include "research/solver_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::report::measure_accuracy_test {

using Eigen::Vector3d;

class AccuracyTest : public testing::Test {
 protected:
  static AccuracySettings quick() {
    AccuracySettings settings;
    settings.motions = {motion::Motion::kNod, motion::Motion::kJump};
    settings.fps = {30, 60};
    settings.substeps = {1, 2};
    settings.seconds = 1;
    settings.solvers = {"coif", "thesis", "xpbd"};
    return settings;
  }
  tl::expected<AccuracyReport, ToolError> measure(const AccuracySettings& settings) {
    return measure_accuracy(hair_.asset(), settings, [this](const std::string&) { ++told_; });
  }

  StressAsset hair_{StressRig{.bones_per_chain = 4}};
  int told_ = 0;
};

TEST_F(AccuracyTest, HasARowForEverySettingAndFindsTheDefaultSolverNearTheReference) {
  const auto report = measure(quick());
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->rows.size(), 2u * 2 * (2 + 2 + 6));
  EXPECT_GT(told_, 2);
  for (const AccuracyRow& row : report->rows) {
    EXPECT_GT(row.ns_per_bone_frame, 0);
    EXPECT_GE(row.max_error_pct, row.rms_error_pct);
    EXPECT_GE(row.stretch_max_pct, 0);
    EXPECT_TRUE(std::isfinite(row.penetration_max_pct));
    if (row.solver != "coif") continue;
    EXPECT_LT(row.rms_error_pct, 2);
    EXPECT_LT(row.stretch_max_pct, 0.01);
  }
  EXPECT_EQ(report->reference.size(), 2u);
  for (const ReferenceRow& row : report->reference) EXPECT_LT(row.self_difference_pct, 0.05);
  ASSERT_TRUE(report->chosen);
  EXPECT_EQ(report->chosen->solver, "coif");
}

TEST_F(AccuracyTest, ErrorFallsWithTheFrameRateAndWithSubsteps) {
  const auto report = measure(quick());
  ASSERT_TRUE(report);
  const auto error = [&report](double fps, std::uint32_t substeps) {
    for (const AccuracyRow& row : report->rows) {
      if (row.solver == "coif" && row.motion == "nod" && row.fps == fps && row.substeps == substeps) {
        return row.rms_error_pct;
      }
    }
    return -1.0;
  };
  EXPECT_LT(error(60, 1), error(30, 1));
  EXPECT_LT(error(30, 2), error(30, 1));
  EXPECT_GT(error(60, 2), 0);
}

TEST_F(AccuracyTest, ToldVelocitiesTakeOutWhatSubstepsCannot) {
  AccuracySettings settings = quick();
  settings.motions = {motion::Motion::kCharge};
  settings.fps = {30};
  settings.substeps = {16};
  settings.solvers = {"coif", "thesis"};
  const auto guessed = measure(settings);
  settings.tells_velocities = true;
  const auto told = measure(settings);
  ASSERT_TRUE(guessed && told);
  EXPECT_LT(told->rows[0].rms_error_pct, 0.2 * guessed->rows[0].rms_error_pct);
  EXPECT_EQ(told->rows[1].rms_error_pct, guessed->rows[1].rms_error_pct) << "Algorithm 1 has no use for them";
}

TEST_F(AccuracyTest, FrontOfEachMotionAndRateIsWhatNothingBeats) {
  const auto report = measure(quick());
  ASSERT_TRUE(report);
  for (const AccuracyRow& row : report->rows) {
    const bool beaten = std::ranges::any_of(report->rows, [&row](const AccuracyRow& other) {
      return other.motion == row.motion && other.fps == row.fps && other.rms_error_pct < row.rms_error_pct &&
             other.ns_per_bone_frame < row.ns_per_bone_frame;
    });
    EXPECT_EQ(row.pareto, !beaten) << row.solver << " x" << row.substeps;
  }
}

TEST_F(AccuracyTest, SettlesWhereTheModelHangs) {
  const auto report = measure(quick());
  ASSERT_TRUE(report);
  ASSERT_EQ(report->settle.size(), 3u);
  EXPECT_LT(report->settle[0].settle_error_pct, 0.01);  // coif
  EXPECT_GT(report->settle[1].settle_error_pct, 0.1);   // thesis: pulls at parents, and stretches
}

TEST_F(AccuracyTest, AClipOfAMotionMeasuresLikeTheMotion) {
  AccuracySettings settings = quick();
  settings.motions = {motion::Motion::kNod};
  const auto nod = motion::path_of(motion::Motion::kNod);
  std::vector<motion::ClipKey> keys;
  for (int i = 0; i <= 240; ++i) keys.push_back({i / 120.0, nod->at(i / 120.0).position, nod->at(i / 120.0).rotation});
  settings.clip = NamedPath{"nod.glb:head", motion::path_of(keys)};
  const auto report = measure(settings);
  ASSERT_TRUE(report) << report.error().message;
  const std::size_t half = report->rows.size() / 2;
  ASSERT_EQ(half, 2u * (2 + 2 + 6));
  for (std::size_t i = 0; i < half; ++i) {
    const AccuracyRow &built_in = report->rows[i], &clip = report->rows[half + i];
    EXPECT_EQ(built_in.motion, "nod");
    EXPECT_EQ(clip.motion, "nod.glb:head");
    EXPECT_NEAR(clip.rms_error_pct, built_in.rms_error_pct, 1e-3 + 0.01 * built_in.rms_error_pct) << clip.solver;
  }
}

TEST_F(AccuracyTest, AClipAloneReplacesTheSuite) {
  AccuracySettings settings = quick();
  settings.motions.clear();
  settings.clip = NamedPath{"clip", motion::path_of(motion::Motion::kRun)};
  const auto report = measure(settings);
  ASSERT_TRUE(report) << report.error().message;
  EXPECT_EQ(report->reference.size(), 1u);
}

TEST_F(AccuracyTest, ExplosionsAreRowsWithoutNumbers) {
  AccuracySettings settings = quick();
  settings.motions = {motion::Motion::kTumble};
  settings.fps = {10, 15};
  settings.seconds = 4;
  settings.solvers = {"mass-spring"};
  const auto report = measure(settings);
  ASSERT_TRUE(report);
  const auto exploded = std::ranges::count_if(report->rows, [](const AccuracyRow& row) {
    return !(row.rms_error_pct < 1000) && !row.pareto == !std::isfinite(row.rms_error_pct);
  });
  EXPECT_GT(exploded, 0);
  EXPECT_FALSE(report->chosen) << "it does not ship";
}

TEST_F(AccuracyTest, RefusesWhatCannotBeMeasured) {
  AccuracySettings settings = quick();
  settings.solvers = {"magic"};
  ASSERT_FALSE(measure(settings));
  EXPECT_EQ(measure(settings).error().kind, ToolError::Kind::kUsage);
  EXPECT_NE(measure(settings).error().message.find("'magic' is not a solver; there are coif, cascade, passive, thesis"),
            std::string::npos);
  for (const auto spoil : {+[](AccuracySettings& s) { s.seconds = 61; }, +[](AccuracySettings& s) { s.fps = {0}; },
                           +[](AccuracySettings& s) { s.fps.clear(); }, +[](AccuracySettings& s) { s.substeps = {65}; },
                           +[](AccuracySettings& s) { s.seconds = std::nan(""); }}) {
    AccuracySettings spoiled = quick();
    spoil(spoiled);
    ASSERT_FALSE(measure(spoiled));
    EXPECT_EQ(measure(spoiled).error().kind, ToolError::Kind::kUsage);
  }
  const StressAsset bald(StressRig{.chains = 0});
  ASSERT_TRUE(bald.is_open());
  const auto report = measure_accuracy(bald.asset(), quick(), nullptr);
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ToolError::Kind::kBadInput);
}

TEST(FrameTimes, HoldEveryFrameOfEveryRateOnce) {
  const double rates[] = {24, 30, 59.94};
  const std::vector<double> times = frame_times(rates, 1);
  EXPECT_EQ(times.size(), 25u + 31 + 60 - 7 - 1);  // 24 and 30 meet six times a second, and all of them at 0
  EXPECT_TRUE(std::ranges::is_sorted(times));
  for (const double fps : rates) {
    for (int frame = 0; frame / fps <= 1; ++frame) EXPECT_TRUE(std::ranges::binary_search(times, frame / fps)) << fps;
  }
}

TEST(ConstraintMeter, SeesStretchAndDepthAndKeepsTheWorst) {
  lab::Rig rig = research::strand_rig(1);
  rig.bones[0].rest_direction = -Vector3d::UnitY();
  rig.bones[0].length = 0.1;
  rig.bones[0].colliders = 1;
  rig.bones[0].hit_radius = 0.01;
  rig.colliders.push_back(research::sphere(Vector3d(0, -0.2, 0), 0.05));
  lab::ConstraintMeter meter(rig);
  ASSERT_TRUE(meter.sees_colliders());
  const std::vector<Vector3d> stretched{Vector3d(0, 0, 0.13)}, inside{Vector3d(0, -0.15, 0)}, good{Vector3d(0, 0, 0.1)};
  meter.look(stretched);
  EXPECT_NEAR(meter.worst().stretch, 0.3, 1e-12);
  EXPECT_EQ(meter.worst().point_depth, 0);
  meter.look(inside);
  meter.look(good);
  EXPECT_NEAR(meter.worst().stretch, 0.5, 1e-12);
  EXPECT_NEAR(meter.worst().point_depth, 0.01 / 0.05, 1e-6);
  EXPECT_NEAR(meter.worst().segment_depth, 0.01 / 0.05, 1e-6);
}

TEST(ConstraintMeter, NeverForgetsWhatWasNotANumber) {
  const lab::Rig rig = research::strand_rig(1);
  lab::ConstraintMeter meter(rig);
  const std::vector<Vector3d> broken{Vector3d::Constant(std::nan(""))}, good{rig.bones[0].rest_direction * 0.08};
  meter.look(broken);
  meter.look(good);
  EXPECT_TRUE(std::isnan(meter.worst().stretch));
}

}  // namespace coif::report::measure_accuracy_test
