#include <coif/palette_job.h>

#include "bone_frame.h"
#include "head_pose.h"
#include "simulated_bones.h"
#include "vector_math.h"

namespace coif {
namespace {

/// Rotates about the bone's rest joint, then carries that joint to `start`.
Mat34 skinning_matrix(const Quat& q, const Vec3& joint, const Vec3& start) {
  const float xx = q.x * q.x, yy = q.y * q.y, zz = q.z * q.z;
  const float xy = q.x * q.y, yz = q.y * q.z, zx = q.z * q.x;
  const float wx = q.w * q.x, wy = q.w * q.y, wz = q.w * q.z;
  const Vec3 row_x{1 - 2 * (yy + zz), 2 * (xy - wz), 2 * (zx + wy)};
  const Vec3 row_y{2 * (xy + wz), 1 - 2 * (zz + xx), 2 * (yz - wx)};
  const Vec3 row_z{2 * (zx - wy), 2 * (yz + wx), 1 - 2 * (xx + yy)};
  return {{{row_x.x, row_x.y, row_x.z, start.x - dot(row_x, joint)},
           {row_y.x, row_y.y, row_y.z, start.y - dot(row_y, joint)},
           {row_z.x, row_z.y, row_z.z, start.z - dot(row_z, joint)}}};
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
    job.frames[i] = job.world_frames.empty()
                        ? bend_frame(parent_frame, rest_direction, from, direction_or(ends[i] - start, from))
                        : to_head * job.world_frames[i];
    palette[i] = skinning_matrix(job.frames[i], joint, start);
  }
}

}  // namespace

Status PaletteJob::validate() const {
  if (!is_unit(head_rotation)) return Status::kBadPose;
  const bool sizes_match = particles.size() <= bones.size() && frames.size() == particles.size() &&
                           palette.size() == bones.size() && bone_ends.size() == bones.size() &&
                           (world_frames.empty() || world_frames.size() == particles.size());
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
