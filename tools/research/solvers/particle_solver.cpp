#include "research/solvers/particle_solver.h"

#include "base/geometry.h"

#include <coif/hair.h>

#include <cmath>

namespace coif::research {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

/// rad/s that turn `from` into `to` the short way.
Vector3d spin_between(const Quaterniond& from, const Quaterniond& to, double dt) {
  const Eigen::AngleAxisd turn(to * from.conjugate());
  return turn.axis() * (turn.angle() / dt);
}

/// `frame` turned by the shortest arc from `direction` (unit) to where `along` points.
Quaterniond bent_frame(const Quaterniond& frame, const Vector3d& direction, const Vector3d& along) {
  const double length = along.norm();
  if (!(length > 1.0e-12)) return frame;
  const Vector3d to = along / length;
  const double cosine = direction.dot(to);
  // Half a turn has no shortest arc: Eigen finds some axis, at a price.
  if (cosine < -1 + 1.0e-9) return turn_between(direction, to) * frame;
  Quaterniond arc;
  arc.w() = 1 + cosine;
  arc.vec() = direction.cross(to);
  return arc.normalized() * frame;
}

}  // namespace

Quaterniond rotation_of(const HeadPose& head) {
  const Quat& q = head.rotation;
  return Quaterniond(q.w, q.x, q.y, q.z).normalized();
}

bool is_finite(const HeadPose& head) {
  return std::isfinite(head.position[0]) && std::isfinite(head.position[1]) && std::isfinite(head.position[2]) &&
         rotation_of(head).coeffs().allFinite();
}

bool jumps(const HeadPose& from, const HeadPose& to) {
  const Vector3d way = Eigen::Map<const Vector3d>(to.position) - Eigen::Map<const Vector3d>(from.position);
  const StepSettings runtime;
  return way.norm() > double(runtime.teleport_distance) ||
         rotation_of(from).angularDistance(rotation_of(to)) > double(runtime.teleport_angle);
}

ParticleSolver::ParticleSolver(const lab::Rig& rig, const lab::SolverScene& scene)
    : rig_(lab::as_asked(rig)), scene_(scene), has_children_(rig.bones.size()) {
  for (const lab::RigBone& bone : rig_.bones) {
    if (bone.parent >= 0) has_children_[std::size_t(bone.parent)] = true;
    if (bone.parent_share > 0) turns_with_parents_ = true;
  }
}

void ParticleSolver::reset(const HeadPose& head) {
  head_ = head;
  const Vector3d zero = Vector3d::Zero();
  positions_.assign(bone_count(), zero);
  velocities_.assign(bone_count(), zero);
  const ParticleStep still{0, rotation_of(head), rotation_of(head), zero, zero, zero, zero};
  for (std::size_t i = 0; i < bone_count(); ++i) {
    positions_[i] = start(i, still) + still.head_rotation * (bone(i).rest_direction * bone(i).length);
  }
  on_reset(still);
  renew_ends();
}

bool ParticleSolver::step(const HeadPose& head, double dt) {
  if (!(dt > 0) || !std::isfinite(dt) || !is_finite(head) || positions_.size() != bone_count()) return false;
  if (jumps(head_, head)) reset(head);
  const Vector3d way = Eigen::Map<const Vector3d>(head.position) - Eigen::Map<const Vector3d>(head_.position);
  for (Vector3d& position : positions_) position -= way;
  const Vector3d velocity = way / dt;
  const Quaterniond before = rotation_of(head_);
  const Vector3d spin = spin_between(before, rotation_of(head), dt);
  head_ = head;
  advance({dt, rotation_of(head), before, scene_.gravity, scene_.wind + velocity * bone(0).air_follow, velocity, spin});
  renew_ends();
  return true;
}

Vector3d ParticleSolver::start(std::size_t i, const ParticleStep& step) const {
  return hangs_from_head(i) ? Vector3d(step.head_rotation * bone(i).joint) : positions_[parent(i)];
}

Vector3d ParticleSolver::falling_velocity(std::size_t i, const ParticleStep& step) const {
  const Vector3d fallen = velocities_[i] + step.gravity * (bone(i).gravity_scale * step.dt);
  return step.air_velocity + (fallen - step.air_velocity) * std::exp(-bone(i).friction * step.dt);
}

std::vector<Vector3d> ParticleSolver::default_directions(const ParticleStep& step, bool leaning) const {
  std::vector<Vector3d> directions(bone_count());
  std::vector<Quaterniond> frames(bone_count());
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const Quaterniond& frame = hangs_from_head(i) ? step.head_rotation : frames[parent(i)];
    const Vector3d arc = frame * bone(i).rest_direction;
    directions[i] = leaning ? Vector3d(frame * bone(i).pull_direction()) : arc;
    if (has_children_[i]) frames[i] = bent_frame(frame, arc, positions_[i] - start(i, step));
  }
  return directions;
}

std::vector<Vector3d> ParticleSolver::shared_directions(const ParticleStep& step) const {
  std::vector<Vector3d> directions =
      turns_with_parents_ ? default_directions(step, true) : std::vector<Vector3d>(bone_count(), Vector3d::Zero());
  for (std::size_t i = 0; i < bone_count(); ++i) {
    const double share = bone(i).parent_share;
    if (share < 1) directions[i] = directions[i] * share + step.head_rotation * bone(i).pull_direction() * (1 - share);
  }
  return directions;
}

void ParticleSolver::renew_ends() {
  ends_.resize(bone_count());
  const Quaterniond to_head = rotation_of(head_).conjugate();
  for (std::size_t i = 0; i < bone_count(); ++i) ends_[i] = to_head * positions_[i];
}

using Eigen::Vector3d;

void PosedSolver::renew_default_pose(const ParticleStep& step) {
  std::vector<Vector3d> directions = shared_directions(step);
  turns_.resize(bone_count());
  for (std::size_t i = 0; i < bone_count(); ++i) turns_[i] = (directions[i] - directions_[i]) / step.dt;
  directions_ = std::move(directions);
}

Vector3d PosedSolver::pull(std::size_t i, const Vector3d& way, const Vector3d& default_velocity,
                           const ParticleStep& step) const {
  const double spring = bone(i).stiffness * step.dt * step.dt;
  const double damper = bone(i).damping * step.dt;
  const Vector3d off = default_position(i, step) - positions_[i];
  return (off * spring + (default_velocity * step.dt - way) * damper) / (1 + spring + damper);
}

std::vector<double> segment_springs(const lab::Rig& rig) {
  constexpr double kEarth = 9.81;
  std::vector<double> carried(rig.bones.size(), 1.0);
  for (std::size_t i = rig.bones.size(); i-- > 0;) {  // Parents come first, so children have been counted.
    if (rig.bones[i].parent >= 0) carried[std::size_t(rig.bones[i].parent)] += carried[i];
  }
  std::vector<double> springs(rig.bones.size());
  for (std::size_t i = 0; i < springs.size(); ++i) {
    springs[i] = carried[i] * kEarth / (kSpringStretch * rig.bones[i].length);
  }
  return springs;
}

}  // namespace coif::research
