// Less detail for what is far away or out of sight: what it saves, and what nobody may see of it.

#include "models/playback.h"

#include <coif/lod.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <vector>

namespace coif::detail_test {

const Solver* const kSolvers[] = {&kCoifSolver, &kPassiveSolver, &kThesisSolver};

/// Two strands of four bones. Level 1 lacks the last two bones of both, level 2 all bones but the first one's first.
TestRig rig() {
  TestRig rig;
  rig.levels = {0, 3, 2, 1, 1, 2, 2, 1, 1};
  for (const float side : {-0.05f, 0.05f}) {
    std::uint32_t parent = 0;
    for (int i = 0; i < 4; ++i) {
      parent = rig.add({.parent = parent,
                        .joint = {side, 0.02f, -0.12f},
                        .rest_direction = {0, -0.8f, -0.6f},
                        .length = 0.08f,
                        .resistance = 0.35f,  // less, and Algorithm 1 never comes to rest
                        .friction = 3,
                        .stiffness = 500,
                        .damping = 45,
                        .torsion = 20});
    }
  }
  rig.levels[5] = 3;  // whatever hangs from the head is simulated in every level
  return rig;
}

StepSettings sleepless() {
  StepSettings settings;
  settings.sleep_after = INFINITY;
  return settings;
}

StepSettings weightless() {
  StepSettings settings = sleepless();
  settings.environment.gravity = {};
  return settings;
}

bool same_bits(std::span<const Mat34> a, std::span<const Mat34> b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size_bytes()) == 0;
}

double largest_difference(const Mat34& a, const Mat34& b) {
  double most = 0;
  for (int i = 0; i < 12; ++i) most = std::max(most, std::fabs(double(a.m[i / 4][i % 4]) - b.m[i / 4][i % 4]));
  return most;
}

void advance(TestHair& test, double now, const StepSettings& settings) {
  for (std::uint32_t i = 0; i < test.hair.instance_count(); ++i) {
    ASSERT_EQ(test.hair.set_head(i, wander(now)), Status::kOk);
  }
  ASSERT_EQ(test.hair.step(settings), Status::kOk);
}

TEST(DetailLevel, BonesThatItLacksAreRigidToTheirParents) {
  TestHair test(rig());
  for (std::uint32_t level = 0; level < 3; ++level) {
    ASSERT_EQ(test.hair.set_detail(0, {.level = level}), Status::kOk);
    ASSERT_EQ(test.hair.reset(0, wander(0)), Status::kOk);
    double bent[9] = {};
    for (int frame = 1; frame <= 90; ++frame) {
      advance(test, frame / 60.0, sleepless());
      for (std::size_t i = 1; i < 9; ++i) {
        const std::uint32_t parent = rig().bones[i].parent;
        bent[i] = std::max(bent[i], largest_difference(test.hair.palette(0)[i], test.hair.palette(0)[parent]));
      }
    }
    for (std::size_t i = 1; i < 9; ++i) {
      if (rig().levels[i] > level) {
        EXPECT_GT(bent[i], 1e-3) << "level " << level << ", bone " << i;
      } else {
        EXPECT_LT(bent[i], 1e-5) << "level " << level << ", bone " << i;
      }
    }
  }
}

TEST(DetailLevel, BonesThatEveryLevelHasMoveAlikeInAll) {
  TestHair fine(rig()), coarse(rig());
  ASSERT_EQ(coarse.hair.set_detail(0, {.level = 2}), Status::kOk);
  for (int frame = 1; frame <= 90; ++frame) {
    advance(fine, frame / 60.0, sleepless());
    advance(coarse, frame / 60.0, sleepless());
    for (const std::size_t bone : {1u, 5u}) {
      ASSERT_EQ(largest_difference(fine.hair.palette(0)[bone], coarse.hair.palette(0)[bone]), 0.0) << frame;
    }
  }
}

TEST(DetailLevel, RefiningDoesNotJump) {
  for (const int when : {10, 23, 40, 61}) {
    TestHair test(rig());
    ASSERT_EQ(test.hair.set_detail(0, {.level = 2}), Status::kOk);
    for (int frame = 1; frame <= when; ++frame) advance(test, frame / 60.0, sleepless());
    const std::vector<Vec3> before = test.ends();
    ASSERT_EQ(test.hair.set_detail(0, {.level = 0}), Status::kOk);
    EXPECT_EQ(largest_distance(test.ends(), before), 0.0f);
    StepSettings settings = sleepless();
    settings.dt = 1e-4f;
    advance(test, when / 60.0 + 1e-4, settings);
    EXPECT_LT(largest_distance(test.ends(), before), 5e-4f) << "5 m/s, at " << when;
    for (int frame = 1; frame <= 60; ++frame) {
      const std::vector<Vec3> last = test.ends();
      advance(test, when / 60.0 + 1e-4 + frame / 60.0, sleepless());
      ASSERT_LT(largest_distance(test.ends(), last), 0.05f) << "3 m/s, " << frame << " after " << when;
    }
  }
}

