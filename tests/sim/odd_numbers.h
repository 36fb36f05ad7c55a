#pragma once
// What a game could call a world with, and how: mostly sound values, and now and then numbers that no game means.

#include "models/playback.h"

#include <coif/hair_world.h>

#include <cfenv>
#include <iterator>
#include <limits>
#include <random>
#include <vector>

namespace coif {

/// Values drawn by lot, the same everywhere.
class OddNumbers {
 public:
  explicit OddNumbers(std::uint32_t seed) : lot_(seed) {}

  std::uint32_t below(std::uint32_t count) { return std::uint32_t(lot_() % count); }
  bool one_in(std::uint32_t count) { return below(count) == 0; }
  float between(float low, float high) { return low + (high - low) * float(below(1u << 16)) / 65535.0f; }
  /// Every fortieth is odd.
  float number(float low, float high) { return one_in(40) ? odd() : between(low, high); }
  double metres(double reach) {
    if (one_in(120)) return std::vector{1e17, 1e300, -1e30, 4e5}[below(4)];
    return one_in(150) ? double(odd()) : double(between(-1, 1)) * reach;
  }
  float odd() {
    using Limits = std::numeric_limits<float>;
    const float odd[] = {Limits::quiet_NaN(),
                         Limits::infinity(),
                         -Limits::infinity(),
                         Limits::max(),
                         Limits::lowest(),
                         1e30f,
                         -1e20f,
                         Limits::denorm_min(),
                         Limits::min(),
                         -0.0f,
                         -1,
                         1e6f};
    return odd[below(std::size(odd))];
  }
  Vec3 vector(float reach) { return {number(-reach, reach), number(-reach, reach), number(-reach, reach)}; }
  Quat rotation() {
    if (one_in(60)) return {number(-1, 1), odd(), number(-1, 1), number(-1, 1)};
    return Violence(below(1u << 16) + 1).next().rotation;
  }
  HeadPose pose() {
    HeadPose pose = one_in(3) ? HeadPose{} : wander(double(below(200)) * 0.02);
    if (one_in(4)) pose = {{metres(0.5), metres(0.5), metres(0.5)}, rotation()};
    if (one_in(8)) pose.scale = one_in(4) ? number(kSmallestScale, kLargestScale) : number(0.5f, 2);
    return pose;
  }
  MovingCollider collider() {
    MovingCollider collider{.shape = ColliderShape(below(one_in(30) ? 256 : 6)), .rotation = rotation()};
    for (double& place : collider.center) place = metres(0.5);
    collider.axis = vector(0.2f);
    collider.radius = number(0, 0.06f);
    collider.end_radius = number(0, 0.06f);
    collider.half_extents = {number(0, 0.06f), number(0, 0.06f), number(0, 0.06f)};
    collider.is_velocity_known = one_in(3);
    collider.velocity = {vector(2), vector(5)};
    return collider;
  }
  Impulse impulse() {
    return {.center = {metres(0.3), metres(0.3), metres(0.3)},
            .axis = one_in(2) ? vector(0.3f) : Vec3{},
            .radius = number(0.1f, 1),
            .speed = number(-5, 5),
            .velocity = vector(3),
            .strokes = one_in(3)};
  }
  DynamicsScale dynamics() { return {number(0, 3), number(0, 3), number(0, 3)}; }
  StepSettings settings() {
    StepSettings settings{.dt = one_in(12) ? number(0, 1) : between(0.01f, 0.03f)};
    if (one_in(10)) settings.dt = one_in(2) ? 0 : std::numeric_limits<float>::max();
    if (one_in(4)) settings.substeps = one_in(30) ? below(80) : below(5);
    if (one_in(20)) settings.iterations = below(4);
    if (one_in(10)) settings.environment.gravity = vector(10);
    if (one_in(6)) settings.environment.wind = vector(8);
    if (one_in(10)) settings.environment.air_follow = number(0, 1);
    if (one_in(10)) settings.environment.true_gravity = below(one_in(9) ? 3 : 2);
    if (one_in(10)) settings.dynamics = dynamics();
    if (one_in(6)) settings.inertia = number(0, 1);
    if (one_in(20)) settings.teleport_distance = number(0, 5);
    settings.sleep_after = one_in(20) ? number(0, 1) : 0.05f;
    settings.sleep_speed = one_in(20) ? number(0, 1) : 1.5f;
    return settings;
  }

 private:
  std::mt19937 lot_;
};

/// What a host's thread may have chosen for floating point while it calls.
class HostsChoice {
 public:
  explicit HostsChoice(std::uint32_t choice) {
    std::fegetenv(&usual_);
    if (choice == 0) return;
    constexpr int kModes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
    std::fesetround(kModes[choice % 4]);
#if defined(__GLIBC__)
    if (choice >= 4) (void)feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
  }
  ~HostsChoice() { std::fesetenv(&usual_); }
  HostsChoice(const HostsChoice&) = delete;
  HostsChoice& operator=(const HostsChoice&) = delete;

 private:
  std::fenv_t usual_;
};

}  // namespace coif
