// The same input gives the same bits, whoever else is simulated.

#include "sim/playback.h"

#include <gtest/gtest.h>

#include <cstring>

namespace coif {
namespace {

TestRig rig() {
  TestRig rig = calm_strand(5, 0.3f);
  rig.add_ellipsoid({0, 0, 0}, {0.09f, 0.13f, 0.11f});
  rig.add_tapered_capsule({-0.1f, -0.2f, -0.1f}, 0.05f, {0.1f, -0.2f, -0.1f}, 0.03f);
  return rig;
}

/// A minute of a game: irregular frames, sub-steps, a teleport.
void play_a_while(Hair& hair, std::uint32_t instance, int frames = 400) {
  Violence random(21);
  double now = 0;
  for (int frame = 0; frame < frames; ++frame) {
    StepSettings settings{.dt = float(random.between(0.003, 0.05)), .substeps = 1 + std::uint32_t(frame) / 100};
    now += settings.dt;
    const HeadPose pose = wander(now);
    ASSERT_EQ(frame == 200 ? hair.teleport(instance, {{9, 9, 9}, {}}) : hair.set_head(instance, pose), Status::kOk);
    ASSERT_EQ(hair.step(settings), Status::kOk);
  }
}

void expect_same_bits(const Hair& a, std::uint32_t of_a, const Hair& b, std::uint32_t of_b) {
  const auto first = a.palette(of_a), second = b.palette(of_b);
  ASSERT_EQ(first.size(), second.size());
  ASSERT_GT(first.size(), 1u);
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size_bytes()), 0);
}

TEST(Determinism, TheSameInputTwiceGivesTheSameBits) {
  TestHair a(rig()), b(rig());
  play_a_while(a.hair, 0);
  play_a_while(b.hair, 0);
  expect_same_bits(a.hair, 0, b.hair, 0);
  EXPECT_EQ(largest_distance(a.ends(), b.ends()), 0.0f);
}

TEST(Determinism, OtherInstancesBesideItChangeNoBit) {
  TestHair alone(rig()), crowd(rig(), 7);
  play_a_while(alone.hair, 0);
  for (std::uint32_t i = 0; i < 7; ++i)
    ASSERT_EQ(crowd.hair.reset(i, i == 4 ? HeadPose{} : HeadPose{{1.0 * i, 2, 3}, turned_about({0, 1, 0}, i)}),
              Status::kOk);
  play_a_while(crowd.hair, 4);
  expect_same_bits(alone.hair, 0, crowd.hair, 4);
}

TEST(Determinism, ResetForgetsEverything) {
  TestHair used(rig()), fresh(rig());
  play_a_while(used.hair, 0);
  ASSERT_EQ(used.hair.reset(0, {}), Status::kOk);
  play_a_while(used.hair, 0, 20);  // before damping makes them one
  play_a_while(fresh.hair, 0, 20);
  expect_same_bits(used.hair, 0, fresh.hair, 0);
}

}  // namespace
}  // namespace coif
