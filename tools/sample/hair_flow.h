#pragma once
// How hair lies on this head: from the parting over the skull to its widest line, then hanging down.

#include <Eigen/Core>

namespace coif::sample {

/// One hair's course. Angles in degrees around the head: 0 at the face, +90 at the model's left (+X), 180 at the back.
struct HairCourse {
  double parting = 0;        ///< Where it leaves the parting: 0 at the forehead .. 1 at the crown.
  double azimuth = 0;        ///< Where it passes the skull's widest line.
  double start = 0;          ///< Share of the way from the parting to that line that is left out; may be negative.
  double lift = 0.01;        ///< Metres above the skull once away from the root.
  double tip_height = 1.43;  ///< Model Y of the tip, metres.
  double flare = 0.010;      ///< Metres that the hanging part leans outwards.
  double curl = 0.020;       ///< Metres that the tip turns back inwards.
};

/// Point of the hair at `along`, 0 root .. 1 tip, about evenly spaced. Model space, metres; clear of the bust.
[[nodiscard]] Eigen::Vector3d point_on_hair(const HairCourse& course, double along);

/// Angle of a point around the head, degrees, -180..180, as in HairCourse.
[[nodiscard]] double azimuth_of(const Eigen::Vector3d& point);

}  // namespace coif::sample
