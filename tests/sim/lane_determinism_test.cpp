// What must not change a single bit: the instruction set, the other instances, the order and the threads of the work.

#include "sim/feature_rig.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

/// Both solvers, with and without changes of detail.
std::vector<FeaturePlay> plays(std::uint32_t instances) {
  std::vector<FeaturePlay> all;
  for (const Solver* const solver : {&kCoifSolver, &kThesisSolver}) {
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
      play.set = InstructionSet::kScalar;
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

/// The same bits on every processor, by every compiler, with and without optimisation. A change of how hair moves changes
/// them: then put the numbers that this test prints here, and say in CHANGELOG.md that hair moves differently.
TEST(LaneDeterminism, BitsAreThoseOfEveryOtherBuild) {
  constexpr std::uint64_t kCoif = 2482186261605669836u, kThesis = 14597022654990503538u;
  for (const InstructionSet set : runnable_sets()) {
    EXPECT_EQ(digest(&kCoifSolver, set), kCoif) << coif::name_of(set);
    EXPECT_EQ(digest(&kThesisSolver, set), kThesis) << coif::name_of(set);
  }
}

}  // namespace
}  // namespace coif
