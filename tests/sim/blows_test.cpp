// Hair that is thrown against a collider of its head in the midst of a step: each head fares as if the others, whose
// hair arrives at other times, were not there.

#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>
#include <span>
#include <vector>

namespace coif::blows_test {

constexpr std::uint32_t kHeads = 16;
constexpr int kFrames = 60;

/// Two strands of passive hair, one of them in front of a ball.
TestRig rig() {
  TestRig rig;
  rig.model = ChainModel::kPassive;
  for (const float z : {0.0f, 0.05f}) {
    TestBone bone{.joint = {0, 0, z}, .length = 0.06f, .friction = 0.5f};
    bone.stiffness = 25;
    bone.damping = 3;
    bone.torsion = kShortestArc;
    rig.add_strand(5, bone);
  }
  rig.add_sphere({0.02f, -0.2f, 0.14f}, 0.08f);
  return rig;
}

/// Each head bows at its own time, to its own depth.
HeadPose bowing(std::uint32_t head, int frame) {
  const double begins = 3 + 0.7 * head, share = std::clamp((frame - begins) / 14, 0.0, 1.0);
  const float aside = 0.03f * float(head);
  return {{0, 0.1 * share, 0}, turned_about({std::cos(aside), std::sin(aside), 0}, (1.4 + 0.05 * head) * share)};
}

struct Way {
  const Solver* solver = &kCoifSolver;
  InstructionSet set = InstructionSet::kBest;
  std::uint32_t substeps = 1;
};

/// All matrices, frame by frame, that the last of these heads has in company of the others.
std::vector<Mat34> last_of(std::span<const std::uint32_t> heads, const Way& way) {
  const auto last = std::uint32_t(heads.size()) - 1;
  TestHair test(rig(), {.instances = last + 1, .solver = way.solver, .instruction_set = way.set});
  std::vector<Mat34> seen;
  for (int frame = 0; frame < kFrames; ++frame) {
    for (std::uint32_t i = 0; i <= last; ++i) {
      EXPECT_EQ(test.hair.set_head(i, bowing(heads[i], frame)), Status::kOk);
    }
    EXPECT_EQ(test.hair.step({.substeps = way.substeps}), Status::kOk);
    const auto palette = test.hair.palette(last);
    seen.insert(seen.end(), palette.begin(), palette.end());
  }
  return seen;
}

bool same_bits(const std::vector<Mat34>& a, const std::vector<Mat34>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat34)) == 0;
}

std::vector<std::uint32_t> all_but_last(std::uint32_t last) {
  std::vector<std::uint32_t> heads;
  for (std::uint32_t i = 0; i < kHeads; ++i) {
    if (i != last) heads.push_back(i);
  }
  heads.push_back(last);
  return heads;
}

TEST(Blows, HairOfOtherHeadsThatArrivesAtOtherTimesChangesNoBit) {
  for (std::uint32_t head = 0; head < kHeads; ++head) {
    for (const std::uint32_t substeps : {1u, 3u}) {
      const Way way{.substeps = substeps};
      EXPECT_TRUE(same_bits(last_of(all_but_last(head), way), last_of({{head}}, way))) << head << ", " << substeps;
    }
  }
}

TEST(Blows, HowManyLanesThereAreChangesNoBit) {
  const auto heads = all_but_last(5);
  const std::vector<Mat34> expected = last_of(heads, {.set = plainest_set()});
  for (const InstructionSet set : runnable_sets()) {
    EXPECT_TRUE(same_bits(last_of(heads, {.set = set}), expected)) << name_of(set);
  }
}

TEST(Blows, CodeForCharactersThatIsToldNothingMovesThemAlike) {
  EXPECT_TRUE(same_bits(last_of({{3}}, {.solver = &kCharacterSolver}), last_of({{3}}, {})));
}

/// The hair of most heads is first at the ball at some other time, and none gets into it.
TEST(Blows, HeadsHairArrivesAtUnlikeTimes) {
  std::set<int> arrivals;
  for (std::uint32_t head = 0; head < kHeads; ++head) {
    TestHair test(rig());
    int arrived = -1;
    for (int frame = 0; frame < kFrames; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, bowing(head, frame)), Status::kOk);
      ASSERT_EQ(test.hair.step({}), Status::kOk);
      for (const Vec3& end : test.ends()) {
        const float gap = distance(end, {0.02f, -0.2f, 0.14f}) - 0.08f;
        EXPECT_GT(gap, -1e-4f);
        if (gap < 5e-3f && arrived < 0) arrived = frame;
      }
    }
    EXPECT_GE(arrived, 0) << head;
    arrivals.insert(arrived);
  }
  EXPECT_GE(arrivals.size(), 8u);
}

/// A bone that stands off a ball, and whose start rounding or a blow has put a little below the surface, stays as it
/// is.
TEST(Blows, ABoneThatLeadsOutOfTheBallItStartsAtIsNotTurned) {
  for (const ChainModel model : {ChainModel::kCascade, ChainModel::kPassive}) {
    for (const float depth : {0.0f, 1e-7f, 1e-5f, 5e-5f}) {
      for (const float rise : {0.1f, 0.3f, 1.0f}) {
        TestRig rig;
        rig.model = model;
        TestBone bone{.joint = {0, 0.1f - depth, 0}, .length = 0.06f};
        bone.rest_direction = {std::cos(rise), std::sin(rise), 0};
        bone.stiffness = 1e4f;
        bone.damping = 50;
        rig.add_strand(2, bone);
        TestRig bald = rig;
        rig.add_sphere({0, 0, 0}, 0.1f);
        TestHair test(rig), free(bald);
        for (int frame = 0; frame < 10; ++frame) {
          ASSERT_EQ(test.hair.step({}), Status::kOk);
          ASSERT_EQ(free.hair.step({}), Status::kOk);
          ASSERT_LT(largest_distance(test.ends(), free.ends()), 1e-4f) << depth << ", " << rise << ", frame " << frame;
        }
      }
    }
  }
}

}  // namespace coif::blows_test
