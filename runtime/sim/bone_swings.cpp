#include <coif/coif_step_job.h>

#include "bone_carrier.h"
#include "bone_frame.h"
#include "simulated_bones.h"
#include "vector_math.h"

namespace coif {

void swings_from_particles(std::span<const BoneRecord> bones, std::span<const DynamicsRecord> dynamics,
                           const HeadMove& head, std::span<const Particle> particles, std::span<BoneSwing> swings,
                           std::span<Quat> frames, std::span<Vec3> angular_velocities) {
  const SimulatedBones simulated(bones, particles.size());
  const auto moving = dynamics.last(particles.size());
  for (std::size_t i = 0; i < simulated.count(); ++i) {
    const BoneRecord& bone = simulated[i];
    const Vec3 rest = to_vec3(bone.rest_direction);
    Carrier from = carrier_of(head, to_vec3(bone.joint));
    if (!simulated.hangs_from_rigid(i)) {
      const std::size_t parent = simulated.parent(i);
      const Particle& particle = particles[parent];
      from = {particle.position, particle.position, particle.velocity, frames[parent], angular_velocities[parent]};
    }
    const Target target = target_of(head, from, bone, moving[i].parent_share);
    const Vec3 direction = direction_or(particles[i].position - from.position, target.by_parent);
    const Vec3 relative = across(particles[i].velocity - from.velocity, direction);
    frames[i] = bend_frame(from.frame, rest, target.by_parent, direction);
    angular_velocities[i] =
        cross(direction, relative) * (1.0f / bone.length) + direction * dot(direction, from.angular_velocity);
    swings[i] = BoneSwing{};
    swings[i].offset = particles[i].position - target.position;
    swings[i].target_velocity = target.velocity;
    swings[i].direction = rotate(conjugate(from.frame), direction);
  }
}

}  // namespace coif
