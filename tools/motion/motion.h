#pragma once

#include <coif/math.h>

#include <optional>
#include <span>
#include <string_view>

namespace coif {

/// A head's built-in movement, defined for every time; starts at rest at the origin (y = 0) at t = 0.
enum class Motion { kStill, kNod, kTurn, kCharge, kRun, kJump, kTumble, kTeleport };

struct MotionInfo {
  Motion motion;
  const char* name;         ///< As on the command line.
  const char* description;  ///< One line with the figures: angles, rates, speeds.
};

[[nodiscard]] std::span<const MotionInfo> all_motions();
[[nodiscard]] std::optional<Motion> find_motion(std::string_view name);

/// The pose of the head at `seconds`, world; before 0 as at 0. Position and rotation are continuous, and so is their
/// velocity, except where kTeleport jumps.
[[nodiscard]] HeadPose head_pose(Motion motion, double seconds);

}  // namespace coif
