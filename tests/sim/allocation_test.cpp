// A program of its own: it counts every allocation of the process.

#include "sim/test_rig.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>

// Seen inlined, free() of what operator new gave looks like a mix-up; here both are ours and belong together.
#pragma GCC diagnostic ignored "-Wmismatched-new-delete"

namespace {
std::size_t allocations = 0;
}

void* operator new(std::size_t bytes) {
  ++allocations;
  if (void* memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace coif {
namespace {

TEST(Allocation, TheCounterCounts) {
  const std::size_t before = allocations;
  const std::vector<int> block(100);
  EXPECT_EQ(allocations, before + 1) << block.size();
}

TEST(Allocation, HairNeverAllocates) {
  AlignedBytes file(write_asset(nine_bone_rig().contents()));
  AlignedBytes memory{std::vector<std::byte>(1 << 20)};
  const std::size_t before = allocations;
  Asset asset;
  Hair hair;
  bool ok = bool(asset.open(file.bytes()));
  ok = ok && hair.create(asset, {.instances = 10}, memory.bytes()) == Status::kOk;
  ok = ok && hair.reset(3, {{0, 1.7, 0}, {}}) == Status::kOk;
  for (int frame = 0; frame < 40; ++frame) {
    const HeadPose pose{{0, 1.7, (frame % 5 == 0 ? 10 : 0.1) * frame}, {}};  // some of them detected as teleports
    ok = ok && (frame % 7 == 0 ? hair.teleport(3, pose) : hair.set_head(3, pose)) == Status::kOk;
    const DynamicsScale scale{.stiffness = 1 + 0.1f * float(frame)};
    ok = ok && hair.step({.substeps = 1 + std::uint32_t(frame) % 4, .dynamics = scale}) == Status::kOk;
    ok = ok && hair.palette(3).size() == 10;
  }
  const bool refused = hair.step({.dt = -1}) == Status::kBadTimeStep;
  EXPECT_EQ(allocations, before);
  EXPECT_TRUE(ok);
  EXPECT_TRUE(refused);
}

}  // namespace
}  // namespace coif
