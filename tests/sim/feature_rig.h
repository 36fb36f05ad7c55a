#pragma once
// Hair that has everything an asset can have, and a game that does everything with it: for tests of what must not matter.

#include "sim/test_rig.h"

#include <cstdint>
#include <vector>

namespace coif {

/// Chains of four shapes, one of them branching and one too frequent for a row; every shape of collider, in different
/// sets; bones with and without friction, limits, twist and a pull to the head; three levels of detail.
[[nodiscard]] TestRig feature_rig();

enum class JobOrder : std::uint8_t { kAscending, kDescending, kTwoThreads };

/// A game of `frames` frames, of different lengths and in up to three parts. Each instance's head lives its own life, which
/// depends on the instance's index alone: it wanders, stands still, is put elsewhere and reset. Made without libm, so that
/// it is the same game everywhere.
struct FeaturePlay {
  const Solver* solver = &kCoifSolver;
  InstructionSet set = InstructionSet::kBest;
  std::uint32_t instances = 1;
  int frames = 80;
  float sleep_after = 0.1f;
  bool changes_detail = false;  ///< Levels, intervals, out of sight and back.
  bool descending_heads = false;
  JobOrder jobs = JobOrder::kAscending;
};

/// For each instance a hash of all of its matrices and bone ends of all frames.
[[nodiscard]] std::vector<std::uint64_t> digests(const FeaturePlay& play);

}  // namespace coif
