#include "rest_pose.h"

#include "simulated_bones.h"
#include "vector_math.h"

namespace coif {

void place_at_rest(std::span<const BoneRecord> bones, const Quat& head_rotation, std::span<Particle> particles) {
  const SimulatedBones simulated(bones, particles.size());
  for (std::size_t i = 0; i < simulated.count(); ++i) {
    const BoneRecord& bone = simulated[i];
    // A child starts at its parent's particle, wherever its own stored joint is: lengths hold from the first step.
    const Vec3 start = simulated.hangs_from_rigid(i) ? rotate(head_rotation, to_vec3(bone.joint))
                                                     : particles[simulated.parent(i)].position;
    particles[i].position = start + rotate(head_rotation, to_vec3(bone.rest_direction) * bone.length);
    particles[i].velocity = {};
  }
}

}  // namespace coif
