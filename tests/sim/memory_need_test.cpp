// Memory is asked for exactly: one byte less is refused, that many suffice, and nothing beside them is touched.

#include "formats/aligned_bytes.h"
#include "sim/test_rig.h"

#include <coif/hair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace coif {
namespace {

struct Case {
  HairDesc desc;
  bool rigid = false;
};

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Solver* solver : {&kCoifSolver, &kThesisSolver}) {
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

}  // namespace
}  // namespace coif
