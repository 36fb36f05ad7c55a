#include <coif/palette_job.h>

#include "bone_frame.h"
#include "head_pose.h"
#include "simulated_bones.h"
#include "vector_math.h"

namespace coif {
namespace {

/// Rotates about the bone's rest joint, then carries that joint to `start`.
Mat34 skinning_matrix(const Quat& frame, const Vec3& joint, const Vec3& start) {
  const Vec3 x = rotate(frame, Vec3{1, 0, 0});
  const Vec3 y = rotate(frame, Vec3{0, 1, 0});
  const Vec3 z = rotate(frame, Vec3{0, 0, 1});
  const Vec3 shift = start - rotate(frame, joint);
  return {{{x.x, y.x, z.x, shift.x}, {x.y, y.y, z.y, shift.y}, {x.z, y.z, z.z, shift.z}}};
}

void write_rigid_bones(const PaletteJob& job) {
  const std::size_t rigid_count = job.bones.size() - job.particles.size();
  for (std::size_t i = 0; i < rigid_count; ++i) {
    job.palette[i] = Mat34{};
    job.bone_ends[i] = to_vec3(job.bones[i].joint);
  }
}

void write_simulated_bones(const PaletteJob& job) {
  const SimulatedBones bones(job.bones, job.particles.size());
  const auto palette = job.palette.last(bones.count());
  const auto ends = job.bone_ends.last(bones.count());
  const Quat to_head = conjugate(job.head_rotation);
  for (std::size_t i = 0; i < bones.count(); ++i) {
    const Vec3 joint = to_vec3(bones[i].joint);
    const Vec3 rest_direction = to_vec3(bones[i].rest_direction);
    const bool is_first = bones.hangs_from_rigid(i);
    const Vec3 start = is_first ? joint : ends[bones.parent(i)];
    const Quat parent_frame = is_first ? Quat{} : job.frames[bones.parent(i)];
    ends[i] = rotate(to_head, job.particles[i].position);
    const Vec3 from = rotate(parent_frame, rest_direction);
    job.frames[i] = bend_frame(parent_frame, rest_direction, from, direction_or(ends[i] - start, from));
    palette[i] = skinning_matrix(job.frames[i], joint, start);
  }
}

}  // namespace

Status PaletteJob::validate() const {
  if (!is_unit(head_rotation)) return Status::kBadPose;
  const bool sizes_match = particles.size() <= bones.size() && frames.size() == particles.size() &&
                           palette.size() == bones.size() && bone_ends.size() == bones.size();
  if (!sizes_match) return Status::kSizeMismatch;
  return SimulatedBones(bones, particles.size()).parents_come_first() ? Status::kOk : Status::kBadIndex;
}

Status PaletteJob::run() const {
  if (const Status status = validate(); status != Status::kOk) return status;
  write_rigid_bones(*this);
  write_simulated_bones(*this);
  return Status::kOk;
}

}  // namespace coif
