#pragma once

// Shared by all ways to lay hair on the skull.

#include "mannequin/head_shape.h"
#include "research/sample/gltf_document.h"

#include <Eigen/Core>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace coif::research {

/// Unit direction on a quadratic Bezier curve, from the middle of the skull. `t` outside 0..1 continues the curve.
[[nodiscard]] Eigen::Vector3d direction_on_curve(const Eigen::Vector3d& from, const Eigen::Vector3d& control,
                                                 const Eigen::Vector3d& to, double t);

/// The point, moved along `normal` if it is nearer than `clearance` (metres) to the surface: keeps hair that hangs over
/// cheeks, neck and shoulders outside them.
[[nodiscard]] Eigen::Vector3d pushed_clear(Eigen::Vector3d point, double clearance, const mannequin::Field& distance,
                                           const mannequin::Gradient& normal);

// The roots of the long hair's locks, and their course down the head and below.

/// One lock's middle line. Angles in degrees around the head: 0 at the face, +90 at the model's left (+X), 180 at the
/// back.
struct LockCourse {
  double azimuth = 180;  ///< Where it passes the skull's widest line, 0..360.
  /// Share of the way from the centre parting to that line at which the root is; above 1 the root is below the line, by
  /// a right angle more for each whole.
  double start = 0;
  double lift = 0.01;        ///< Metres above the skull once away from the root.
  double tip_height = 0.98;  ///< Model Y of the tip, metres.
  double sweep = 0;          ///< Degrees that the tip is carried around the head.
  double wave = 0.01;        ///< Metres that the hanging part swings to either side.
  double wave_turns = 2;     ///< Waves from root to tip.
  double wave_phase = 0;     ///< Turns.
};

/// Point of the lock at `along`, 0 root .. 1 tip, about evenly spaced. Model space, metres; clear of the bare head.
[[nodiscard]] Eigen::Vector3d point_on_lock(const LockCourse& course, double along);

/// `along` where the lock starts to move: a little above where it leaves the skull.
[[nodiscard]] double chain_start(const LockCourse& course);

/// A lock as part of its row: locks of a row lie beside each other, from the face's left around the back to its right.
struct Lock {
  int row = 0;          ///< 0 starts at the parting and lies outermost.
  int next = -1;        ///< The neighbour with the larger azimuth in the row; -1: this is the last.
  double spacing = 10;  ///< Degrees between neighbours.
  LockCourse course;
};

inline constexpr int kLocks = 100;

/// Row by row.
[[nodiscard]] std::vector<Lock> make_locks();

inline constexpr int kBonesPerLock = 16;

/// root > neck > Head > scalp_{left,back,right} > Lock_001_01 > ... > Lock_001_16 > Lock_001_end. Parents first. Chains
/// start where locks leave the skull.
[[nodiscard]] std::vector<Joint> make_long_skeleton(std::span<const Lock> locks);

/// Weights of a point on hair between the locks `a` and `b`, on the two bones of each that are nearest along them.
/// `along` 0..1 is the place on the chains; below 0 hair is on the scalp. `share_b` 0..1.
[[nodiscard]] mannequin::SkinInfluences lock_influences(std::span<const Lock> locks, int a, int b, double share_b,
                                                        double along);

/// The hair: for each lock a broad strip on it, and one above that bridges the gap to the next lock of its row. 20000
/// triangles in 200 connected groups that share no vertex, skinned to the locks' chains.
[[nodiscard]] mannequin::SurfaceMesh make_long_hair(std::span<const Lock> locks);

/// The bytes of sample_assets/long/long.glb: the same on every run.
[[nodiscard]] std::vector<std::byte> make_long();

}  // namespace coif::research
