// Chains of one head that lie in the same vector, some of which meet moving colliders: each fares as if the others were
// not there.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cstring>

namespace coif::neighbours_in_contact_test {

constexpr int kChains = 16, kBones = 5;

/// Equal chains in a line along X, a hand's breadth apart, so that a ball meets few of them.
TestRig row_of_chains(int count) {
  TestRig rig;
  for (int i = 0; i < count; ++i) {
    rig.add_strand(kBones, {.joint = {0.1f * float(i), 0, 0}, .length = 0.06f, .resistance = 0.05f, .friction = 2});
  }
  return rig;
}

/// A slow ball that comes through the line near its beginning and a fast one further on; in the middle both.
void place_balls(double now, MovingCollider (&balls)[2]) {
  for (MovingCollider& ball : balls) ball.radius = 0.07f;
  const auto fast = float(now * 4 - int(now * 4));
  const double slow[3] = {0.45 + 0.3 * now, -0.15, -0.2 + 0.4 * now},
               quick[3] = {0.8 - 0.2 * now, -0.2, -0.5 + double(fast)};
  std::memcpy(balls[0].center, slow, sizeof slow);
  std::memcpy(balls[1].center, quick, sizeof quick);
}

/// All bones' matrices of `frames` frames, as bits.
std::vector<Mat34> play(int chains, InstructionSet set, int frames = 60) {
  TestHair test(row_of_chains(chains), {.solver = &kCharacterSolver, .instruction_set = set, .moving_colliders = 2});
  std::vector<Mat34> seen;
  for (int frame = 0; frame < frames; ++frame) {
    const double now = (frame + 1) / 60.0;
    MovingCollider balls[2];
    place_balls(now, balls);
    EXPECT_EQ(test.hair.set_colliders(0, balls), Status::kOk);
    EXPECT_EQ(test.hair.set_head(0, {{0.1 * now, 0, 0.05 * now}, {}}), Status::kOk);
    EXPECT_EQ(test.hair.step({}), Status::kOk);
    seen.insert(seen.end(), test.hair.palette(0).begin(), test.hair.palette(0).end());
  }
  return seen;
}

bool same_bits(const std::vector<Mat34>& a, const std::vector<Mat34>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat34)) == 0;
}

TEST(NeighboursInContact, HowManyLanesThereAreChangesNoBit) {
  const std::vector<Mat34> expected = play(kChains, plainest_set());
  for (const InstructionSet set : runnable_sets()) EXPECT_TRUE(same_bits(play(kChains, set), expected)) << name_of(set);
}

TEST(NeighboursInContact, OtherChainsOfTheHeadChangeNoBit) {
  const std::vector<Mat34> all = play(kChains, InstructionSet::kBest), few = play(7, InstructionSet::kBest);
  const std::size_t bones = 1 + kChains * kBones, fewer = 1 + 7 * kBones;
  for (std::size_t frame = 0; frame * bones < all.size(); ++frame) {
    ASSERT_EQ(std::memcmp(&all[frame * bones], &few[frame * fewer], fewer * sizeof(Mat34)), 0) << "frame " << frame;
  }
}

TEST(NeighboursInContact, TheBallsMeetSomeOfThem) {
  const std::vector<Mat34> moved = play(kChains, InstructionSet::kBest, 30);
  TestHair alone(row_of_chains(kChains), {.solver = &kCharacterSolver});
  for (int frame = 0; frame < 30; ++frame) {
    const double now = (frame + 1) / 60.0;
    ASSERT_EQ(alone.hair.set_head(0, {{0.1 * now, 0, 0.05 * now}, {}}), Status::kOk);
    ASSERT_EQ(alone.hair.step({}), Status::kOk);
  }
  const auto free = alone.hair.palette(0);
  int met = 0;
  for (std::size_t bone = 0; bone < free.size(); ++bone) {
    met += std::memcmp(&free[bone], &moved[moved.size() - free.size() + bone], sizeof(Mat34)) != 0 ? 1 : 0;
  }
  EXPECT_GT(met, 5);
  EXPECT_LT(met, int(free.size()) - 5);
}

}  // namespace coif::neighbours_in_contact_test
