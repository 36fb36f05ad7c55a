// The same input gives the same bits, whoever else is simulated.

#include "models/playback.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cstring>

namespace coif::determinism_test {

TestRig rig() {
  TestRig rig = calm_strand(5, 0.3f);
  rig.add_ellipsoid({0, 0, 0}, {0.09f, 0.13f, 0.11f});
  rig.add_tapered_capsule({-0.1f, -0.2f, -0.1f}, 0.05f, {0.1f, -0.2f, -0.1f}, 0.03f);
  return rig;
}

/// A minute of a game: irregular frames, sub-steps, a teleport.
void play_a_while(Hair& hair, std::uint32_t instance, int frames = 400) {
  Violence random(21);
  double now = 0;
  for (int frame = 0; frame < frames; ++frame) {
    StepSettings settings{.dt = float(random.between(0.003, 0.05)), .substeps = 1 + std::uint32_t(frame) / 100};
    now += settings.dt;
    const HeadPose pose = wander(now);
    ASSERT_EQ(frame == 200 ? hair.teleport(instance, {{9, 9, 9}, {}}) : hair.set_head(instance, pose), Status::kOk);
    ASSERT_EQ(hair.step(settings), Status::kOk);
  }
}

void expect_same_bits(const Hair& a, std::uint32_t of_a, const Hair& b, std::uint32_t of_b) {
  const auto first = a.palette(of_a), second = b.palette(of_b);
  ASSERT_EQ(first.size(), second.size());
  ASSERT_GT(first.size(), 1u);
  EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size_bytes()), 0);
}

TEST(Determinism, TheSameInputTwiceGivesTheSameBits) {
  TestHair a(rig()), b(rig());
  play_a_while(a.hair, 0);
  play_a_while(b.hair, 0);
  expect_same_bits(a.hair, 0, b.hair, 0);
  EXPECT_EQ(largest_distance(a.ends(), b.ends()), 0.0f);
}

TEST(Determinism, OtherInstancesBesideItChangeNoBit) {
  TestHair alone(rig()), crowd(rig(), 7);
  play_a_while(alone.hair, 0);
  for (std::uint32_t i = 0; i < 7; ++i)
    ASSERT_EQ(crowd.hair.reset(i, i == 4 ? HeadPose{} : HeadPose{{1.0 * i, 2, 3}, turned_about({0, 1, 0}, i)}),
              Status::kOk);
  play_a_while(crowd.hair, 4);
  expect_same_bits(alone.hair, 0, crowd.hair, 4);
}

TEST(Determinism, ResetForgetsEverything) {
  TestHair used(rig()), fresh(rig());
  play_a_while(used.hair, 0);
  ASSERT_EQ(used.hair.reset(0, {}), Status::kOk);
  play_a_while(used.hair, 0, 20);  // before damping makes them one
  play_a_while(fresh.hair, 0, 20);
  expect_same_bits(used.hair, 0, fresh.hair, 0);
}

// What must not change a single bit: the instruction set, the other instances, the order and the threads of the work.

/// Both solvers, with and without changes of detail.
std::vector<FeaturePlay> plays(std::uint32_t instances) {
  std::vector<FeaturePlay> all;
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    for (const bool changes : {false, true}) {
      all.push_back({.solver = solver, .instances = instances, .changes_detail = changes});
    }
  }
  return all;
}

std::string name_of(const FeaturePlay& play) {
  const std::string solver = play.solver == &kCoifSolver ? "coif" : "thesis";
  return solver + (play.changes_detail ? " with" : " without") + " changes of detail";
}

TEST(LaneDeterminism, EveryInstructionSetGivesTheSameBits) {
  for (const std::uint32_t instances : {1u, 2u, 18u}) {
    for (FeaturePlay play : plays(instances)) {
      play.set = plainest_set();
      const std::vector<std::uint64_t> expected = digests(play);
      for (const InstructionSet set : runnable_sets()) {
        play.set = set;
        EXPECT_EQ(digests(play), expected) << instances << " heads, " << name_of(play) << ", " << coif::name_of(set);
      }
    }
  }
}

TEST(LaneDeterminism, HowManyOthersThereAreChangesNoBit) {
  for (FeaturePlay play : plays(34)) {
    const std::vector<std::uint64_t> expected = digests(play);
    for (const std::uint32_t instances : {1u, 2u, 17u}) {  // one and two in rows by chains, the rest by heads
      play.instances = instances;
      const std::vector<std::uint64_t> found = digests(play);
      for (std::uint32_t i = 0; i < instances; ++i) {
        EXPECT_EQ(found[i], expected[i]) << i << " of " << instances << ", " << name_of(play);
      }
    }
  }
}

TEST(LaneDeterminism, TheOrderOfCallsAndJobsChangesNoBit) {
  for (FeaturePlay play : plays(34)) {
    const std::vector<std::uint64_t> expected = digests(play);
    play.descending_heads = true;
    EXPECT_EQ(digests(play), expected) << "heads set in descending order, " << name_of(play);
    play.jobs = JobOrder::kDescending;
    EXPECT_EQ(digests(play), expected) << "jobs run in descending order, " << name_of(play);
  }
}

TEST(LaneDeterminism, TwoThreadsChangeNoBit) {
  for (FeaturePlay play : plays(34)) {
    const std::vector<std::uint64_t> expected = digests(play);
    play.jobs = JobOrder::kTwoThreads;
    EXPECT_EQ(digests(play), expected) << name_of(play);
  }
}

