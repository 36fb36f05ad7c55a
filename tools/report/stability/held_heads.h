#pragma once

#include <coif/asset.h>

#include <cstdint>
#include <string>
#include <vector>

namespace coif::report {

/// Heads that are turned within 0.8 s and then held: their up axes point to the corners, edges and faces of a cube, 26
/// attitudes. Hair of such a head must come to rest, and stay there.
struct HeldHeads {
  std::uint32_t substeps = 0;                      ///< Per frame; 0: as many as the asset was tuned for.
  double frame_rate = 60;                          ///< Hz.
  double seconds = 30;                             ///< Time watched, the turn included; more than kSettlingTime.
  bool collides = true;                            ///< False: without the asset's colliders.
  float stiffness = 1, damping = 1, friction = 1;  ///< Factors, as DynamicsScale.
};

/// Seconds after which hair of a held head is at rest: the longest that hair of artists' files takes, rounded up. It is
/// tied hair, which is little damped, that slides off a place where it was nearly balanced.
inline constexpr double kSettlingTime = 13;
/// Slower is at rest, m/s.
inline constexpr double kAtRest = 0.02;

struct HeldHeadsFinding {
  double settled_after = 0;  ///< The last moment, s, at which a bone's end was faster than kAtRest against its head.
  double max_speed = 0;      ///< Fastest end of a bone relative to its head, m/s.
  double rest_speed = 0;     ///< The same after kSettlingTime.
  int up[3] = {0, 1, 0};     ///< The attitude with that: where the head's up axis points.
  bool is_finite = true;

  [[nodiscard]] bool is_restless() const { return !is_finite || rest_speed > kAtRest; }
};

/// Runs all of them at once, a crowd of 26. `asset` must be open and have hair that moves.
[[nodiscard]] HeldHeadsFinding hold_heads(const Asset& asset, const HeldHeads& held);

/// "held, 4 parts at 144 fps, no colliders".
[[nodiscard]] std::string name_of(const HeldHeads& held);

/// All settings for a run: 1, 2, 4, 8 parts and as tuned, at 30, 60 and 144 frames per second, with colliders if the
/// asset has some, and without. Leaves out the last ones if all would take more than `most_bone_steps`.
[[nodiscard]] std::vector<HeldHeads> ways_to_hold(const Asset& asset, std::uint64_t most_bone_steps);

}  // namespace coif::report
