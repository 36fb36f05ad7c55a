// What a HairWorld has room for, what it refuses, and what it shares.

#include "sim/hair_town.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>

namespace coif::hair_world_room_test {

using namespace hair_town;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

WorldDesc desc_of(std::uint32_t assets, std::uint32_t heads, std::size_t bytes) {
  return {.assets = assets, .heads = heads, .hair_bytes = bytes};
}

TEST(HairWorldRoom, BytesForAnAssetAreEnoughAndNotFarTooMany) {
  const auto kinds = opened(many_kinds());
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    for (const std::uint32_t heads : {1u, 16u, 17u, 50u}) {
      const std::size_t bytes = HairWorld::bytes_for(kinds[kind]->asset, heads);
      Town town(kinds, desc_of(1, heads + 1, bytes));
      ASSERT_EQ(town.come(kind), Status::kOk);
      for (std::uint32_t i = 0; i < heads; ++i) ASSERT_EQ(town.move_in(kind, {}), Status::kOk) << "kind " << kind;
      Town half(kinds, desc_of(1, heads, bytes / 2));
      const bool has_come = half.come(kind) == Status::kOk;
      std::uint32_t in = 0;
      while (has_come && in < heads && half.move_in(kind, {}) == Status::kOk) ++in;
      EXPECT_LT(in, heads) << "kind " << kind;
    }
  }
}

TEST(HairWorldRoom, BytesForMoreChainsThanAreCountedIn32Bits) {
  TestRig rig;
  while (rig.bones.size() < kMaxBones) rig.add({.length = 0.1f, .stiffness = 50, .damping = 4});
  const auto kinds = opened({rig.contents()});
  const auto bytes = [&](std::uint32_t heads) { return double(HairWorld::bytes_for(kinds[0]->asset, heads)); };
  EXPECT_GT(bytes(2 * kMaxInstances), 1.99 * bytes(kMaxInstances));
  EXPECT_GT(bytes(kNone), 4000 * bytes(kMaxInstances));
}

TEST(HairWorldRoom, ChainsOfDifferentAssetsShareLanes) {
  // Sixteen assets of one strand each: alone each would need a bundle of sixteen lanes for its one head.
  std::vector<AssetContents> contents;
  std::size_t alone = 0;
  for (int i = 0; i < 16; ++i) {
    TestRig rig;
    rig.add_strand(4, {.length = 0.05f + 0.01f * float(i), .friction = float(i % 3), .stiffness = 50, .damping = 4});
    contents.push_back(rig.contents());
  }
  const auto kinds = opened(contents);
  for (const auto& kind : kinds) alone += HairWorld::bytes_for(kind->asset, 1);
  Town town(kinds, desc_of(16, 16, alone / 2));
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    ASSERT_EQ(town.come(kind), Status::kOk);
    ASSERT_EQ(town.move_in(kind, {}), Status::kOk);
  }
  for (int frame = 0; frame < 10; ++frame) {
    for (const Resident& one : town.residents) {
      ASSERT_EQ(town.world.set_head(one.head, wander(0.1 * frame)), one.twin->hair.set_head(0, wander(0.1 * frame)));
    }
    town.step({});
    EXPECT_EQ(town.world.job_count(), 0u) << "none is left after a step";
    EXPECT_EQ(town.strangers(), 0);
  }
  ASSERT_EQ(town.world.begin_step({}), Status::kOk);
  EXPECT_EQ(town.world.job_count(), 1u);
}

