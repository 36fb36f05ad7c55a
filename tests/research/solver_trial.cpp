#include "research/solver_trial.h"

#include <algorithm>
#include <cmath>

namespace coif::research {

using Eigen::Quaterniond;
using Eigen::Vector3d;

lab::Rig strand_rig(int bone_count) {
  lab::Rig rig;
  for (int i = 0; i < bone_count; ++i) {
    lab::RigBone bone;
    bone.parent = i - 1;
    bone.rest_direction = Vector3d(0, -0.8, -0.6);
    bone.length = 0.08;
    bone.resistance = 0.3 / (1 + i);
    bone.stiffness = bone.resistance / (1 - bone.resistance) * 3600;
    bone.damping = 2 * std::sqrt(bone.stiffness);
    rig.bones.push_back(bone);
  }
  return rig;
}

lab::Rig forked_rig() {
  lab::Rig rig = strand_rig(4);
  for (int i = 0; i < 2; ++i) {
    lab::RigBone bone = rig.bones[2];
    bone.parent = i == 0 ? 1 : 4;
    bone.rest_direction = Vector3d(0.6, -0.48, 0.64);
    rig.bones.push_back(bone);
  }
  return rig;
}

lab::Rig pendulum_rig() {
  lab::RigBone bone;
  bone.rest_direction = Vector3d(0, 0, -1);
  bone.length = 0.1;
  bone.resistance = 0.1;
  bone.stiffness = 400;
  bone.damping = 40;
  return {.bones = {bone}, .colliders = {}, .links = {}, .tips = {}, .tip_length = {}, .tip_chain = {}};
}

lab::Rig mirrored(lab::Rig rig) {
  for (lab::RigBone& bone : rig.bones) {
    bone.joint.x() = -bone.joint.x();
    bone.rest_direction.x() = -bone.rest_direction.x();
  }
  return rig;
}

ColliderRecord sphere(const Vector3d& center, double radius) {
  ColliderRecord record{};
  record.shape = ColliderShape::kSphere;
  for (int axis = 0; axis < 3; ++axis) {
    record.center[axis] = float(center[axis]);
    record.radii[axis] = float(radius);
  }
  record.rotation[3] = 1;
  return record;
}

const ListedSolver& solver_named(std::string_view name) {
  return *std::ranges::find(historical_solvers(), name, &ListedSolver::name);
}

HeadPose walking(double seconds) {
  const double begun = 1 - std::exp(-4 * seconds);  // From rest: a jolt would ring in springs for long.
  const double nod = 0.5 * begun * std::sin(5 * seconds), turn = 0.4 * begun * std::sin(3 * seconds);
  const Quaterniond rotation = Eigen::AngleAxisd(turn, Vector3d::UnitY()) * Eigen::AngleAxisd(nod, Vector3d::UnitX());
  HeadPose head;
  head.position[0] = 0.05 * begun * std::sin(4 * seconds);
  head.position[2] = 1.5 * (seconds - begun / 4);
  head.rotation = {float(rotation.x()), float(rotation.y()), float(rotation.z()), float(rotation.w())};
  return head;
}

HeadPose mirrored(const HeadPose& head) {
  HeadPose mirror = head;
  mirror.position[0] = -head.position[0];
  mirror.rotation.y = -head.rotation.y;
  mirror.rotation.z = -head.rotation.z;
  return mirror;
}

bool run(lab::ChainSolver& solver, const HeadMotion& motion, double dt, double seconds,
         const std::function<void()>& look) {
  const auto steps = std::lround(seconds / dt);
  for (long i = 1; i <= steps; ++i) {
    if (!solver.step(motion(double(i) * dt), dt)) return false;
    look();
  }
  return true;
}

double worst_stretch(const lab::Rig& rig, std::span<const Vector3d> ends) {
  double worst = 0;
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const lab::RigBone& bone = rig.bones[i];
    const Vector3d& start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    const double stretch = std::abs((ends[i] - start).norm() / bone.length - 1);
    if (std::isnan(stretch)) return stretch;
    worst = std::max(worst, stretch);
  }
  return worst;
}

double worst_distance(std::span<const Vector3d> a, std::span<const Vector3d> b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double distance = (a[i] - b[i]).norm();
    if (std::isnan(distance)) return distance;
    worst = std::max(worst, distance);
  }
  return worst;
}

std::string test_name(std::string_view solver) {
  std::string name(solver);
  std::ranges::replace(name, '-', '_');
  return name;
}

}  // namespace coif::research
