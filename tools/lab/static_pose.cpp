#include "lab/hair_segment.h"
#include "lab/reference_model.h"
#include "lab/reference_solver.h"
#include "lab/runtime_solver.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kClear = 1.0e-9;  // metres; radians

bool is_clear(const Rig& rig, std::span<const SolidShape> solids, const RigBone& bone, const HairSegment& segment) {
  for (std::size_t i = 0; i < rig.colliders.size(); ++i) {
    if ((bone.colliders >> i & 1) != 0 && nearest_contact(solids[i], segment).gap < -kClear) return false;
  }
  return true;
}

bool is_within_limit(const RigBone& bone, const Vector3d& target, const Vector3d& direction) {
  if (bone.angle_limit >= double(kNoAngleLimit)) return true;
  const double angle = std::acos(std::clamp(direction.dot(target.normalized()), -1.0, 1.0));
  return angle <= bone.angle_limit + kClear;
}

}  // namespace

StaticPose static_pose(const Rig& rig, const SolverScene& scene, const Quaterniond& head_rotation) {
  const std::vector<SolidShape> solids = solid_shapes(rig.colliders);
  const Quaterniond to_head = head_rotation.conjugate();
  const HeadState head{.rotation = Quaterniond::Identity()};
  StaticPose pose;
  std::vector<BoneMotion> motions;
  for (const RigBone& bone : rig.bones) {
    const bool is_root = bone.parent < 0;
    const auto up = std::size_t(is_root ? 0 : bone.parent);
    const BoneMotion parent = is_root ? motion_of_joint(bone.joint, head) : motions[up];
    const Vector3d target = target_of(bone, parent, head).direction;
    const Vector3d load = to_head * (scene.gravity * bone.gravity_scale + scene.wind * bone.friction);
    const Vector3d pull = bone.stiffness * bone.length * target + load;
    const Vector3d with_parent = parent.frame * bone.rest_direction;
    const Vector3d direction = pull.norm() > 0 ? Vector3d(pull.normalized()) : with_parent;
    BoneMotion motion = parent;
    motion.frame = shortest_arc(with_parent, direction) * parent.frame;
    motion.end = parent.end + bone.length * direction;
    const bool parent_is_free = is_root || pose.is_free[up];
    pose.is_free.push_back(parent_is_free && is_within_limit(bone, target, direction) &&
                           is_clear(rig, solids, bone, {parent.end, direction, bone.length, bone.hit_radius}));
    pose.ends.push_back(motion.end);
    motions.push_back(motion);
  }
  return pose;
}

namespace {

/// Adds the distances of all tips to where they should be at sample `sample`.
void add_distances(const Rig& rig, const ReferenceRun& reference, std::size_t sample,
                   std::span<const Eigen::Vector3d> ends, RuntimeError& sums) {
  for (std::size_t tip = 0; tip < rig.tips.size(); ++tip) {
    const double off = (ends[rig.tips[tip]] - reference.path_of_tip(tip)[sample]).norm() / rig.tip_length[tip];
    sums.rms += off * off;
    sums.max = off <= sums.max ? sums.max : off;  // a NaN stays
  }
}

}  // namespace

std::vector<double> common_times(std::span<const std::uint32_t> rates, double seconds) {
  std::uint32_t common = 0;
  for (const std::uint32_t rate : rates) common = std::gcd(common, rate);
  std::vector<double> times;
  for (std::uint32_t k = 1; common != 0 && k <= seconds * common; ++k) times.push_back(double(k) / common);
  return times;
}

RuntimeError measure_runtime(const Asset& asset, const Rig& rig, const KnownMotion& motion, std::uint32_t rate,
                             std::uint32_t substeps) {
  const ReferenceRun& reference = motion.reference;
  const auto path = path_of(motion.motion);
  RuntimeSolver solver(asset, {}, kCoifSolver, int(substeps));
  solver.reset(path->pose(0));
  ConstraintMeter meter(rig);
  RuntimeError error;
  std::size_t sample = 0;
  for (std::uint32_t frame = 1; sample < reference.times.size(); ++frame) {
    const double time = double(frame) / rate;
    if (!solver.step(path->pose(time), 1.0 / rate)) return {NAN, NAN, NAN, NAN};
    meter.look(solver.bone_ends());
    if (time < reference.times[sample] - 0.5 / rate) continue;
    add_distances(rig, reference, sample++, solver.bone_ends(), error);
  }
  error.rms = std::sqrt(error.rms / double(std::max<std::size_t>(sample * rig.tips.size(), 1)));
  error.stretch = meter.worst().stretch;
  error.penetration = meter.sees_colliders() ? std::max(meter.worst().point_depth, meter.worst().segment_depth) : 0;
  return error;
}

}  // namespace coif
