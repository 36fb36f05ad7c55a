#pragma once

#include <coif/math.h>
#include <coif/status.h>

namespace coif {

/// How far the length of a host's quaternion may be from one.
inline constexpr float kUnitTolerance = 1e-3f;

/// False for anything with a NaN or an infinity.
[[nodiscard]] bool is_unit(const Quat& rotation);

/// Copies `pose` to `unit` with its rotation normalised; kBadPose, with `unit` untouched, where coif/hair.h says so.
Status normalise_pose(const HeadPose& pose, HeadPose& unit);

/// The way from one position to another, metres. False where it is too far to be a movement in single precision.
[[nodiscard]] bool displacement(const HeadPose& from, const HeadPose& to, Vec3& way);

}  // namespace coif
