// A hand in the hair, beside the same at far shorter steps.

#include "report/accuracy/stroke.h"
#include "report/stability/measure_stability.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::report::stroke_test {

TEST(Stroke, IsMoreExactWithMoreFramesAndTouchesNoBone) {
  for (const ChainModel model : {ChainModel::kCascade, ChainModel::kPassive}) {
    const StressAsset hair(StressRig{.bones_per_chain = 5, .bone_length = 0.06, .head_radius = 0.1}, model);
    StrokeSettings settings{.fps = {30, 240}, .substeps = {1, 2}, .seconds = 1};
    settings.reference_steps_per_second = 1920;
    const auto rows = measure_stroke(hair.asset(), settings);
    ASSERT_EQ(rows.size(), 4u);
    for (const StrokeRow& row : rows) {
      EXPECT_LE(row.penetration_max_pct, 0.01) << row.fps;
      EXPECT_LT(row.stretch_max_pct, 1e-2) << row.fps;
      EXPECT_TRUE(std::isfinite(row.rms_error_pct));
      EXPECT_LE(row.rms_error_pct, row.max_error_pct);
      EXPECT_EQ(row.self_difference_pct, rows[0].self_difference_pct);
    }
    EXPECT_EQ(rows[0].fps, 30);
    EXPECT_EQ(rows[3].fps, 240);
    EXPECT_EQ(rows[3].substeps, 2u);
    EXPECT_LT(rows[3].rms_error_pct, rows[0].rms_error_pct);
    EXPECT_GT(rows[0].of_motion_pct, 0) << "the hand moves the hair";
  }
}

}  // namespace coif::report::stroke_test