TEST(DetailInterval, IsALongerStep) {
  for (const Solver* const solver : kSolvers) {
    for (const std::uint32_t interval : {2u, 4u}) {
      TestHair rare(rig(), {.solver = solver, .longest_interval = 4}), slow(rig(), {.solver = solver});
      ASSERT_EQ(rare.hair.set_detail(0, {.interval = interval}), Status::kOk);
      StepSettings often = sleepless(), seldom = sleepless();
      often.dt = 1.0f / 128;
      seldom.dt = often.dt * float(interval);
      often.substeps = 1;
      seldom.substeps = interval;
      int steps = 0;
      for (int frame = 1; frame <= 200; ++frame) {
        const std::vector<Mat34> before(rare.hair.palette(0).begin(), rare.hair.palette(0).end());
        advance(rare, frame / 128.0, often);
        if (same_bits(rare.hair.palette(0), before)) continue;
        ++steps;
        advance(slow, frame / 128.0, seldom);
        ASSERT_LT(largest_distance(rare.ends(), slow.ends()), 2e-6f) << interval << ", frame " << frame;
      }
      EXPECT_EQ(steps, 200 / int(interval));
    }
  }
}

TEST(DetailInterval, FollowsThePathOfEveryStep) {
  for (const std::uint32_t interval : {2u, 4u}) {
    TestHair rare(rig(), {.longest_interval = 4}), always(rig());
    ASSERT_EQ(rare.hair.set_detail(0, {.interval = interval}), Status::kOk);
    double sum = 0, moved = 0;
    int count = 0;
    for (int frame = 1; frame <= 600; ++frame) {
      const HeadPose pose = nod(frame / 120.0);
      StepSettings settings = sleepless();
      settings.dt = 1.0f / 120;
      const std::vector<Mat34> before(rare.hair.palette(0).begin(), rare.hair.palette(0).end());
      for (TestHair* test : {&rare, &always}) {
        ASSERT_EQ(test->hair.set_head(0, pose), Status::kOk);
        ASSERT_EQ(test->hair.step(settings), Status::kOk);
      }
      if (same_bits(rare.hair.palette(0), before)) continue;
      const float apart = largest_distance(rare.ends(), always.ends());
      sum += double(apart) * apart;
      moved = std::max(moved, double(largest_distance(always.ends(), rig().rest_ends())));
      ++count;
    }
    EXPECT_LT(std::sqrt(sum / count), 0.02 * moved) << interval;
    EXPECT_GT(moved, 0.05);
  }
}

TEST(DetailInterval, SpreadsACrowdEvenlyOverTheSteps) {
  TestHair test(rig(), {.instances = 64, .longest_interval = 4});
  for (std::uint32_t i = 0; i < 64; ++i) ASSERT_EQ(test.hair.set_detail(i, {.interval = 4}), Status::kOk);
  for (int frame = 0; frame < 12; ++frame) {
    ASSERT_EQ(test.hair.begin_step(sleepless()), Status::kOk);
    EXPECT_EQ(test.hair.job_count(), 1u) << frame;
    test.hair.run_job(0);
    test.hair.finish_step();
  }
}

TEST(DetailInterval, ChangesThrowNoHair) {
  for (const Solver* const solver : kSolvers) {
    constexpr std::uint32_t kCount = 70;
    TestHair test(rig(), {.instances = kCount, .solver = solver, .longest_interval = 4});
    const std::uint32_t intervals[] = {1, 4, 2, 1, 2, 4};
    for (int frame = 0; frame <= 300; ++frame) {
      for (std::uint32_t i = 0; i < kCount; ++i) {
        const HeadPose pose{{0.05 * frame, 0, 0.02 * frame}, {}};  // 3 m/s
        ASSERT_EQ(frame == 0 ? test.hair.reset(i, pose) : test.hair.set_head(i, pose), Status::kOk);
        const std::uint32_t interval = frame < 150 ? 1 : intervals[(std::uint32_t(frame) / 5 + i) % 6];
        ASSERT_EQ(test.hair.set_detail(i, {.interval = interval}), Status::kOk);
      }
      ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
      if (frame < 150) continue;  // the start at that speed throws it
      for (std::uint32_t i = 0; i < kCount; ++i) {
        ASSERT_LT(largest_distance(test.ends(i), rig().rest_ends()), 1e-4f) << "frame " << frame << ", head " << i;
      }
    }
  }
}