TEST(HairWorldRoom, WhatDoesNotFitLeavesAllAsItWas) {
  const auto kinds = opened(many_kinds());
  std::size_t bytes = 0;
  for (const auto& kind : kinds) bytes += HairWorld::bytes_for(kind->asset, 1);
  Town town(kinds, desc_of(std::uint32_t(kinds.size()), 200, bytes));
  int refused = 0, in = 0;
  for (int frame = 0; frame < 120; ++frame) {
    const std::size_t kind = std::size_t(frame * 7) % kinds.size();
    if (!town.is_here(kind) && town.come(kind) != Status::kOk) ++refused;
    for (int i = 0; town.is_here(kind) && i < 4; ++i) {
      (town.move_in(kind, wander(frame)) == Status::kOk ? in : refused) += 1;
    }
    if (frame % 3 == 2 && !town.residents.empty()) town.move_out(std::size_t(frame) % town.residents.size());
    town.step({.sleep_after = 0.1f, .sleep_speed = 1});
    ASSERT_EQ(town.strangers(), 0) << frame;
  }
  EXPECT_GT(refused, 20);
  EXPECT_GT(in, 40);
  // Everybody out: then there is as much room as at first.
  while (!town.residents.empty()) town.move_out(0);
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    EXPECT_EQ(town.is_here(kind) ? town.leave(kind) : Status::kOk, Status::kOk);
  }
  for (std::size_t kind = 0; kind < kinds.size(); ++kind) {
    EXPECT_EQ(town.come(kind), Status::kOk);
    EXPECT_EQ(town.move_in(kind, {}), Status::kOk);
  }
}

TEST(HairWorldRoom, CountsHeadsAndAssets) {
  const auto kinds = opened(many_kinds());
  Town town(kinds, desc_of(2, 3, 32u << 20));
  EXPECT_EQ(town.come(0), Status::kOk);
  EXPECT_EQ(town.come(1), Status::kOk);
  EXPECT_EQ(town.come(2), Status::kMemoryTooSmall);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(town.move_in(0, {}), Status::kOk);
  EXPECT_EQ(town.move_in(0, {}), Status::kMemoryTooSmall);
  EXPECT_EQ(town.leave(0), Status::kBadArgument);
  EXPECT_EQ(town.leave(1), Status::kOk);
  EXPECT_EQ(town.leave(1), Status::kBadIndex);
}

TEST(HairWorldRoom, NamesOfWhatHasLeftNameNothing) {
  const auto kinds = opened({nine_bone_rig().contents()});
  Town town(kinds, desc_of(1, 1, 1u << 20));
  WorldAsset asset, next_asset;
  ASSERT_EQ(town.world.add_asset(kinds[0]->asset, asset), Status::kOk);
  WorldHead head, next;
  ASSERT_EQ(town.world.add_head(asset, {}, head), Status::kOk);
  ASSERT_EQ(town.world.remove_head(head), Status::kOk);
  ASSERT_EQ(town.world.remove_asset(asset), Status::kOk);
  ASSERT_EQ(town.world.add_asset(kinds[0]->asset, next_asset), Status::kOk);
  ASSERT_EQ(town.world.add_head(next_asset, {}, next), Status::kOk);
  EXPECT_EQ(next.index, head.index);
  EXPECT_TRUE(town.world.has(next));
  // The second of the two that the world has no room for is the first behind its last one.
  for (const WorldHead old : {head, WorldHead{}, WorldHead{7, 1}, WorldHead{1, 1}}) {
    EXPECT_FALSE(town.world.has(old));
    EXPECT_FALSE(town.world.is_asleep(old));
    EXPECT_TRUE(town.world.palette(old).empty());
    EXPECT_EQ(town.world.set_head(old, {}), Status::kBadIndex);
    EXPECT_EQ(town.world.set_head(old, {}, {}), Status::kBadIndex);
    EXPECT_EQ(town.world.teleport(old, {}), Status::kBadIndex);
    EXPECT_EQ(town.world.reset(old, {}), Status::kBadIndex);
    EXPECT_EQ(town.world.remove_head(old), Status::kBadIndex);
  }
  for (const WorldAsset old : {asset, WorldAsset{}, WorldAsset{7, 1}, WorldAsset{1, 1}}) {
    EXPECT_FALSE(town.world.has(old));
    EXPECT_EQ(town.world.add_head(old, {}, head), Status::kBadIndex);
    EXPECT_EQ(town.world.remove_asset(old), Status::kBadIndex);
  }
}

