// Memory is asked for exactly: one byte less is refused, that many suffice, and nothing beside them is touched.

#include "models/small_asset.h"
#include "models/test_rig.h"

#include <coif/hair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <vector>

namespace coif::memory_test {

struct Case {
  HairDesc desc;
  bool rigid = false;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Solver* solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    for (const InstructionSet set : {InstructionSet::kScalar, InstructionSet::kPortable, InstructionSet::kSse4,
                                     InstructionSet::kAvx2, InstructionSet::kAvx512}) {
      if (!can_run(set)) continue;
      for (const std::uint32_t instances : {1u, 3u, 17u}) {
        for (const std::uint32_t interval : {1u, 4u}) all.push_back({{instances, solver, set, interval}});
      }
    }
    all.push_back({{.instances = 2, .solver = solver}, true});
  }
  return all;
}

struct OpenAsset {
  explicit OpenAsset(const Case& one) : file(write_asset((one.rigid ? TestRig{} : nine_bone_rig()).contents())) {
    EXPECT_TRUE(asset.open(file.bytes()));
  }
  AlignedBytes file;
  Asset asset;
};

/// Heads of their own, some far away, some with less detail: all that may make the crowd use its memory.
void use(Hair& hair, const HairDesc& desc) {
  for (int frame = 1; frame <= 12; ++frame) {
    for (std::uint32_t i = 0; i < desc.instances; ++i) {
      const HeadPose pose{{0.02 * frame * (i + 1), 1.7, i == 2 ? 1000.0 : 0.0}, {}};
      ASSERT_EQ(frame == 5 ? hair.teleport(i, pose) : hair.set_head(i, pose), Status::kOk);
      const std::uint32_t interval = i % 2 == 0 ? 1 : desc.longest_interval;
      ASSERT_EQ(hair.set_detail(i, {.interval = interval, .simulated = frame % 4 != 3}), Status::kOk);
    }
    ASSERT_EQ(hair.step({.substeps = 1 + std::uint32_t(frame) % 3}), Status::kOk);
  }
}

TEST(MemoryNeed, OneByteLessIsRefused) {
  for (const Case& one : cases()) {
    const OpenAsset opened(one);
    const MemoryNeed need = Hair::memory_need(opened.asset, one.desc);
    ASSERT_GT(need.bytes, 0u);
    AlignedBytes memory{std::vector<std::byte>(need.bytes - 1)};
    Hair hair;
    EXPECT_EQ(hair.create(opened.asset, one.desc, memory.bytes()), Status::kMemoryTooSmall);
    EXPECT_EQ(hair.instance_count(), 0u);
  }
}

TEST(MemoryNeed, ExactlySoManyBytesSuffice) {
  for (const Case& one : cases()) {
    const OpenAsset opened(one);
    AlignedBytes memory{std::vector<std::byte>(Hair::memory_need(opened.asset, one.desc).bytes)};
    Hair hair;
    ASSERT_EQ(hair.create(opened.asset, one.desc, memory.bytes()), Status::kOk);
    use(hair, one.desc);
  }
}

TEST(MemoryNeed, NothingBesideThemIsWritten) {
  constexpr std::size_t kBeside = 256;
  constexpr std::byte kMark{0xA5};
  for (const Case& one : cases()) {
    const OpenAsset opened(one);
    const std::size_t bytes = Hair::memory_need(opened.asset, one.desc).bytes;
    AlignedBytes memory{std::vector<std::byte>(kBeside + bytes + kBeside, kMark)};
    Hair hair;
    ASSERT_EQ(hair.create(opened.asset, one.desc, memory.bytes().subspan(kBeside, bytes)), Status::kOk);
    use(hair, one.desc);
    const auto is_marked = [](std::byte b) { return b == kMark; };
    EXPECT_TRUE(std::ranges::all_of(memory.bytes().first(kBeside), is_marked));
    EXPECT_TRUE(std::ranges::all_of(memory.bytes().last(kBeside), is_marked));
  }
}

TEST(MemoryNeed, WhatTheMemoryHeldBeforeDoesNotMatter) {
  for (const Case& one : cases()) {
    const OpenAsset opened(one);
    const std::size_t bytes = Hair::memory_need(opened.asset, one.desc).bytes;
    std::vector<std::vector<Vec3>> ends;
    for (const std::byte before : {std::byte{0}, std::byte{0xFF}}) {
      AlignedBytes memory{std::vector<std::byte>(bytes, before)};
      Hair hair;
      ASSERT_EQ(hair.create(opened.asset, one.desc, memory.bytes()), Status::kOk);
      use(hair, one.desc);
      ends.emplace_back(hair.bone_count());
      ASSERT_EQ(hair.bone_ends(one.desc.instances - 1, ends.back()), Status::kOk);
    }
    EXPECT_EQ(largest_distance(ends[0], ends[1]), 0.0f);
  }
}

// What a head costs in memory.

// 40 of them are the pose that the host told last, so that it may be told again for nothing, and 40 its handle and
// where its numbers are.
TEST(CrowdMemory, AHeadOfNineBonesHasLittleMoreThanHalfAKilobyteOfState) {
  TestRig rig = nine_bone_rig();
  for (DynamicsRecord& bone : rig.dynamics) bone.torsion = kShortestArc;
  AlignedBytes file(write_asset(rig.contents()));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    double most = 0;
    for (std::uint32_t heads = 256; heads < 4096; heads += 16) {
      const std::size_t few = Hair::memory_need(asset, {.instances = heads, .solver = solver}).bytes;
      const std::size_t more = Hair::memory_need(asset, {.instances = heads + 16, .solver = solver}).bytes;
      most = std::max(most, double(more - few) / 16 - double(sizeof(Mat34)) * 10);
    }
    const bool is_passive = solver == &kPassiveSolver;
    const char* const name = is_passive ? "passive" : solver == &kCoifSolver ? "coif" : "thesis";
    std::printf("%s: %.0f bytes a head besides its matrices\n", name, most);
    EXPECT_LE(most, is_passive ? 780.0 : 600.0);
  }
}

TEST(CrowdMemory, LevelsAndIntervalsCostBlocksAndNotHeads) {
  TestRig rig = nine_bone_rig();
  rig.levels = {0, 4, 3, 1, 4, 3, 1, 4, 3, 1};
  AlignedBytes file(write_asset(rig.contents()));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  const auto need = [&](std::uint32_t heads, std::uint32_t interval) {
    return Hair::memory_need(asset, {.instances = heads, .longest_interval = interval}).bytes;
  };
  const std::size_t of_1000 = need(1000, 4) - need(1000, 1), of_4000 = need(4000, 4) - need(4000, 1);
  EXPECT_GT(of_1000, 0u);
  EXPECT_LT(of_4000, of_1000 + of_1000 / 10);
}

}  // namespace coif::memory_test
