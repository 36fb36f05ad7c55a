// Algorithm 1 reads what the artist asked for, whatever a chain was given to have one motion; the others what it was
// given.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <vector>

namespace coif::asked_numbers_test {

constexpr float kAsked[] = {0.5f, 3.0f, 9.0f};  ///< 1/s, of the three bones of each chain

/// Three chains of three bones: friction as asked for, but for those bones that are given more.
AssetContents hair(float least_given) {
  AssetContents contents = nine_bone_rig().contents();
  for (std::size_t b = 1; b < contents.bones.size(); ++b) {
    contents.dynamics[b].resistance = 0.1f;
    contents.dynamics[b].friction = std::max(kAsked[(b - 1) % 3], least_given);
  }
  return contents;
}

/// As a cook writes it that gave the chains more friction.
AssetContents conditioned() {
  AssetContents contents = hair(30);
  for (const DynamicsRecord& bone : hair(0).dynamics) contents.asked.push_back({bone.friction, bone.damping, 1});
  return contents;
}

std::vector<Mat34> moved(const AssetContents& contents, const Solver& solver, std::uint32_t heads) {
  AlignedBytes file(write_asset(contents));
  Asset asset;
  EXPECT_TRUE(asset.open(file.bytes()));
  const HairDesc desc{.instances = heads, .solver = &solver};
  AlignedBytes memory{std::vector<std::byte>(Hair::memory_need(asset, desc).bytes, std::byte{0xFF})};
  Hair hair;
  EXPECT_EQ(hair.create(asset, desc, memory.bytes()), Status::kOk);
  std::vector<Mat34> all;
  for (int frame = 0; frame < 60; ++frame) {
    for (std::uint32_t i = 0; i < heads; ++i) EXPECT_EQ(hair.set_head(i, wander(0.02 * frame + i)), Status::kOk);
    EXPECT_EQ(hair.step(StepSettings{}), Status::kOk);
    for (std::uint32_t i = 0; i < heads; ++i) all.insert(all.end(), hair.palette(i).begin(), hair.palette(i).end());
  }
  return all;
}

bool same(const std::vector<Mat34>& a, const std::vector<Mat34>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat34)) == 0;
}

TEST(AskedNumbers, AreThoseOfAlgorithmOne) {
  for (const std::uint32_t heads : {1u, 40u}) {  // chains beside each other in a vector, and heads
    EXPECT_TRUE(same(moved(conditioned(), kThesisSolver, heads), moved(hair(0), kThesisSolver, heads))) << heads;
    EXPECT_FALSE(same(moved(hair(30), kThesisSolver, heads), moved(hair(0), kThesisSolver, heads))) << heads;
  }
}

TEST(AskedNumbers, AreNotThoseOfTheOtherSolvers) {
  for (const Solver* solver : {&kCoifSolver, &kCascadeSolver, &kPassiveSolver}) {
    EXPECT_TRUE(same(moved(conditioned(), *solver, 3), moved(hair(30), *solver, 3)));
  }
}

}  // namespace coif::asked_numbers_test
