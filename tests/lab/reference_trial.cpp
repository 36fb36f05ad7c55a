#include "lab/reference_trial.h"

#include <cmath>
#include <limits>

namespace coif::lab {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Rig with_tips(Rig rig) {
  std::vector<double> reach;
  std::vector<bool> carries(rig.bones.size());
  for (const RigBone& bone : rig.bones) {
    reach.push_back(bone.length + (bone.parent < 0 ? 0.0 : reach[std::size_t(bone.parent)]));
    if (bone.parent >= 0) carries[std::size_t(bone.parent)] = true;
  }
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    if (carries[i]) continue;
    rig.tips.push_back(std::uint32_t(i));
    rig.tip_length.push_back(reach[i]);
    rig.tip_chain.push_back(0);
  }
  return rig;
}

Rig touching(Rig rig, const ColliderRecord& collider) {
  for (RigBone& bone : rig.bones) bone.colliders |= 1u << rig.colliders.size();
  rig.colliders.push_back(collider);
  return rig;
}

std::vector<double> evenly(double rate, double seconds) {
  std::vector<double> times;
  for (long i = 0; i <= std::lround(seconds * rate); ++i) times.push_back(double(i) / rate);
  return times;
}

ReferenceRun solve_at(const Rig& rig, const SolverScene& scene, const motion::HeadPath& path, double seconds,
                      double rate) {
  return solve_reference(rig, scene, path,
                         {.sample_times = evenly(30, seconds),
                          .steps_per_second = rate,
                          .most_steps_per_second = 2 * rate,
                          .wanted_self_difference_pct = 0});
}

ReferenceRun solve_well(const Rig& rig, const SolverScene& scene, const motion::HeadPath& path, double seconds) {
  return solve_at(rig, scene, path, seconds, 1440);
}

motion::HeadState mirrored(const motion::HeadState& state) {
  const auto flip = [](const Vector3d& v) { return Vector3d(-v.x(), v.y(), v.z()); };
  const auto flip_axial = [](const Vector3d& v) { return Vector3d(v.x(), -v.y(), -v.z()); };
  const Quaterniond& q = state.rotation;
  return {flip(state.position),
          flip(state.velocity),
          flip(state.acceleration),
          Quaterniond(q.w(), q.x(), -q.y(), -q.z()),
          flip_axial(state.angular_velocity),
          flip_axial(state.angular_acceleration)};
}

motion::HeadState turned(const motion::HeadState& state, const Quaterniond& turn) {
  return {turn * state.position, turn * state.velocity,         turn * state.acceleration,
          turn * state.rotation, turn * state.angular_velocity, turn * state.angular_acceleration};
}

double worst_apart(const ReferenceRun& a, const ReferenceRun& b) {
  if (a.places.size() != b.places.size()) return std::numeric_limits<double>::infinity();
  double worst = 0;
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    const double apart = (a.places[i] - b.places[i]).norm();
    if (std::isnan(apart)) return apart;
    worst = std::max(worst, apart);
  }
  return worst;
}

}  // namespace coif::lab
