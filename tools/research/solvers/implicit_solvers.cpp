#include "research/solvers/historical_solvers.h"
#include "research/solvers/particle_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif::research {
namespace {

using Eigen::Vector3d;

/// Zenith from a pole across the default direction, azimuth from the default direction around it.
class Angles {
 public:
  Angles(const Vector3d& default_direction, const Eigen::Quaterniond& head_rotation) : front_(default_direction) {
    // Up or forward: both stay where they are when a head is mirrored, and so do the angles.
    const Vector3d up = head_rotation * Vector3d::UnitY();
    const Vector3d forward = head_rotation * Vector3d::UnitZ();
    const Vector3d& axis = std::abs(up.dot(front_)) < std::abs(forward.dot(front_)) ? up : forward;
    pole_ = (axis - front_ * axis.dot(front_)).normalized();
    side_ = pole_.cross(front_);
  }

  void point_along(const Vector3d& direction) {
    zenith = std::acos(std::clamp(direction.dot(pole_), -1.0, 1.0));
    azimuth = std::atan2(direction.dot(side_), direction.dot(front_));
  }
  [[nodiscard]] Vector3d direction() const { return flat() * std::sin(zenith) + pole_ * std::cos(zenith); }
  /// The direction in which it moves with a larger zenith, unit.
  [[nodiscard]] Vector3d along_zenith() const { return flat() * std::cos(zenith) - pole_ * std::sin(zenith); }
  /// The direction in which it moves with a larger azimuth, unit.
  [[nodiscard]] Vector3d along_azimuth() const { return side_ * std::cos(azimuth) - front_ * std::sin(azimuth); }
  /// Way per azimuth; bounded, since at the pole a sideways speed would be an infinite rate.
  [[nodiscard]] double azimuth_radius() const { return std::max(0.1, std::sin(zenith)); }

  double zenith = 0;
  double azimuth = 0;

 private:
  [[nodiscard]] Vector3d flat() const { return front_ * std::cos(azimuth) + side_ * std::sin(azimuth); }

  Vector3d front_, side_, pole_;
};

/// One angle by itself, `off` radians from its default.
struct Swing {
  double rate;          ///< rad/s, with gravity and drag in it.
  double default_rate;  ///< rad/s
  double off;

  [[nodiscard]] double next_rate(const lab::RigBone& bone, double dt) const {
    const double spring = bone.stiffness * dt;
    const double damper = bone.damping * dt;
    return (rate - off * spring + default_rate * damper) / (1 + damper + spring * dt);
  }
};

}  // namespace

void ProjectiveSolver::on_reset(const ParticleStep& still) {
  PosedSolver::on_reset(still);
  pointing_.clear();
  for (std::size_t i = 0; i < bone_count(); ++i) pointing_.push_back(still.head_rotation * bone(i).rest_direction);
}

void ProjectiveSolver::advance(const ParticleStep& step) {
  // Sticks are carried along by their starts without turning; only then do defaults know where the parents point.
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] = start(i, step) + pointing_[i] * bone(i).length;
  renew_default_pose(step);
  for (std::size_t i = 0; i < bone_count(); ++i) swing(i, step);
}

void ProjectiveSolver::swing(std::size_t i, const ParticleStep& step) {
  const double length = bone(i).length;
  Angles angles(default_direction(i).normalized(), step.head_rotation);
  angles.point_along(pointing_[i]);
  const Vector3d zenith_way = angles.along_zenith() * length;
  const Vector3d azimuth_way = angles.along_azimuth() * (length * angles.azimuth_radius());
  const Vector3d pivot_velocity = start_velocity(i, step);
  // The pivot's velocity is that of the step's end, so its acceleration needs no term of its own.
  const Vector3d around = falling_velocity(i, step) - pivot_velocity;
  const auto rate = [](const Vector3d& velocity, const Vector3d& way) { return velocity.dot(way) / way.squaredNorm(); };
  const Swing zenith{rate(around, zenith_way), rate(swing_velocity(i), zenith_way),
                     angles.zenith - std::numbers::pi / 2};
  const Swing azimuth{rate(around, azimuth_way), rate(swing_velocity(i), azimuth_way), angles.azimuth};
  const double zenith_rate = zenith.next_rate(bone(i), step.dt);
  const double azimuth_rate = azimuth.next_rate(bone(i), step.dt);

  angles.zenith += zenith_rate * step.dt;
  angles.azimuth += azimuth_rate * step.dt;
  const Vector3d pivot = start(i, step);
  positions_[i] = pivot + angles.direction() * length;
  velocities_[i] = pivot_velocity + angles.along_zenith() * (length * zenith_rate) +
                   angles.along_azimuth() * (length * std::sin(angles.zenith) * azimuth_rate);
  const Vector3d free = positions_[i];
  if (push_out(rig(), i, step, positions_[i], velocities_[i])) {
    positions_[i] = clear_of_colliders_at_length(rig(), i, step.head_rotation, pivot, free);
  }
  pointing_[i] = (positions_[i] - pivot).normalized();
}

