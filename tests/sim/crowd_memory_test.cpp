// What a head costs in memory.

#include "sim/test_rig.h"

#include <gtest/gtest.h>

#include <cstdio>

namespace coif {
namespace {

TEST(CrowdMemory, AHeadOfNineBonesHasHalfAKilobyteOfState) {
  TestRig rig = nine_bone_rig();
  for (DynamicsRecord& bone : rig.dynamics) bone.torsion = kShortestArc;
  AlignedBytes file(write_asset(rig.contents()));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  for (const Solver* const solver : {&kCoifSolver, &kThesisSolver}) {
    double most = 0;
    for (std::uint32_t heads = 256; heads < 4096; heads += 16) {
      const std::size_t few = Hair::memory_need(asset, {.instances = heads, .solver = solver}).bytes;
      const std::size_t more = Hair::memory_need(asset, {.instances = heads + 16, .solver = solver}).bytes;
      most = std::max(most, double(more - few) / 16 - double(sizeof(Mat34)) * 10);
    }
    std::printf("%s: %.0f bytes a head besides its matrices\n", solver == &kCoifSolver ? "coif" : "thesis", most);
    EXPECT_LE(most, 512.0);
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

}  // namespace
}  // namespace coif
