#pragma once
// Where the locks of the long hair start, and how they run down the head and hang.

#include <Eigen/Core>

#include <string>
#include <vector>

namespace coif::sample {

/// One lock's middle line. Angles in degrees around the head: 0 at the face, +90 at the model's left (+X), 180 at the back.
struct LockCourse {
  double azimuth = 180;  ///< Where it passes the skull's widest line, 0..360.
  /// Share of the way from the centre parting to that line at which the root is; above 1 the root is below the line, by a
  /// right angle more for each whole.
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

}  // namespace coif::sample
