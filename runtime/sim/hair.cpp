#include <coif/hair.h>

#include "head_pose.h"
#include "memory_carver.h"
#include "rest_pose.h"
#include "rotation_vector.h"
#include "step_settings.h"
#include "vector_math.h"

#include <coif/palette_job.h>
#include <coif/thesis_step_job.h>

#include <cmath>
#include <cstdint>

namespace coif {
namespace {

Status check_create(const Asset& asset, const HairDesc& desc) {
  if (!asset.is_open()) return Status::kAssetLacksData;
  if (desc.instances < 1 || desc.instances > kMaxInstances) return Status::kBadArgument;
  return Status::kOk;
}

/// What hair feels of a head's move when it feels a share of it. The rest is taken out of the move and turns the hair by
/// the rotation returned.
Quat share_move(HeadMove& move, float inertia) {
  const Vec3 turn = vector_of(move.rotation * conjugate(move.rotation_before));
  const Quat carried = rotation_by(turn * (1.0f - inertia));
  move.rotation_before = renormalised(carried * move.rotation_before);
  move.displacement = move.displacement * inertia;
  move.velocity = move.velocity * inertia;
  move.angular_velocity = move.angular_velocity * inertia;
  return carried;
}

bool any_bone_collides(std::span<const BoneRecord> bones) {
  for (const BoneRecord& bone : bones) {
    if (bone.colliders != 0) return true;
  }
  return false;
}

/// Faster than light, m/s: an explosion that happened to fit a float, and that damping would take a minute to calm.
constexpr float kFastest = 3e8f;

bool has_exploded(std::span<const Particle> particles) {
  if (!all_finite(particles)) return true;
  for (const Particle& particle : particles) {
    if (!(dot(particle.velocity, particle.velocity) < kFastest * kFastest)) return true;
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
  storage.instances = carver.take<Instance>(instances);
  storage.particles = carver.take<Particle>(simulated);
  storage.swings = carver.take<BoneSwing>(simulated);
  storage.palettes = carver.take<Mat34>(bones);
  storage.bone_ends = carver.take<Vec3>(bones);
  storage.friction_factors = carver.take<float>(skeleton.simulated_count);
  storage.scratch = carver.take<BoneScratch>(skeleton.simulated_count);
  storage.responses = carver.take<PoseResponse>(skeleton.simulated_count);
  storage.frames = carver.take<Quat>(skeleton.simulated_count);
  storage.world_frames = carver.take<Quat>(skeleton.simulated_count);
  storage.angular_velocities = carver.take<Vec3>(skeleton.simulated_count);
  storage.positions_before = carver.take<Vec3>(skeleton.simulated_count);
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
  responses_for_ = {};
  substep_rate_ = asset.tuning() != nullptr ? asset.tuning()->substep_rate : 0.0f;
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
  return storage_.instances[instance].head.set_next(pose);
}

Status Hair::reset(std::uint32_t instance, const HeadPose& pose) {
  if (const Status status = set_head(instance, pose); status != Status::kOk) return status;
  put_to_rest(instance);
  return Status::kOk;
}

Status Hair::teleport(std::uint32_t instance, const HeadPose& pose) {
  if (const Status status = set_head(instance, pose); status != Status::kOk) return status;
  storage_.instances[instance].teleports = true;
  return Status::kOk;
}

Status Hair::step(const StepSettings& settings) {
  if (instances_ == 0) return Status::kNotCreated;
  if (const Status status = check_settings(settings); status != Status::kOk) return status;
  const std::uint32_t substeps = substeps_for(settings);
  prepare(settings, settings.dt / float(substeps));
  for (std::uint32_t instance = 0; instance < instances_; ++instance) advance(instance, settings, substeps);
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

std::span<BoneSwing> Hair::swings_of(std::uint32_t instance) const {
  return storage_.swings.subspan(std::size_t(instance) * simulated_count_, simulated_count_);
}

std::uint32_t Hair::substeps_for(const StepSettings& settings) const {
  if (settings.solver != Solver::kCoif) return 1;
  if (settings.substeps != 0) return settings.substeps;
  // A frame that is longer by rounding is not worth another part.
  const float parts = std::ceil(settings.dt * substep_rate_ - 1e-3f);
  return parts < 1.0f ? 1 : parts < float(kMaxSubsteps) ? std::uint32_t(parts) : kMaxSubsteps;
}

/// What depends on the step's length and not on the head; nothing where it is the last step's.
void Hair::prepare(const StepSettings& settings, float substep) {
  if (settings.solver == Solver::kThesis) {
    compute_friction_factors(dynamics_, substep, storage_.friction_factors);
    return;
  }
  const DynamicsScale& scale = settings.dynamics;
  const DynamicsScale& known = responses_for_.scale;
  const bool same = responses_for_.dt == substep && known.stiffness == scale.stiffness &&
                    known.damping == scale.damping && known.friction == scale.friction;
  if (same) return;
  compute_pose_responses(dynamics_, substep, scale, storage_.responses);
  responses_for_ = {substep, scale};
}

void Hair::advance(std::uint32_t instance, const StepSettings& settings, std::uint32_t substeps) {
  Instance& state = storage_.instances[instance];
  const bool is_coif = settings.solver == Solver::kCoif;
  if (is_coif && !state.swings_known) learn_swings(instance);
  state.teleports = state.teleports || state.head.distance() > settings.teleport_distance ||
                    state.head.angle() > settings.teleport_angle;
  if (state.teleports) carry(instance, state.head.jump(settings.dt));
  state.teleports = false;
  if (!state.head.can_move()) return put_to_rest(instance);

  const float dt = settings.dt / float(substeps);
  state.head.begin(settings.dt);
  Status status = Status::kOk;
  for (std::uint32_t part = 0; part < substeps && status == Status::kOk; ++part) {
    HeadMove move = state.head.move(part, substeps);
    if (settings.inertia < 1.0f) carry(instance, share_move(move, settings.inertia));
    status = is_coif ? run_coif(instance, settings, move, dt) : run_thesis(instance, settings, move, dt);
  }
  // The settings were checked, so a job can only be refused for air that overflowed; that is an explosion as well.
  if (status != Status::kOk || has_exploded(particles_of(instance))) return put_to_rest(instance);
  state.head.finish();
  state.swings_known = is_coif;
  renew_palette(instance, is_coif);
}

Status Hair::run_thesis(std::uint32_t instance, const StepSettings& settings, const HeadMove& move, float dt) {
  const Environment& environment = settings.environment;
  ThesisStepJob job;
  job.dt = dt;
  job.iterations = settings.iterations;
  job.gravity = environment.gravity;
  job.air_velocity = environment.wind + move.displacement * (environment.air_follow / dt);
  job.head_displacement = move.displacement;
  job.head_rotation = move.rotation;
  job.bones = bones_;
  job.dynamics = dynamics_;
  job.colliders = colliders_;
  job.friction_factors = storage_.friction_factors;
  job.scratch = storage_.scratch;
  job.particles = particles_of(instance);
  return job.run();
}

Status Hair::run_coif(std::uint32_t instance, const StepSettings& settings, const HeadMove& move, float dt) {
  const Environment& environment = settings.environment;
  CoifStepJob job;
  job.dt = dt;
  job.gravity = environment.gravity;
  job.air_velocity = environment.wind + move.displacement * (environment.air_follow / dt);
  job.head = move;
  job.friction_scale = settings.dynamics.friction;
  job.bones = bones_;
  job.dynamics = dynamics_;
  job.colliders = colliders_;
  job.responses = storage_.responses;
  job.particles = particles_of(instance);
  job.swings = swings_of(instance);
  job.frames = storage_.world_frames;
  job.angular_velocities = storage_.angular_velocities;
  job.positions_before = storage_.positions_before;
  return job.run();
}

void Hair::learn_swings(std::uint32_t instance) {
  Instance& state = storage_.instances[instance];
  swings_from_particles(bones_, dynamics_, state.head.here(), particles_of(instance), swings_of(instance),
                        storage_.world_frames, storage_.angular_velocities);
  state.swings_known = true;
}

/// Turns everything about the head that is kept in world axes.
void Hair::carry(std::uint32_t instance, const Quat& turn) {
  for (Particle& particle : particles_of(instance)) {
    particle.position = rotate(turn, particle.position);
    particle.velocity = rotate(turn, particle.velocity);
  }
  for (BoneSwing& swing : swings_of(instance)) {
    swing.offset = rotate(turn, swing.offset);
    swing.target_velocity = rotate(turn, swing.target_velocity);
  }
}

void Hair::put_to_rest(std::uint32_t instance) {
  Instance& state = storage_.instances[instance];
  const HeadPose pose = state.head.next_pose();
  (void)state.head.reset(pose);
  place_at_rest(bones_, pose.rotation, particles_of(instance));
  state.teleports = false;
  state.swings_known = false;
  renew_palette(instance, false);
}

void Hair::renew_palette(std::uint32_t instance, bool has_world_frames) {
  const std::size_t first = std::size_t(instance) * bones_.size();
  PaletteJob job;
  job.head_rotation = storage_.instances[instance].head.pose().rotation;
  job.bones = bones_;
  job.particles = particles_of(instance);
  if (has_world_frames) job.world_frames = storage_.world_frames;
  job.frames = storage_.frames;
  job.palette = storage_.palettes.subspan(first, bones_.size());
  job.bone_ends = storage_.bone_ends.subspan(first, bones_.size());
  // Everything the job checks was made by create() and set_head().
  (void)job.run();
}

}  // namespace coif