using Eigen::Matrix3d;
using Eigen::Vector3d;

ImplicitSolver::ImplicitSolver(const lab::Rig& rig, const lab::SolverScene& scene)
    : PosedSolver(rig, scene), springs_(segment_springs(rig)), rows_(rig.bones.size()), changes_(rig.bones.size()) {}

void ImplicitSolver::advance(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) velocities_[i] = falling_velocity(i, step);
  for (std::size_t i = 0; i < bone_count(); ++i) positions_[i] += velocities_[i] * step.dt;
  renew_default_pose(step);
  begin_rows(step);
  add_springs(step);
  solve();
  for (std::size_t i = 0; i < bone_count(); ++i) {
    velocities_[i] += changes_[i];
    positions_[i] += changes_[i] * step.dt;
    push_out(rig(), i, step, positions_[i], velocities_[i]);
  }
}

/// Masses and the pose's pull, which follows the parent.
void ImplicitSolver::begin_rows(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const double spring = bone(i).stiffness * step.dt;
    const double damper = bone(i).damping * step.dt;
    const double change = spring * step.dt + damper;
    rows_[i].diagonal = Matrix3d::Identity() * (1 + change);
    rows_[i].by_parent = Matrix3d::Identity() * (hangs_from_head(i) ? 0 : -change);
    rows_[i].on_parent.setZero();
    rows_[i].right =
        (default_position(i, step) - positions_[i]) * spring + (default_velocity(i, step) - velocities_[i]) * damper;
  }
}

void ImplicitSolver::add_springs(const ParticleStep& step) {
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Vector3d along = positions_[i] - start(i, step);
    const double length = along.norm();
    const Vector3d direction = along.normalized();
    const Matrix3d axial = direction * direction.transpose();
    // A compressed spring would push sideways and make the system indefinite; Baraff and Witkin drop that part too.
    const double sideways = length > 0 ? std::max(0.0, 1 - bone(i).length / length) : 0.0;
    const Matrix3d stiffness = (axial + (Matrix3d::Identity() - axial) * sideways) * (springs_[i] * step.dt * step.dt);
    const Vector3d impulse = direction * ((length - bone(i).length) * springs_[i] * step.dt);
    rows_[i].diagonal += stiffness;
    rows_[i].right -= impulse;
    if (hangs_from_head(i)) continue;
    rows_[i].by_parent -= stiffness;
    rows_[i].on_parent -= stiffness;
    rows_[parent(i)].diagonal += stiffness;
    rows_[parent(i)].right += impulse;
  }
}

void ImplicitSolver::solve() {
  for (std::size_t i = bone_count(); i-- > 0;) {
    Block& row = rows_[i];
    row.diagonal = row.diagonal.inverse().eval();
    if (hangs_from_head(i)) continue;
    const Matrix3d weight = row.on_parent * row.diagonal;
    rows_[parent(i)].diagonal -= weight * row.by_parent;
    rows_[parent(i)].right -= weight * row.right;
  }
  for (std::size_t i = 0; i < bone_count(); ++i) {
    Vector3d right = rows_[i].right;
    if (!hangs_from_head(i)) right -= rows_[i].by_parent * changes_[parent(i)];
    changes_[i] = rows_[i].diagonal * right;
  }
}

}  // namespace coif::research
