// A program of its own: it counts every allocation of the process.

#include "models/counted_allocations.h"
#include "models/test_rig.h"

#include <coif/hair_world.h>
#include <coif/head_bone.h>

#include <gtest/gtest.h>

namespace coif::allocation_test {

TEST(Allocation, TheCounterCounts) {
  const std::size_t before = allocations;
  const std::vector<int> block(100);
  EXPECT_EQ(allocations, before + 1) << block.size();
}

/// Three crowds' worth of heads that do all that heads can do, in both ways to step them. False where a call failed.
bool live_a_while(Hair& hair, bool in_jobs) {
  bool ok = hair.reset(3, {{0, 1.7, 0}, {}}) == Status::kOk;
  for (std::uint32_t frame = 0; frame < 400; ++frame) {
    const HeadPose pose{{0, 1.7, (frame % 5 == 0 ? 10 : 0.1) * frame}, {}};  // some of them detected as teleports
    ok = ok && (frame % 7 == 0 ? hair.teleport(3, pose) : hair.set_head(3, pose)) == Status::kOk;
    const Detail detail{.level = frame / 3 % 2, .interval = 1u << frame / 5 % 3, .simulated = frame % 11 != 0};
    ok = ok && hair.set_detail(frame % 30, detail) == Status::kOk;
    StepSettings settings{.substeps = frame < 150 ? 1 + frame % 4 : 2,
                          .iterations = 1 + frame % 2,
                          .sleep_after = 0.1f,
                          .sleep_speed = 0.1f};
    settings.dynamics.stiffness = frame < 100 ? 1 + 0.1f * float(frame) : 1;
    settings.environment.gravity = frame < 150 ? Vec3{0, -9.81f, 0} : Vec3{};
    settings.inertia = frame % 50 < 40 ? 1 : 0.5f;
    ok = ok && (in_jobs ? hair.begin_step(settings) : hair.step(settings)) == Status::kOk;
    for (std::uint32_t job = 0; in_jobs && job < hair.job_count(); ++job) hair.run_job(job);
    if (in_jobs) hair.finish_step();
    ok = ok && hair.palette(3).size() == 10;
  }
  return ok && hair.step({.dt = -1}) == Status::kBadTimeStep && hair.is_asleep(39);
}

TEST(Allocation, HairNeverAllocates) {
  TestRig rig = nine_bone_rig();
  rig.levels = {0, 2, 2, 1, 2, 1, 1, 2, 2, 2};
  rig.add_capsule({-0.1f, -0.2f, -0.1f}, {0.1f, -0.2f, -0.1f}, 0.01f);
  AlignedBytes file(write_asset(rig.contents()));
  AlignedBytes memory{std::vector<std::byte>(1 << 20)};
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    for (const bool in_jobs : {false, true}) {
      const std::size_t before = allocations;
      Asset asset;
      Hair hair;
      bool ok = bool(asset.open(file.bytes()));
      const HairDesc desc{.instances = 40, .solver = solver, .longest_interval = 4};
      ok = ok && hair.create(asset, desc, memory.bytes()) == Status::kOk;
      ok = ok && live_a_while(hair, in_jobs);
      Vec3 ends[10];
      ok = ok && hair.bone_ends(3, ends) == Status::kOk;
      EXPECT_EQ(allocations, before);
      EXPECT_TRUE(ok);
    }
  }
}

TEST(Allocation, ABonesPoseNeverAllocates) {
  const BoneMatrix bone{{{0, 0, 0.01, 1}, {0, 0.01, 0, 1.6}, {0.01, 0, 0, 0}}};
  HeadBone head_bone;
  HeadPose pose;
  BoneMatrix inverse;
  const std::size_t before = allocations;
  const Status scale = head_pose_of_bone(bone, head_bone, pose), inverted = invert(bone, inverse);
  head_bone.rest = bone;
  const Status found = head_pose_of_bone(bone, head_bone, pose);
  EXPECT_EQ(allocations, before);
  EXPECT_EQ(scale, Status::kBadScale);
  EXPECT_EQ(inverted, Status::kOk);
  EXPECT_EQ(found, Status::kOk);
}

TEST(Allocation, HairWorldNeverAllocates) {
  AlignedBytes file(write_asset(nine_bone_rig().contents()));
  AlignedBytes memory{std::vector<std::byte>(8 << 20)};
  const std::size_t before = allocations;
  Asset asset;
  HairWorld world;
  WorldAsset worn;
  WorldHead heads[20];
  bool ok = bool(asset.open(file.bytes())) && world.create({.assets = 2, .heads = 20}, memory.bytes()) == Status::kOk;
  ok = ok && world.add_asset(asset, worn) == Status::kOk;
  for (std::uint32_t frame = 0; frame < 400; ++frame) {
    WorldHead& head = heads[frame % 20];
    if (world.has(head)) ok = ok && world.remove_head(head) == Status::kOk;
    ok = ok && world.add_head(worn, {}, head) == Status::kOk;
    const HeadPose pose{{0, 1.7, 0.1 * frame}, {}};
    for (const WorldHead one : heads) ok = ok && (!world.has(one) || world.set_head(one, pose) == Status::kOk);
    ok = ok && world.step({.sleep_after = 0.1f, .sleep_speed = 0.1f}) == Status::kOk;
  }
  EXPECT_EQ(allocations, before);
  EXPECT_TRUE(ok);
}

}  // namespace coif::allocation_test
