// Both ends of every range that hosts may say something from: they belong to it, and nothing beyond them does.

#include "models/test_rig.h"

#include <coif/hair_world.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace coif::argument_ranges_test {

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();
constexpr float kInfinity = std::numeric_limits<float>::infinity(), kLargest = std::numeric_limits<float>::max();

/// `status_of` says the number to a hair and returns what that answers.
void expect_range(const char* name, float lowest, float highest, const std::function<Status(float)>& status_of,
                  Status refusal = Status::kBadArgument) {
  EXPECT_EQ(status_of(lowest), Status::kOk) << name;
  EXPECT_EQ(status_of(highest), Status::kOk) << name;
  EXPECT_EQ(status_of(std::nextafter(lowest, -kInfinity)), refusal) << name;
  EXPECT_EQ(status_of(kNaN), refusal) << name;
  if (highest < kInfinity) {
    EXPECT_EQ(status_of(std::nextafter(highest, kInfinity)), refusal) << name;
  }
}

TEST(ArgumentRanges, OfStepSettings) {
  TestHair test(nine_bone_rig());
  const auto setting = [&](const char* name, float lowest, float highest, float& (*field)(StepSettings&),
                           Status refusal = Status::kBadArgument) {
    const auto status_of = [&](float value) {
      StepSettings settings;
      field(settings) = value;
      return test.hair.step(settings);
    };
    expect_range(name, lowest, highest, status_of, refusal);
  };
  using S = StepSettings;
  setting(
      "dt", 0, kLargest, [](S& s) -> float& { return s.dt; }, Status::kBadTimeStep);
  setting("inertia", 0, 1, [](S& s) -> float& { return s.inertia; });
  setting("air_follow", 0, 1, [](S& s) -> float& { return s.environment.air_follow; });
  setting("stiffness", 0, kMostScale, [](S& s) -> float& { return s.dynamics.stiffness; });
  setting("damping", 0, kMostScale, [](S& s) -> float& { return s.dynamics.damping; });
  setting("friction", 0, kMostScale, [](S& s) -> float& { return s.dynamics.friction; });
  setting("teleport_distance", 0, kInfinity, [](S& s) -> float& { return s.teleport_distance; });
  setting("teleport_angle", 0, kInfinity, [](S& s) -> float& { return s.teleport_angle; });
  setting("sleep_after", 0, kInfinity, [](S& s) -> float& { return s.sleep_after; });
  setting("sleep_speed", 0, kInfinity, [](S& s) -> float& { return s.sleep_speed; });
}

TEST(ArgumentRanges, OfNumbersOfParts) {
  TestHair test(nine_bone_rig());
  const auto with = [&](std::uint32_t substeps, std::uint32_t iterations, std::uint32_t true_gravity) {
    StepSettings settings{.substeps = substeps, .iterations = iterations};
    settings.environment.true_gravity = true_gravity;
    return test.hair.step(settings);
  };
  for (const std::uint32_t good : {0u, 1u, 64u}) EXPECT_EQ(with(good, 1, 0), Status::kOk) << good;
  for (const std::uint32_t good : {1u, 64u}) EXPECT_EQ(with(1, good, 1), Status::kOk) << good;
  for (const std::uint32_t bad : {65u, kNone}) EXPECT_EQ(with(bad, 1, 0), Status::kBadArgument) << bad;
  for (const std::uint32_t bad : {0u, 65u, kNone}) EXPECT_EQ(with(1, bad, 0), Status::kBadArgument) << bad;
  for (const std::uint32_t bad : {2u, kNone}) EXPECT_EQ(with(1, 1, bad), Status::kBadArgument) << bad;
}

