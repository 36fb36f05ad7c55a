#pragma once
// A HairWorld, and each of its heads once more in a Hair of its own: what they do has to be the same.

#include "models/playback.h"

#include <coif/hair_world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <thread>
#include <vector>

namespace coif::hair_town {

inline TestRig passive_strands(std::uint32_t strands, int bones, float substep_rate) {
  TestRig rig;
  rig.model = ChainModel::kPassive;
  rig.substep_rate = substep_rate;
  for (std::uint32_t i = 0; i < strands; ++i) {
    rig.add_strand(bones, {.joint = {0.02f * float(i), 0, -0.09f},
                           .rest_direction = {0, -0.8f, -0.6f},
                           .length = 0.3f / float(bones),
                           .friction = 0.4f * float(i % 3),
                           .hit_radius = 0.004f,
                           .stiffness = 60 + 20 * float(i),
                           .damping = 5,
                           .torsion = kShortestArc});
  }
  return rig;
}

inline TestRig limited_strands() {
  TestRig rig = passive_strands(3, 3, 0);
  rig.add_sphere({0, 0, 0}, 0.1f);
  for (std::uint32_t bone = 1; bone < rig.bones.size(); ++bone) {
    rig.limit(bone, LimitKind::kCone, 0.2f + 0.05f * float(bone));
  }
  return rig;
}

/// Some chains have limits, and all hang in gaps between colliders.
inline TestRig half_limited_strands() {
  TestRig rig = passive_strands(4, 2, 0);
  rig.model = ChainModel::kCascade;
  for (const std::uint32_t bone : {1u, 2u, 5u}) rig.limit(bone, LimitKind::kCone, 0.1f);
  for (int i = 0; i < 6; ++i) {
    rig.add_sphere({0.02f * float(i) - 0.03f, -0.08f - 0.02f * float(i), -0.2f + 0.03f * float(i % 3)}, 0.06f);
  }
  for (DynamicsRecord& bone : rig.dynamics) bone.hit_radius = 0.02f;
  return rig;
}

/// With a capsule and air that rubs, where nine_bone_rig() has a sphere alone.
inline TestRig other_nine_bones() {
  TestRig rig = nine_bone_rig();
  rig.add_capsule({-0.1f, -0.2f, -0.1f}, {0.1f, -0.2f, -0.1f}, 0.04f);
  for (DynamicsRecord& bone : rig.dynamics) bone.friction = 1.5f;
  return rig;
}

inline TestRig soft_strands() {
  TestRig rig = passive_strands(5, 3, 90);
  rig.add_sphere({0, 0, 0}, 0.1f);
  rig.add_plane({0, -0.3f, 0}, {0, 1, 0});
  return rig;
}

/// So many colliders that those of hardly another asset fit beside them.
inline TestRig crowded_nine_bones() {
  TestRig rig = nine_bone_rig();
  while (rig.colliders.size() < kMaxColliders - 3) {
    const float place = 0.02f * float(rig.colliders.size());
    rig.add_sphere({0.3f - place, -0.1f - 0.3f * place, -0.1f}, 0.03f);
  }
  for (BoneRecord& bone : rig.bones) bone.colliders = bone.chain == kNone ? 0 : 0x1FFFFFFF;
  return rig;
}

inline TestRig tuned_features() {
  TestRig rig = feature_rig();
  rig.levels.clear();
  rig.substep_rate = 90;
  return rig;
}

/// Strands of 1 to `longest` bones, two of each.
inline TestRig uneven_strands(ChainModel model, int longest, float torsion, bool is_limited) {
  TestRig rig;
  rig.model = model;
  for (int bones = 1; bones <= longest; ++bones) {
    for (const float side : {-0.06f, 0.06f}) {
      rig.add_strand(bones, {.joint = {side, 0.01f * float(bones), -0.09f},
                             .rest_direction = {0, -0.8f, -0.6f},
                             .length = 0.06f,
                             .friction = 0.5f * float(bones % 3),
                             .hit_radius = 0.004f,
                             .stiffness = 40 + 15 * float(bones),
                             .damping = 3,
                             .torsion = torsion});
    }
  }
  rig.add_sphere({0, 0, 0}, 0.1f);
  rig.add_plane({0, -0.25f, 0}, {0, 1, 0});
  for (std::uint32_t bone = 1; is_limited && bone < rig.bones.size(); ++bone) rig.limit(bone, LimitKind::kCone, 0.4f);
  return rig;
}

inline AssetContents mixed_strands() {
  AssetContents mixed = passive_strands(4, 3, 0).contents();
  mixed.chains[1].model = mixed.chains[2].model = ChainModel::kCascade;
  mixed.skeleton.air_lag = 0.5f;
  return mixed;
}

/// Hair of every kind: both models, twisting and not, bounded and not, with few and with many colliders, tuned for
/// several rates, without any chain. Several have chains of one shape, and of one shape but for their lengths.
inline std::vector<AssetContents> many_kinds() {
  std::vector<AssetContents> kinds;
  for (const TestRig& rig : {feature_rig(), tuned_features(), nine_bone_rig(), other_nine_bones(), crowded_nine_bones(),
                             limited_strands(), half_limited_strands(), soft_strands(), passive_strands(2, 12, 90),
                             TestRig(), uneven_strands(ChainModel::kPassive, 9, kShortestArc, false),
                             uneven_strands(ChainModel::kPassive, 4, kShortestArc, true),
                             uneven_strands(ChainModel::kCascade, 5, kShortestArc, false),
                             uneven_strands(ChainModel::kCascade, 9, 4, true)}) {
    kinds.push_back(rig.contents());
  }
  kinds.push_back(mixed_strands());
  return kinds;
}

/// An asset, opened.
struct Kind {
  explicit Kind(const AssetContents& contents) : Kind(write_asset(contents)) {}
  explicit Kind(std::span<const std::byte> bytes) : file(bytes) { EXPECT_TRUE(asset.open(file.bytes())); }
  AlignedBytes file;
  Asset asset;
};

inline AlignedBytes memory_of(std::size_t bytes) {
  return AlignedBytes(std::vector<std::byte>(bytes, std::byte{0xFF}));
}

/// The same head in a crowd of its own.
struct Twin {
  Twin(const Asset& asset, const Solver& solver, const HeadPose& pose)
      : memory(memory_of(Hair::memory_need(asset, {.solver = &solver}).bytes)) {
    EXPECT_EQ(hair.create(asset, {.solver = &solver}, memory.bytes()), Status::kOk);
    EXPECT_EQ(hair.reset(0, pose), Status::kOk);
  }
  AlignedBytes memory;
  Hair hair;
};

struct Resident {
  std::size_t kind = 0;
  WorldHead head;
  std::unique_ptr<Twin> twin;
};

/// Runs the jobs of a step that has begun.
inline void run_jobs(HairWorld& world, JobOrder order) {
  const std::uint32_t jobs = world.job_count();
  const auto run_every_second = [&](std::uint32_t first) {
    for (std::uint32_t job = first; job < jobs; job += 2) world.run_job(job);
  };
  if (order == JobOrder::kTwoThreads) {
    std::thread other(run_every_second, 1);
    run_every_second(0);
    other.join();
    return;
  }
  for (std::uint32_t i = 0; i < jobs; ++i) world.run_job(order == JobOrder::kAscending ? i : jobs - 1 - i);
}

/// A world, and each of its heads once more alone.
class Town {
 public:
  Town(const std::vector<std::unique_ptr<Kind>>& kinds, const WorldDesc& desc)
      : kinds_(kinds),
        solver_(*desc.solver),
        memory_(memory_of(HairWorld::memory_need(desc).bytes)),
        names_(kinds.size()) {
    EXPECT_EQ(world.create(desc, memory_.bytes()), Status::kOk);
  }

