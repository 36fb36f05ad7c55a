#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <thread>

namespace coif {
namespace {

void add_colliders(TestRig& rig) {
  rig.add_sphere({0, 0, 0}, 0.1f);
  rig.add_ellipsoid({0, 0.02f, 0}, {0.09f, 0.13f, 0.11f}, {0.28f, 0, 0, 0.96f});
  rig.add_capsule({-0.1f, -0.2f, -0.1f}, {0.1f, -0.2f, -0.1f}, 0.04f);
  rig.add_tapered_capsule({-0.1f, -0.25f, -0.05f}, 0.05f, {0.1f, -0.25f, -0.05f}, 0.03f);
  rig.add_plane({0, -0.4f, 0}, {0, 1, 0});
  rig.add_sphere({0, 0, 0}, 0.5f);
  rig.colliders.back().flags = kColliderKeepsInside;
}

/// The `i`-th bone added: its neighbours in a row differ from it in everything.
TestBone bone_of(std::uint32_t i, std::uint32_t parent) {
  TestBone bone{.parent = parent, .joint = {0.02f * float(i % 7) - 0.06f, 0.03f, -0.07f - 0.01f * float(i % 5)}};
  bone.rest_direction = i % 2 == 0 ? Vec3{0, -0.8f, -0.6f} : Vec3{0.36f, -0.8f, -0.48f};
  bone.length = 0.05f + 0.007f * float(i % 5);
  bone.resistance = 0.05f + 0.06f * float(i % 4);
  bone.stiffness = 60 + 130 * float(i % 7);
  bone.damping = 12 + 9 * float(i % 6);
  bone.friction = i % 3 == 0 ? 0 : 1.5f * float(i % 4);
  bone.hit_radius = 0.002f * float(i % 4);
  bone.torsion = i % 3 == 1 ? kShortestArc : 6 * float(i % 3);
  bone.angle_limit = i % 4 == 1 ? 0.5f + 0.1f * float(i % 8) : kNoAngleLimit;
  bone.parent_share = i % 5 < 2 ? 1 : 0.2f * float(i % 5);
  return bone;
}

void add_chain(TestRig& rig, std::uint32_t bones, std::uint8_t levels) {
  std::uint32_t parent = 0;
  for (std::uint32_t i = 0; i < bones; ++i) {
    parent = rig.add(bone_of(std::uint32_t(rig.simulated_count()), parent));
    rig.levels.push_back(i == 0 ? levels : 1);
  }
}

void add_fork(TestRig& rig) {
  const std::uint32_t stem = rig.add(bone_of(std::uint32_t(rig.simulated_count()), 0));
  const std::uint32_t left = rig.add(bone_of(std::uint32_t(rig.simulated_count()), stem));
  rig.add(bone_of(std::uint32_t(rig.simulated_count()), left));
  rig.add(bone_of(std::uint32_t(rig.simulated_count()), stem));
  rig.levels.insert(rig.levels.end(), {3, 2, 1, 2});
}

/// Swings between -1 and 1 with the period 4, as parabolas.
double wave(double t) {
  const double x = t - 4 * std::floor(t / 4) - 2;
  return x < 0 ? -x * (2 + x) : -x * (2 - x);
}

/// What each instance's own life is made of: it wanders, stands still for most of a second, and goes on.
HeadPose pose_of(std::uint32_t instance, double t) {
  const double still = 0.9 + 0.1 * (instance % 3);
  const double s = (t < still ? t : std::max(still, t - 0.8)) * (1 + 0.1 * instance);
  const double x = 0.3 * wave(3 * s), y = 0.5 * wave(4 * s), z = 0.2 * wave(5 * s);
  const double size = std::sqrt(x * x + y * y + z * z + 1);
  return {{3.0 * instance + 0.2 * wave(4 * s), 0.05 * wave(7 * s), s},
          {float(x / size), float(y / size), float(z / size), float(1 / size)}};
}

Detail detail_of(std::uint32_t instance, int frame) {
  const std::uint32_t phase = (instance * 7 + std::uint32_t(frame) / 9) % 9;
  const std::uint32_t intervals[] = {1, 2, 4};
  return {.level = phase % 3, .interval = intervals[phase / 3], .simulated = phase != 5};
}

StepSettings settings_of(int frame, float sleep_after, Violence& random) {
  StepSettings settings{.dt = float(random.between(0.012, 0.04)), .substeps = 1 + std::uint32_t(frame) / 8 % 3};
  settings.environment.air_follow = 0.5f;
  settings.inertia = frame / 20 % 2 == 0 ? 1.0f : 0.6f;
  settings.iterations = 1 + std::uint32_t(frame) % 2;
  if (frame >= 64) settings.environment.wind = {2, 0, -1};
  if (frame >= 72) settings.dynamics.stiffness = 2;
  settings.sleep_after = sleep_after;
  settings.sleep_speed = 1.5f;
  return settings;
}

void run_jobs(Hair& hair, JobOrder order) {
  const std::uint32_t count = hair.job_count();
  const auto run_every_second = [&hair, count](std::uint32_t first) {
    for (std::uint32_t job = first; job < count; job += 2) hair.run_job(job);
  };
  if (order == JobOrder::kTwoThreads) {
    std::thread other(run_every_second, 1);
    run_every_second(0);
    other.join();
    return;
  }
  for (std::uint32_t i = 0; i < count; ++i) hair.run_job(order == JobOrder::kAscending ? i : count - 1 - i);
}

void direct(Hair& hair, std::uint32_t instance, int frame, double now, bool changes_detail) {
  const HeadPose pose = pose_of(instance, now);
  const std::uint32_t when = std::uint32_t(frame) + instance * 5;
  const Detail detail = changes_detail ? detail_of(instance, frame) : Detail{};
  EXPECT_EQ(hair.set_detail(instance, detail), Status::kOk);
  if (when % 47 == 46) {
    EXPECT_EQ(hair.teleport(instance, {{9, 8, 7}, {0.48f, 0.64f, 0, 0.6f}}), Status::kOk);
  } else if (when % 61 == 60) {
    EXPECT_EQ(hair.reset(instance, pose), Status::kOk);
  } else {
    EXPECT_EQ(hair.set_head(instance, pose), Status::kOk);
  }
}

void absorb(std::uint64_t& hash, const void* bytes, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    hash = (hash ^ static_cast<const unsigned char*>(bytes)[i]) * 1099511628211u;  // FNV-1a
  }
}

}  // namespace

