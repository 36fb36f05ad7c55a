#pragma once

#include "models/playback.h"
#include "research/solvers/historical_solvers.h"

#include <functional>
#include <ostream>
#include <string>

namespace coif::research {

/// Bones one behind the other from the head's origin, back and down, that hang as real hair does: stiff at the root,
/// critically damped, no friction, no colliders.
[[nodiscard]] lab::Rig strand_rig(int bone_count);
/// strand_rig(4) with a strand of two more that forks off its second bone sideways, so that it has no mirror symmetry.
[[nodiscard]] lab::Rig forked_rig();
/// One bone of 0.1 m, backwards, k = 400/s^2, critically damped.
[[nodiscard]] lab::Rig pendulum_rig();
/// As `rig` in a mirror across x = 0. Without colliders.
[[nodiscard]] lab::Rig mirrored(lab::Rig rig);

/// A sphere about a point; bones have to be told that they may touch it.
[[nodiscard]] ColliderRecord sphere(const Eigen::Vector3d& center, double radius);

[[nodiscard]] const ListedSolver& solver_named(std::string_view name);

using HeadMotion = std::function<HeadPose(double seconds)>;
/// Nods by 0.5 rad, turns by 0.4 and walks forward, from rest: nothing about it is symmetric.
[[nodiscard]] HeadPose walking(double seconds);
[[nodiscard]] HeadPose mirrored(const HeadPose& head);

/// Steps until `seconds` (from 0) have passed; calls `look` after each. False once a step is refused.
bool run(
    lab::ChainSolver& solver, const HeadMotion& motion, double dt, double seconds,
    const std::function<void()>& look = [] {});

/// Largest |length / rest - 1| of the bones; NaN where one is.
[[nodiscard]] double worst_stretch(const lab::Rig& rig, std::span<const Eigen::Vector3d> ends);
/// Largest distance of equal entries, metres.
[[nodiscard]] double worst_distance(std::span<const Eigen::Vector3d> a, std::span<const Eigen::Vector3d> b);

/// For GoogleTest, which otherwise prints the bytes.
inline void PrintTo(const ListedSolver& listed, std::ostream* out) { *out << listed.name; }

/// For tests of every solver: "mass-spring" is no name for a test.
[[nodiscard]] std::string test_name(std::string_view solver);

}  // namespace coif::research