TEST(DetailOutOfSight, CostsNoJobAndKeepsTheMatrices) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(rig(), {.instances = 20, .solver = solver});
    for (int frame = 1; frame <= 30; ++frame) advance(test, frame / 60.0, sleepless());
    for (std::uint32_t i = 0; i < 20; ++i) ASSERT_EQ(test.hair.set_detail(i, {.simulated = false}), Status::kOk);
    const std::vector<Mat34> before(test.hair.palette(7).begin(), test.hair.palette(7).end());
    for (int frame = 31; frame <= 60; ++frame) {
      for (std::uint32_t i = 0; i < 20; ++i) ASSERT_EQ(test.hair.set_head(i, wander(frame / 60.0)), Status::kOk);
      ASSERT_EQ(test.hair.begin_step(sleepless()), Status::kOk);
      ASSERT_EQ(test.hair.job_count(), 0u);
      test.hair.finish_step();
      ASSERT_TRUE(same_bits(test.hair.palette(7), before));
    }
  }
}

TEST(DetailOutOfSight, ComesBackWithItsShapeAndWithoutCatchingUp) {
  for (const Solver* const solver : kSolvers) {
    TestHair test(rig(), {.solver = solver});
    for (int frame = 1; frame <= 40; ++frame) advance(test, frame / 60.0, sleepless());
    const std::vector<Vec3> before = test.ends();
    ASSERT_GT(largest_distance(before, rig().rest_ends()), 0.01f);
    ASSERT_EQ(test.hair.set_detail(0, {.simulated = false}), Status::kOk);
    for (int frame = 0; frame < 100; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, {{0.5 * frame, 3, 0}, turned_about({0.6f, 0, 0.8f}, 0.1 * frame)}), Status::kOk);
      ASSERT_EQ(test.hair.step(sleepless()), Status::kOk);
    }
    EXPECT_LT(largest_distance(test.ends(), before), 1e-5f);
    ASSERT_EQ(test.hair.set_detail(0, {}), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), before), 1e-5f) << "the same shape under the head's new rotation";
    StepSettings instant = sleepless();
    instant.dt = 1e-3f;
    instant.iterations = kMaxIterations;
    ASSERT_EQ(test.hair.step(instant), Status::kOk);
    // From rest: by what gravity and the springs do within a millisecond; Algorithm 1 pulls by its share in every step.
    const float far = solver == &kThesisSolver ? 0.9f * largest_distance(before, rig().rest_ends()) : 1e-3f;
    EXPECT_LT(largest_distance(test.ends(), before), far);
    for (int frame = 0; frame < 600; ++frame) ASSERT_EQ(test.hair.step(sleepless()), Status::kOk);
    TestHair settled(rig(), {.solver = solver});
    ASSERT_EQ(settled.hair.reset(0, {{}, turned_about({0.6f, 0, 0.8f}, 9.9)}), Status::kOk);
    for (int frame = 0; frame < 600; ++frame) ASSERT_EQ(settled.hair.step(sleepless()), Status::kOk);
    EXPECT_LT(largest_distance(test.ends(), settled.ends()), 1e-3f);
  }
}

TEST(DetailOutOfSight, ResetWorksThereToo) {
  TestHair test(rig());
  for (int frame = 1; frame <= 40; ++frame) advance(test, frame / 60.0, sleepless());
  ASSERT_EQ(test.hair.set_detail(0, {.simulated = false}), Status::kOk);
  ASSERT_EQ(test.hair.reset(0, {{1, 2, 3}, turned_about({0, 1, 0}, 1)}), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), rig().rest_ends()), 1e-6f);
  ASSERT_EQ(test.hair.set_detail(0, {}), Status::kOk);
  ASSERT_EQ(test.hair.step(weightless()), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), rig().rest_ends()), 1e-5f);
}

TEST(Detail, RefusesWhatTheAssetOrTheDescriptionLacks) {
  TestHair test(rig(), {.instances = 2, .longest_interval = 2});
  TestHair plain(nine_bone_rig());
  const std::vector<std::byte> before = test.memory_copy();
  for (const std::uint32_t level : {3u, 4u, kMaxLods, kNone}) {
    EXPECT_EQ(test.hair.set_detail(0, {.level = level}), Status::kBadArgument) << level;
  }
  for (const std::uint32_t interval : {0u, 3u, 4u, 8u, kNone}) {
    EXPECT_EQ(test.hair.set_detail(0, {.interval = interval}), Status::kBadArgument) << interval;
  }
  EXPECT_EQ(test.hair.set_detail(2, {}), Status::kBadIndex);
  EXPECT_EQ(Hair{}.set_detail(0, {}), Status::kNotCreated);
  EXPECT_EQ(test.memory_copy(), before);
  EXPECT_EQ(plain.hair.set_detail(0, {.level = 1}), Status::kBadArgument) << "an asset without levels has one";
  EXPECT_EQ(plain.hair.set_detail(0, {.interval = 2}), Status::kBadArgument);
  EXPECT_EQ(plain.hair.set_detail(0, {}), Status::kOk);
}