TestRig feature_rig() {
  TestRig rig;
  rig.levels = {0};
  add_colliders(rig);
  for (int i = 0; i < 5; ++i) add_chain(rig, 3, std::uint8_t(1 + i % 3));
  for (int i = 0; i < 2; ++i) add_fork(rig);
  add_chain(rig, 6, 2);
  for (int i = 0; i < 17; ++i) add_chain(rig, 1, 3);
  for (std::size_t i = 1; i < rig.bones.size(); ++i) {
    const std::uint32_t sets[] = {0b111111, 0b000001, 0, 0b100100, 0b011010};
    rig.bones[i].colliders = sets[i % 5];
  }
  return rig;
}

std::vector<std::uint64_t> digests(const FeaturePlay& play) {
  TestHair test(feature_rig(), {.instances = play.instances,
                                .solver = play.solver,
                                .instruction_set = play.set,
                                .longest_interval = kMaxInterval});
  std::vector<std::uint64_t> hashes(play.instances, 14695981039346656037u);
  Violence random(21);
  double now = 0;
  for (int frame = 0; frame < play.frames; ++frame) {
    const StepSettings settings = settings_of(frame, play.sleep_after, random);
    now += double(settings.dt);
    for (std::uint32_t i = 0; i < play.instances; ++i) {
      direct(test.hair, play.descending_heads ? play.instances - 1 - i : i, frame, now, play.changes_detail);
    }
    EXPECT_EQ(test.hair.begin_step(settings), Status::kOk);
    run_jobs(test.hair, play.jobs);
    test.hair.finish_step();
    for (std::uint32_t i = 0; i < play.instances; ++i) {
      const std::vector<Vec3> ends = test.ends(i);
      absorb(hashes[i], test.hair.palette(i).data(), test.hair.palette(i).size_bytes());
      absorb(hashes[i], ends.data(), ends.size() * sizeof(Vec3));
    }
  }
  return hashes;
}

}  // namespace coif
