// The runtime beside a known motion, frame by frame.

#include "lab/measure_runtime.h"

#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <array>

namespace coif::lab::measure_runtime_test {

class MeasureRuntime : public testing::Test {
 protected:
  [[nodiscard]] KnownMotion known(std::span<const std::uint32_t> rates, double seconds) const {
    ReferenceSettings settings;
    settings.sample_times = frame_times(rates, seconds);
    return {motion::Motion::kCharge, solve_reference(rig_, {}, *motion::path_of(motion::Motion::kCharge), settings)};
  }

  OpenedAsset opened_{nine_bone_rig().contents()};
  Rig rig_ = rig_of(opened_.asset());
};

TEST(FrameTimes, AreThoseOfEveryRateEachOnce) {
  constexpr std::uint32_t kRates[] = {2, 3};
  const std::vector<double> times = frame_times(kRates, 1);
  ASSERT_EQ(times.size(), 4u);
  constexpr double kExpected[] = {1.0 / 3, 0.5, 2.0 / 3, 1};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(times[i], kExpected[i], 1e-12);
  constexpr std::uint32_t kNested[] = {30, 60, 120};
  EXPECT_EQ(frame_times(kNested, 2).size(), 240u) << "rounding makes no second moment of one";
}

TEST_F(MeasureRuntime, LooksAtEveryFrameOfARateAmongOthers) {
  constexpr std::uint32_t kAlone[] = {24}, kMixed[] = {24, 25, 60};
  const RuntimeError alone = measure_runtime(opened_.asset(), rig_, known(kAlone, 2), 24, 2);
  const RuntimeError mixed = measure_runtime(opened_.asset(), rig_, known(kMixed, 2), 24, 2);
  EXPECT_GT(alone.rms, 1e-4);
  EXPECT_NEAR(alone.rms, mixed.rms, 1e-4 * alone.rms) << "other rates' frames are not its own";
  EXPECT_NEAR(alone.max, mixed.max, 1e-4 * alone.max);
}

TEST_F(MeasureRuntime, OfFramesBetweenKnownTimesOnlyTheKnownCount) {
  constexpr std::uint32_t kSlow[] = {30}, kFast[] = {60};
  const RuntimeError some = measure_runtime(opened_.asset(), rig_, known(kSlow, 2), 60, 2);
  const RuntimeError all = measure_runtime(opened_.asset(), rig_, known(kFast, 2), 60, 2);
  EXPECT_LE(some.max, all.max * 1.0001);
  EXPECT_NEAR(some.rms, all.rms, 0.2 * all.rms);
}

TEST_F(MeasureRuntime, TheWorstSecondOfAChargeIsItsFirst) {
  constexpr std::uint32_t kRate[] = {30};
  const RuntimeError first = measure_runtime(opened_.asset(), rig_, known(kRate, 1), 30, 1);
  const RuntimeError whole = measure_runtime(opened_.asset(), rig_, known(kRate, 4), 30, 1);
  EXPECT_NEAR(first.worst_second, first.rms, 1e-9);
  EXPECT_NEAR(whole.worst_second, first.rms, 0.02 * first.rms);
  EXPECT_GT(whole.worst_second, 1.5 * whole.rms);
  EXPECT_LE(whole.worst_second, whole.max);
}

}  // namespace coif::lab::measure_runtime_test