  bool is_here(std::size_t kind) const { return world.has(names_[kind]); }
  std::size_t heads_of(std::size_t kind) const {
    return std::size_t(std::ranges::count(residents, kind, [](const Resident& one) { return one.kind; }));
  }
  Status come(std::size_t kind, std::uint32_t crowd = 0) {
    return world.add_asset(kinds_[kind]->asset, names_[kind], crowd);
  }
  Status leave(std::size_t kind) { return world.remove_asset(names_[kind]); }

  Status move_in(std::size_t kind, const HeadPose& pose) {
    Resident one{kind, {}, nullptr};
    const Status status = world.add_head(names_[kind], pose, one.head);
    if (status != Status::kOk) return status;
    one.twin = std::make_unique<Twin>(kinds_[kind]->asset, solver_, pose);
    residents.push_back(std::move(one));
    return Status::kOk;
  }
  void move_out(std::size_t index) {
    EXPECT_EQ(world.remove_head(residents[index].head), Status::kOk);
    EXPECT_FALSE(world.has(residents[index].head));
    EXPECT_EQ(world.remove_head(residents[index].head), Status::kBadIndex);
    residents.erase(residents.begin() + std::ptrdiff_t(index));
  }

  void step(const StepSettings& settings, JobOrder order = JobOrder::kAscending) {
    ASSERT_EQ(world.begin_step(settings), Status::kOk);
    run_jobs(world, order);
    world.finish_step();
    for (const Resident& one : residents) ASSERT_EQ(one.twin->hair.step(settings), Status::kOk);
  }

  /// Heads that are not to the bit as they are alone.
  [[nodiscard]] int strangers() const {
    int count = 0;
    for (const Resident& one : residents) {
      const auto here = world.palette(one.head), alone = one.twin->hair.palette(0);
      const bool is_same =
          here.size() == alone.size() && std::memcmp(here.data(), alone.data(), here.size_bytes()) == 0;
      count += is_same && world.is_asleep(one.head) == one.twin->hair.is_asleep(0) ? 0 : 1;
    }
    return count;
  }

  HairWorld world;
  std::vector<Resident> residents;

 private:
  const std::vector<std::unique_ptr<Kind>>& kinds_;
  const Solver& solver_;
  AlignedBytes memory_;
  std::vector<WorldAsset> names_;
};

inline std::vector<std::unique_ptr<Kind>> opened(const std::vector<AssetContents>& contents) {
  std::vector<std::unique_ptr<Kind>> kinds;
  for (const AssetContents& one : contents) kinds.push_back(std::make_unique<Kind>(one));
  return kinds;
}

}  // namespace coif::hair_town
