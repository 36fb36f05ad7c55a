#include <coif/hair.h>

#include "head_pose.h"
#include "memory_carver.h"
#include "rest_pose.h"
#include "vector_math.h"

#include <coif/palette_job.h>

#include <cmath>
#include <cstdint>

namespace coif {
namespace {

Status check_create(const Asset& asset, const HairDesc& desc) {
  if (!asset.is_open()) return Status::kAssetLacksData;
  if (desc.instances < 1 || desc.instances > kMaxInstances) return Status::kBadArgument;
  return Status::kOk;
}

Status check_settings(const StepSettings& settings) {
  if (!(settings.dt > 0.0f && settings.dt <= kMaxTimeStep)) return Status::kBadTimeStep;
  if (settings.solver != Solver::kThesis) return Status::kBadArgument;
  if (settings.iterations < 1 || settings.iterations > kMaxIterations) return Status::kBadArgument;
  const Environment& environment = settings.environment;
  if (!is_finite(environment.gravity) || !is_finite(environment.wind)) return Status::kBadArgument;
  if (!(environment.air_follow >= 0.0f && environment.air_follow <= 1.0f)) return Status::kBadArgument;
  return Status::kOk;
}

bool any_bone_collides(std::span<const BoneRecord> bones) {
  for (const BoneRecord& bone : bones) {
    if (bone.colliders != 0) return true;
  }
  return false;
}

bool is_aligned(const std::byte* memory) {
  return reinterpret_cast<std::uintptr_t>(memory) % MemoryCarver::kAlignment == 0;
}

}  // namespace

Hair::Storage Hair::carve(MemoryCarver& carver, const SkeletonRecord& skeleton, std::uint32_t instances) {
  const std::uint64_t bones = std::uint64_t(instances) * skeleton.bone_count;
  const std::uint64_t simulated = std::uint64_t(instances) * skeleton.simulated_count;
  Storage storage;
  storage.heads = carver.take<HeadTrack>(instances);
  storage.particles = carver.take<Particle>(simulated);
  storage.palettes = carver.take<Mat34>(bones);
  storage.bone_ends = carver.take<Vec3>(bones);
  storage.friction_factors = carver.take<float>(skeleton.simulated_count);
  storage.scratch = carver.take<BoneScratch>(skeleton.simulated_count);
  storage.frames = carver.take<Quat>(skeleton.simulated_count);
  return storage;
}

MemoryNeed Hair::memory_need(const Asset& asset, const HairDesc& desc) {
  MemoryNeed need{0, MemoryCarver::kAlignment};
  if (check_create(asset, desc) != Status::kOk) return need;
  MemoryCarver counter(nullptr);
  (void)carve(counter, asset.skeleton(), desc.instances);
  if (counter.used() <= SIZE_MAX) need.bytes = std::size_t(counter.used());
  return need;
}

Status Hair::create(const Asset& asset, const HairDesc& desc, std::span<std::byte> memory) {
  if (const Status status = check_create(asset, desc); status != Status::kOk) return status;
  const MemoryNeed need = memory_need(asset, desc);
  if (need.bytes == 0 || memory.size() < need.bytes || !is_aligned(memory.data())) return Status::kMemoryTooSmall;

  MemoryCarver carver(memory.data());
  storage_ = carve(carver, asset.skeleton(), desc.instances);
  instances_ = desc.instances;
  simulated_count_ = asset.skeleton().simulated_count;
  bones_ = asset.bones();
  dynamics_ = asset.dynamics();
  colliders_ = any_bone_collides(bones_) ? asset.colliders() : std::span<const ColliderRecord>{};
  for (std::uint32_t instance = 0; instance < instances_; ++instance) put_to_rest(instance);
  return Status::kOk;
}

Status Hair::set_head(std::uint32_t instance, const HeadPose& pose) {
  if (instances_ == 0) return Status::kNotCreated;
  if (instance >= instances_) return Status::kBadIndex;
  return normalise_pose(pose, storage_.heads[instance].next);
}

Status Hair::reset(std::uint32_t instance, const HeadPose& pose) {
  if (const Status status = set_head(instance, pose); status != Status::kOk) return status;
  put_to_rest(instance);
  return Status::kOk;
}

Status Hair::step(const StepSettings& settings) {
  if (instances_ == 0) return Status::kNotCreated;
  if (const Status status = check_settings(settings); status != Status::kOk) return status;
  compute_friction_factors(dynamics_, settings.dt, storage_.friction_factors);
  for (std::uint32_t instance = 0; instance < instances_; ++instance) advance(instance, settings);
  return Status::kOk;
}

std::span<const Mat34> Hair::palette(std::uint32_t instance) const {
  if (instance >= instances_) return {};
  return storage_.palettes.subspan(std::size_t(instance) * bones_.size(), bones_.size());
}

std::span<const Vec3> Hair::bone_ends(std::uint32_t instance) const {
  if (instance >= instances_) return {};
  return storage_.bone_ends.subspan(std::size_t(instance) * bones_.size(), bones_.size());
}

std::span<Particle> Hair::particles_of(std::uint32_t instance) const {
  return storage_.particles.subspan(std::size_t(instance) * simulated_count_, simulated_count_);
}

void Hair::advance(std::uint32_t instance, const StepSettings& settings) {
  HeadTrack& head = storage_.heads[instance];
  ThesisStepJob job;
  if (!displacement(head.now, head.next, job.head_displacement)) return put_to_rest(instance);
  const Environment& environment = settings.environment;
  job.dt = settings.dt;
  job.iterations = settings.iterations;
  job.gravity = environment.gravity;
  job.air_velocity = environment.wind + job.head_displacement * (environment.air_follow / settings.dt);
  job.head_rotation = head.next.rotation;
  job.bones = bones_;
  job.dynamics = dynamics_;
  job.colliders = colliders_;
  job.friction_factors = storage_.friction_factors;
  job.scratch = storage_.scratch;
  job.particles = particles_of(instance);
  // The settings were checked, so a job can only be refused for air that overflowed; that is an explosion as well.
  if (job.run() != Status::kOk || !all_finite(job.particles)) return put_to_rest(instance);
  head.now = head.next;
  renew_palette(instance);
}

void Hair::put_to_rest(std::uint32_t instance) {
  HeadTrack& head = storage_.heads[instance];
  head.now = head.next;
  place_at_rest(bones_, head.now.rotation, particles_of(instance));
  renew_palette(instance);
}

void Hair::renew_palette(std::uint32_t instance) {
  const std::size_t first = std::size_t(instance) * bones_.size();
  PaletteJob job;
  job.head_rotation = storage_.heads[instance].now.rotation;
  job.bones = bones_;
  job.particles = particles_of(instance);
  job.frames = storage_.frames;
  job.palette = storage_.palettes.subspan(first, bones_.size());
  job.bone_ends = storage_.bone_ends.subspan(first, bones_.size());
  // Everything the job checks was made by create() and set_head().
  (void)job.run();
}

}  // namespace coif