TEST(HairWorldRoom, BadArgumentsChangeNothing) {
  const auto kinds = opened({nine_bone_rig().contents()});
  Town town(kinds, desc_of(1, 2, 1u << 20));
  ASSERT_EQ(town.come(0), Status::kOk);
  ASSERT_EQ(town.move_in(0, {}), Status::kOk);
  HeadPose bad;
  bad.position[1] = double(kNaN);
  EXPECT_EQ(town.move_in(0, bad), Status::kBadPose);
  const WorldHead head = town.residents[0].head;
  EXPECT_EQ(town.world.set_head(head, bad), Status::kBadPose);
  EXPECT_EQ(town.world.teleport(head, bad), Status::kBadPose);
  EXPECT_EQ(town.world.reset(head, bad), Status::kBadPose);
  EXPECT_EQ(town.world.set_head(head, {}, {{kNaN, 0, 0}, {}}), Status::kBadPose);
  EXPECT_EQ(town.world.step({.dt = -1}), Status::kBadTimeStep);
  EXPECT_EQ(town.world.step({.dt = kNaN}), Status::kBadTimeStep);
  EXPECT_EQ(town.world.step({.inertia = 2}), Status::kBadArgument);
  WorldAsset none;
  EXPECT_EQ(town.world.add_asset(Asset(), none), Status::kAssetLacksData);
  town.step({});
  EXPECT_EQ(town.strangers(), 0);
}

TEST(HairWorldRoom, RefusesWhatItCannotBe) {
  EXPECT_EQ(HairWorld::memory_need({.assets = 0}).bytes, 0u);
  EXPECT_EQ(HairWorld::memory_need({.assets = kMaxWorldAssets + 1}).bytes, 0u);
  EXPECT_EQ(HairWorld::memory_need({.heads = 0}).bytes, 0u);
  EXPECT_EQ(HairWorld::memory_need({.hair_bytes = SIZE_MAX}).bytes, 0u);
  EXPECT_EQ(HairWorld::memory_need({.heads = kMaxInstances + 1}).bytes, 0u);
  EXPECT_EQ(HairWorld::memory_need({.solver = nullptr}).bytes, 0u);
  EXPECT_EQ(HairWorld::memory_need({.longest_interval = 3}).bytes, 0u);
  EXPECT_EQ(HairWorld::memory_need({.dynamics_sets = 0}).bytes, 0u);
  EXPECT_EQ(HairWorld::memory_need({.moving_colliders = 1}).bytes, 0u) << "not on a character";
  AlignedBytes small = memory_of(HairWorld::memory_need({}).bytes - 1);
  HairWorld world;
  EXPECT_EQ(world.create({}, small.bytes()), Status::kMemoryTooSmall);
  EXPECT_EQ(world.create({.heads = 0}, small.bytes()), Status::kBadArgument);
  AlignedBytes large = memory_of(HairWorld::memory_need({}).bytes + 64);
  EXPECT_EQ(world.create({}, large.bytes().subspan(4)), Status::kMemoryTooSmall);
  WorldAsset asset;
  WorldHead head;
  EXPECT_EQ(world.add_asset(Asset(), asset), Status::kNotCreated);
  EXPECT_EQ(world.remove_asset(asset), Status::kNotCreated);
  EXPECT_EQ(world.add_head(asset, {}, head), Status::kNotCreated);
  EXPECT_EQ(world.set_head(head, {}), Status::kNotCreated);
  EXPECT_EQ(world.step({}), Status::kNotCreated);
  EXPECT_EQ(world.job_count(), 0u);
  world.finish_step();
  EXPECT_EQ(HairWorld::bytes_for(Asset(), 1), 0u);
}

TEST(HairWorldRoom, AnEmptyWorldTakesSteps) {
  AlignedBytes memory = memory_of(HairWorld::memory_need({}).bytes);
  HairWorld world;
  ASSERT_EQ(world.create({}, memory.bytes()), Status::kOk);
  for (const float dt : {0.0f, 0.02f, 1.0f}) EXPECT_EQ(world.step({.dt = dt}), Status::kOk);
  HairWorld other = std::move(world);
  EXPECT_EQ(other.step({}), Status::kOk);
  EXPECT_EQ(world.step({}), Status::kNotCreated);
}

}  // namespace coif::hair_world_room_test