TEST(ArgumentRanges, OfAirAndDynamics) {
  TestHair test(nine_bone_rig(), {.instances = 2,
                                  .solver = &kCharacterSolver,
                                  .dynamics_sets = 2,
                                  .moving_colliders = 3,
                                  .has_own_air = true,
                                  .feels_gusts = true});
  Hair& hair = test.hair;
  expect_range("exposure", 0, 1, [&](float x) { return hair.set_air(0, {.exposure = x}); });
  expect_range("amplitude", 0, 1000, [&](float x) { return hair.set_gusts({.amplitude = x}); });
  expect_range("length", 0.05f, 1e4f, [&](float x) { return hair.set_gusts({.length = x}); });
  expect_range("speed", 0, 1000, [&](float x) { return hair.set_gusts({.speed = x}); });
  expect_range("stiffness", 0, kMostScale, [&](float x) { return hair.set_dynamics(1, {.stiffness = x}); });
  expect_range("damping", 0, kMostScale, [&](float x) { return hair.set_dynamics(1, {.damping = x}); });
  expect_range("friction", 0, kMostScale, [&](float x) { return hair.set_dynamics(1, {.friction = x}); });
  const float least = std::numeric_limits<float>::denorm_min();
  expect_range("radius", least, kLargest, [&](float x) { return hair.push(0, {.radius = x}); });
  expect_range(
      "seconds", 0, 600, [&](float x) { return hair.settle(0, x, {.sleep_after = 0}); }, Status::kBadTimeStep);
  for (const std::uint32_t set : {0u, 1u, 2u, kNone}) {
    EXPECT_EQ(hair.set_dynamics(set, {}), set < 2 ? Status::kOk : Status::kNotAsked) << set;
    EXPECT_EQ(hair.choose_dynamics(1, set), set < 2 ? Status::kOk : Status::kNotAsked) << set;
  }
  for (const std::size_t count : {0u, 3u, 4u}) {
    const std::vector<MovingCollider> all(count);
    EXPECT_EQ(hair.set_colliders(1, all), count <= 3 ? Status::kOk : Status::kNotAsked) << count;
  }
}

TEST(ArgumentRanges, OfRotations) {
  TestHair test(nine_bone_rig());
  for (const float length : {0.9991f, 1.0f, 1.0009f}) {
    EXPECT_EQ(test.hair.set_head(0, {{}, {0, 0, 0.6f * length, 0.8f * length}}), Status::kOk) << length;
  }
  for (const float length : {0.99895f, 1.00105f}) {
    EXPECT_EQ(test.hair.set_head(0, {{}, {0, 0, 0.6f * length, 0.8f * length}}), Status::kBadPose) << length;
  }
}

TEST(ArgumentRanges, OfWhatACrowdAndAWorldAreMadeFor) {
  TestHair test(nine_bone_rig());
  const auto has_room = [&](const HairDesc& desc) { return Hair::memory_need(test.asset, desc).bytes != 0; };
  for (const std::uint32_t good : {1u, 1'000'000u}) EXPECT_TRUE(has_room({.instances = good}));
  for (const std::uint32_t bad : {0u, 1'000'001u, kNone}) EXPECT_FALSE(has_room({.instances = bad}));
  for (const std::uint32_t good : {1u, 8u}) EXPECT_TRUE(has_room({.dynamics_sets = good}));
  for (const std::uint32_t bad : {0u, 9u, kNone}) EXPECT_FALSE(has_room({.dynamics_sets = bad}));
  for (std::uint32_t interval = 0; interval < 10; ++interval) {
    EXPECT_EQ(has_room({.longest_interval = interval}), interval == 1 || interval == 2 || interval == 4) << interval;
  }
  for (const std::uint32_t good : {0u, 16u})
    EXPECT_TRUE(has_room({.solver = &kCharacterSolver, .moving_colliders = good}));
  for (const std::uint32_t bad : {17u, kNone})
    EXPECT_FALSE(has_room({.solver = &kCharacterSolver, .moving_colliders = bad}));
  const auto has_world = [](const WorldDesc& desc) { return HairWorld::memory_need(desc).bytes != 0; };
  for (const std::uint32_t good : {1u, 1'000'000u}) EXPECT_TRUE(has_world({.heads = good}));
  for (const std::uint32_t bad : {0u, 1'000'001u}) EXPECT_FALSE(has_world({.heads = bad}));
  for (const std::uint32_t good : {1u, kMaxWorldAssets}) EXPECT_TRUE(has_world({.assets = good}));
  for (const std::uint32_t bad : {0u, kMaxWorldAssets + 1}) EXPECT_FALSE(has_world({.assets = bad}));
}

}  // namespace coif::argument_ranges_test
