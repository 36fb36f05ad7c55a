// One hair of which some chains are cascades and others passive: each moves as it would among its like.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cstring>
#include <vector>

namespace coif::mixed_models_test {

/// Chains of several shapes beside a head; every other one is passive, and of equal shapes both stand side by side.
AssetContents mixed(const TestRig& rig) {
  AssetContents contents = rig.contents();
  for (std::size_t c = 0; c < contents.chains.size(); ++c) {
    contents.chains[c].model = c % 2 == 1 ? ChainModel::kPassive : ChainModel::kCascade;
  }
  return contents;
}

TestRig chains_of(bool twists) {
  TestRig rig = nine_bone_rig();
  for (const int bones : {1, 1, 5, 20, 20, 2}) {
    rig.add_strand(bones, {.joint = {0.01f * float(bones), 0, -0.11f},
                           .rest_direction = {0, -0.8f, -0.6f},
                           .length = 0.4f / float(bones),
                           .friction = 0.5f,
                           .stiffness = 80,
                           .damping = 6});
  }
  for (DynamicsRecord& bone : rig.dynamics) bone.torsion = twists ? 20 : kShortestArc;
  rig.levels.assign(rig.bones.size(), 2);
  rig.levels[0] = 0;
  for (const std::uint32_t tip : {3u, 6u, 9u}) rig.levels[tip] = 1;
  return rig;
}

/// Matrices of every bone of every head after every frame.
std::vector<Mat34> moved(const AssetContents& contents, const Solver& solver, std::uint32_t heads) {
  AlignedBytes file(write_asset(contents));
  Asset asset;
  EXPECT_TRUE(asset.open(file.bytes()));
  const HairDesc desc{.instances = heads, .solver = &solver, .longest_interval = 2};
  const MemoryNeed need = Hair::memory_need(asset, desc);
  AlignedBytes memory{std::vector<std::byte>(need.bytes, std::byte{0xFF})};
  Hair hair;
  EXPECT_EQ(hair.create(asset, desc, memory.bytes()), Status::kOk);
  std::vector<Mat34> all;
  Violence violence(7);
  StepSettings settings;
  settings.substeps = 2;
  for (int frame = 0; frame < 90; ++frame) {
    for (std::uint32_t i = 0; i < heads; ++i) {
      const HeadPose pose = frame < 60 ? wander(0.02 * frame + i) : violence.next();
      if (frame % 30 == 29) {
        EXPECT_EQ(hair.teleport(i, pose), Status::kOk);
      }
      if (frame % 40 == 39) {
        EXPECT_EQ(hair.reset(i, pose), Status::kOk);
      }
      EXPECT_EQ(hair.set_head(i, pose), Status::kOk);
      if (frame % 10 == 5) {
        const bool far = (frame / 10 + int(i)) % 3 == 0;
        EXPECT_EQ(hair.set_detail(i, {.level = far ? 1u : 0u, .interval = far ? 2u : 1u}), Status::kOk);
      }
    }
    EXPECT_EQ(hair.step(settings), Status::kOk);
    for (std::uint32_t i = 0; i < heads; ++i) {
      const std::span<const Mat34> palette = hair.palette(i);
      all.insert(all.end(), palette.begin(), palette.end());
    }
  }
  return all;
}

TEST(MixedModels, EachChainMovesAsAmongItsLike) {
  for (const bool twists : {false, true}) {
    const AssetContents contents = mixed(chains_of(twists));
    for (const std::uint32_t heads : {1u, 3u, 20u}) {  // few heads are in rows by chains, many by heads
      const std::vector<Mat34> both = moved(contents, kCoifSolver, heads);
      const std::vector<Mat34> cascade = moved(contents, kCascadeSolver, heads);
      const std::vector<Mat34> passive = moved(contents, kPassiveSolver, heads);
      ASSERT_EQ(both.size(), cascade.size());
      std::size_t differ = 0, apart = 0;
      for (std::size_t i = 0; i < both.size(); ++i) {
        const BoneRecord& bone = contents.bones[i % contents.bones.size()];
        const bool is_passive = bone.chain != kNone && contents.chains[bone.chain].model == ChainModel::kPassive;
        const Mat34& expected = is_passive ? passive[i] : cascade[i];
        differ += std::memcmp(&both[i], &expected, sizeof(Mat34)) != 0;
        apart += std::memcmp(&passive[i], &cascade[i], sizeof(Mat34)) != 0;
      }
      EXPECT_EQ(differ, 0u) << heads << " heads" << (twists ? ", twisting" : "");
      EXPECT_GT(apart, both.size() / 2) << "or both would be one model";
    }
  }
}

TEST(MixedModels, AModelThatIsUnknownIsRefused) {
  AssetContents contents = mixed(chains_of(false));
  contents.chains[2].model = ChainModel(2);
  AlignedBytes file(write_asset(contents));
  Asset asset;
  const LoadStatus status = asset.open(file.bytes());
  EXPECT_EQ(status.code, LoadCode::kEnumerator);
  EXPECT_EQ(status.item, 2u);
}

}  // namespace coif::mixed_models_test