TEST(LaneDeterminism, TheGameMatters) {
  const std::vector<std::uint64_t> all = digests({.instances = 3});
  EXPECT_NE(all[0], all[1]);
  EXPECT_NE(all, digests({.solver = &kThesisSolver, .instances = 3}));
  EXPECT_NE(all, digests({.instances = 3, .frames = 79}));
  EXPECT_NE(all, digests({.instances = 3, .changes_detail = true}));
  EXPECT_NE(all, digests({.instances = 3, .sleep_after = 1e9f})) << "or nobody sleeps";
}

/// One number for a whole game.
std::uint64_t digest(const Solver* solver, InstructionSet set) {
  std::uint64_t all = 0;
  for (const std::uint64_t hash : digests({.solver = solver, .set = set, .instances = 3, .changes_detail = true})) {
    all = all * 1099511628211u + hash;
  }
  return all;
}

/// The same bits on every processor, by every compiler, with and without optimisation. A change of how hair moves
/// changes them: then put the numbers that this test prints here, and say in CHANGELOG.md that hair moves differently.
TEST(LaneDeterminism, BitsAreThoseOfEveryOtherBuild) {
  constexpr std::uint64_t kCoif = 7255423148557326642u, kThesis = 14597022654990503538u,
                          kPassive = 10493040610176935756u;
  for (const InstructionSet set : runnable_sets()) {
    EXPECT_EQ(digest(&kCoifSolver, set), kCoif) << coif::name_of(set);
    EXPECT_EQ(digest(&kThesisSolver, set), kThesis) << coif::name_of(set);
    EXPECT_EQ(digest(&kPassiveSolver, set), kPassive) << coif::name_of(set);
  }
}

// A hundred heads to which anything may happen at any time: each must fare as if nothing happened to the others.

constexpr std::uint32_t kHeads = 100;
constexpr int kFrames = 200;

/// The life of one head, drawn at random, the same for the same number.
class Life {
 public:
  explicit Life(std::uint32_t number) : random_(number * 7919 + 1) {}

  void live(Hair& hair, std::uint32_t instance) {
    const double what = random_.between(0, 1);
    if (what < 0.06) stands_ = !stands_;
    if (what > 0.9) {
      EXPECT_EQ(hair.set_detail(instance, detail()), Status::kOk);
    }
    if (!stands_) here_ = wander(now_ += 1.0 / 60);
    if (stands_) {
      EXPECT_EQ(hair.set_head(instance, here_), Status::kOk);
    } else if (what > 0.55 && what < 0.57) {
      EXPECT_EQ(hair.reset(instance, here_), Status::kOk);
    } else if (what > 0.6 && what < 0.63) {
      EXPECT_EQ(hair.teleport(instance, here_), Status::kOk);
    } else if (what > 0.15) {  // else the game forgot it for a frame
      EXPECT_EQ(hair.set_head(instance, here_), Status::kOk);
    }
  }

 private:
  Detail detail() {
    const auto level = std::uint32_t(random_.between(0, 3));
    const std::uint32_t intervals[] = {1, 2, 4};
    const std::uint32_t interval = intervals[int(random_.between(0, 3))];
    return {.level = level, .interval = interval, .simulated = random_.between(0, 1) > 0.2};
  }

  Violence random_;
  bool stands_ = true;
  double now_ = 0;
  HeadPose here_;
};

struct Seen {
  std::vector<Mat34> palette;
  bool is_asleep;
};

/// What one head does among others; `lives` says whose lives are lived.
std::vector<Seen> watch(const Solver* solver, std::uint32_t watched, bool all_live) {
  TestHair test(feature_rig(), {.instances = kHeads, .solver = solver, .longest_interval = 4});
  std::vector<Life> lives;
  for (std::uint32_t i = 0; i < kHeads; ++i) lives.emplace_back(i);
  std::vector<Seen> seen;
  for (int frame = 0; frame < kFrames; ++frame) {
    for (std::uint32_t i = 0; i < kHeads; ++i) {
      if (all_live || i == watched) lives[i].live(test.hair, i);
    }
    const StepSettings settings{.dt = frame % 3 == 0 ? 0.02f : 0.015f, .sleep_after = 0.1f, .sleep_speed = 2.0f};
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    const auto palette = test.hair.palette(watched);
    seen.push_back({{palette.begin(), palette.end()}, test.hair.is_asleep(watched)});
  }
  return seen;
}

TEST(CrowdWalk, EveryHeadFaresAsIfNothingHappenedToTheOthers) {
  int asleep = 0;
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    for (const std::uint32_t watched : {0u, 1u, 15u, 16u, 37u, 64u, 98u, 99u}) {
      const std::vector<Seen> among = watch(solver, watched, true), alone = watch(solver, watched, false);
      for (int frame = 0; frame < kFrames; ++frame) {
        const Seen &a = among[std::size_t(frame)], &b = alone[std::size_t(frame)];
        ASSERT_EQ(std::memcmp(a.palette.data(), b.palette.data(), a.palette.size() * sizeof(Mat34)), 0)
            << "head " << watched << ", frame " << frame;
        ASSERT_EQ(a.is_asleep, b.is_asleep) << "head " << watched << ", frame " << frame;
        asleep += a.is_asleep ? 1 : 0;
      }
    }
  }
  EXPECT_GT(asleep, 100);
}

}  // namespace coif::determinism_test
