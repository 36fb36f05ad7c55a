#include "base/collider_shapes.h"
#include "research/solvers/particle_solver.h"

#include <algorithm>
#include <bit>

namespace coif::research {

using Eigen::Quaterniond;
using Eigen::Vector3d;

Vector3d clear_of_colliders(const lab::Rig& rig, std::size_t i, const Quaterniond& head_rotation,
                            const Vector3d& position) {
  if (rig.bones[i].colliders == 0) return position;
  Vector3d cleared = head_rotation.conjugate() * position;
  const Vector3d before = cleared;
  for (std::uint32_t left = rig.bones[i].colliders; left != 0; left &= left - 1) {
    const auto which = std::size_t(std::countr_zero(left));
    if (which < rig.colliders.size()) cleared = clear_of(rig.colliders[which], rig.bones[i].hit_radius, cleared);
  }
  // A particle that touches nothing keeps its bits: callers test whether it was moved.
  return cleared == before ? position : Vector3d(head_rotation * cleared);
}

Vector3d clear_of_colliders_at_length(const lab::Rig& rig, std::size_t i, const Quaterniond& head_rotation,
                                      const Vector3d& start, const Vector3d& position) {
  constexpr int kRounds = 8;
  Vector3d end = position;
  for (int round = 0; round < kRounds; ++round) {
    const Vector3d cleared = clear_of_colliders(rig, i, head_rotation, end);
    if (round > 0 && cleared == end) break;
    end = start + (cleared - start).normalized() * rig.bones[i].length;
  }
  return end;
}

bool push_out(const lab::Rig& rig, std::size_t i, const ParticleStep& step, Vector3d& position, Vector3d& velocity) {
  const Vector3d cleared = clear_of_colliders(rig, i, step.head_rotation, position);
  if (cleared == position) return false;
  const Vector3d normal = (cleared - position).normalized();
  const double inwards = std::min(0.0, (velocity - step.head_velocity_at(cleared)).dot(normal));
  velocity -= normal * inwards;
  position = cleared;
  return true;
}

}  // namespace coif::research
