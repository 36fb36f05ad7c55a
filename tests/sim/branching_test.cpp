// Chains that branch as far as the format allows.

#include "sim/playback.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

TestBone bone(std::uint32_t parent, const Vec3& direction) {
  return {.parent = parent,
          .joint = {0, 0, -0.12f},
          .rest_direction = direction,
          .length = 0.03f,
          .resistance = 0.3f,
          .friction = 1,
          .stiffness = 900,
          .damping = 60,
          .torsion = 20};
}

/// A spine of `spine` bones, each of which bears a side bone; the deepest bears its own first.
TestRig comb(std::uint32_t spine) {
  TestRig rig;
  for (std::uint32_t i = 0; i < spine; ++i) rig.add(bone(i, {0, -0.8f, -0.6f}));
  for (std::uint32_t i = spine; i > 0; --i) rig.add(bone(i, {i % 2 == 0 ? 0.8f : -0.8f, -0.6f, 0}));
  return rig;
}

/// The spine down to `depth` and the side bone there.
TestRig tooth(std::uint32_t depth) {
  TestRig rig;
  for (std::uint32_t i = 0; i < depth; ++i) rig.add(bone(i, {0, -0.8f, -0.6f}));
  rig.add(bone(depth, {depth % 2 == 0 ? 0.8f : -0.8f, -0.6f, 0}));
  return rig;
}

bool opens(const TestRig& rig) {
  AlignedBytes file(write_asset(rig.contents()));
  return bool(Asset{}.open(file.bytes()));
}

/// Of the side bone at `depth` in a comb's ends.
std::size_t index_of_tooth(std::uint32_t spine, std::uint32_t depth) { return spine + (spine - depth); }

TEST(Branching, AsManyOpenBonesAsTheFormatAllowsAndNoMore) {
  EXPECT_TRUE(opens(comb(kMaxOpenBones)));
  EXPECT_FALSE(opens(comb(kMaxOpenBones + 1)));
}

TEST(Branching, ABranchMovesAsIfItWereAlone) {
  const std::vector<double> frames = even_frames(60, 1.5);
  const Playback all = play(comb(kMaxOpenBones), wander, frames);
  for (std::uint32_t depth = 1; depth <= kMaxOpenBones; ++depth) {
    const Playback alone = play(tooth(depth), wander, frames);
    const std::size_t index = index_of_tooth(kMaxOpenBones, depth);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      ASSERT_EQ(distance(all.ends[f][index], alone.ends[f].back()), 0.0f) << "depth " << depth << ", frame " << f;
    }
  }
}

TEST(Branching, WithoutTwistABranchMovesAsIfItWereAlone) {
  const auto untwisted = [](TestRig rig) {
    for (DynamicsRecord& record : rig.dynamics) record.torsion = kShortestArc;
    return rig;
  };
  const std::vector<double> frames = even_frames(60, 1);
  const Playback all = play(untwisted(comb(kMaxOpenBones)), wander, frames);
  for (std::uint32_t depth = 1; depth <= kMaxOpenBones; depth += 5) {
    const Playback alone = play(untwisted(tooth(depth)), wander, frames);
    const std::size_t index = index_of_tooth(kMaxOpenBones, depth);
    for (std::size_t f = 0; f < frames.size(); ++f) {
      ASSERT_EQ(distance(all.ends[f][index], alone.ends[f].back()), 0.0f) << "depth " << depth << ", frame " << f;
    }
  }
}

TEST(Branching, ChildrenStartWhereTheirParentsEnd) {
  const TestRig rig = comb(kMaxOpenBones);
  for (const Solver* const solver : {&kCoifSolver, &kThesisSolver}) {
    TestHair test(rig, {.solver = solver});
    float bent = 0;
    for (int frame = 1; frame <= 90; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, wander(frame / 60.0)), Status::kOk);
      ASSERT_EQ(test.hair.step({.iterations = kMaxIterations}), Status::kOk);
      const std::vector<Vec3> ends = test.ends();
      bent = std::max(bent, largest_distance(ends, rig.rest_ends()));
      for (std::size_t i = 0; i < ends.size(); ++i) {
        const BoneRecord& record = rig.bones[i + 1];
        const Vec3 joint{record.joint[0], record.joint[1], record.joint[2]};
        // Matrices follow directions: what Algorithm 1 leaves of a length error lies between them and the particles.
        const float slack = solver == &kThesisSolver ? 2e-3f : 1e-5f;
        ASSERT_LT(distance(transformed(test.hair.palette(0)[i + 1], joint), start_of(rig, ends, i)), slack) << i;
      }
    }
    EXPECT_GT(bent, 0.02f);
  }
}

}  // namespace
}  // namespace coif