std::vector<LodRecord> levels(std::initializer_list<float> screen_sizes) {
  std::vector<LodRecord> lods;
  for (const float size : screen_sizes) lods.push_back({std::uint32_t(lods.size()), 1, size, 0});
  return lods;
}

const std::vector<LodRecord> kFour = levels({0.5f, 0.2f, 0.05f, 0});

TEST(ScreenShare, IsOneWhereTheHeightFillsTheView) {
  const float fov = 0.8f;
  const float distance = 0.25f / 2 / std::tan(fov / 2);
  EXPECT_NEAR(screen_share(0.25f, distance, fov), 1.0f, 1e-6f);
  EXPECT_NEAR(screen_share(0.25f, 10 * distance, fov), 0.1f, 1e-6f);
}

TEST(ChooseLod, IsTheFinestThatFits) {
  const struct {
    float share;
    std::uint32_t level;
  } cases[] = {{9, 0}, {0.5f, 0}, {0.49f, 1}, {0.2f, 1}, {0.1f, 2}, {0.05f, 2}, {0.01f, 3}, {0, 3}};
  for (const auto& c : cases) {
    for (std::uint32_t current = 0; current < 4; ++current) EXPECT_EQ(choose_lod(kFour, c.share, current, 0), c.level);
  }
}

TEST(ChooseLod, NeverGetsFinerAsTheHeadShrinksNorCoarserAsItGrows) {
  for (const float hysteresis : {0.0f, 0.1f, 0.5f}) {
    std::uint32_t level = 0;
    for (float share = 1; share > 0.001f; share *= 0.99f) {
      const std::uint32_t next = choose_lod(kFour, share, level, hysteresis);
      EXPECT_GE(next, level);
      level = next;
    }
    EXPECT_EQ(level, 3u);
    for (float share = 0.001f; share < 2; share *= 1.01f) {
      const std::uint32_t next = choose_lod(kFour, share, level, hysteresis);
      EXPECT_LE(next, level);
      level = next;
    }
    EXPECT_EQ(level, 0u);
  }
}

TEST(ChooseLod, StaysWhereTheShareTremblesAboutABorder) {
  for (std::uint32_t current : {0u, 1u}) {
    for (const float share : {0.46f, 0.5f, 0.54f}) EXPECT_EQ(choose_lod(kFour, share, current, 0.1f), current);
  }
}

TEST(ChooseLod, LeavesALevelBeyondTheHysteresisAndSkipsLevels) {
  EXPECT_EQ(choose_lod(kFour, 0.44f, 0, 0.1f), 1u);
  EXPECT_EQ(choose_lod(kFour, 0.56f, 1, 0.1f), 0u);
  EXPECT_EQ(choose_lod(kFour, 0.01f, 0, 0.1f), 3u);
  EXPECT_EQ(choose_lod(kFour, 1, 3, 0.1f), 0u);
}

TEST(ChooseLod, NoHysteresisHoldsALevelForEver) {
  for (const float hysteresis : {0.9f, 1.0f, 5.0f, INFINITY}) {
    EXPECT_EQ(choose_lod(kFour, 0.001f, 0, hysteresis), 3u) << hysteresis;
    EXPECT_EQ(choose_lod(kFour, 1, 3, hysteresis), 0u) << hysteresis;
  }
}

TEST(ChooseLod, AlwaysReturnsALevelThatExists) {
  const float odd[] = {NAN, INFINITY, -INFINITY, -1, 0, 1e-38f, 1e38f};
  for (const float share : odd) {
    for (const float hysteresis : odd) {
      for (const std::uint32_t current : {0u, 3u, 4u, kNone}) {
        EXPECT_LT(choose_lod(kFour, share, current, hysteresis), 4u);
      }
    }
  }
  EXPECT_EQ(choose_lod(kFour, NAN, 0, 0.1f), 3u);
  EXPECT_EQ(choose_lod({}, 0.5f, 7, 0.1f), 0u);
  EXPECT_EQ(choose_lod(levels({0}), 0.5f, 0, 0.1f), 0u);
}

}  // namespace coif::detail_test
