#pragma once

#include "report/chain_solver.h"
#include "report/stability_report.h"
#include "report/stress_rig.h"

#include <functional>
#include <optional>
#include <vector>

namespace coif {

/// What is done to hair in one StressCase. After it the head stands still where it is, and frames are as usual, until
/// hair has had time to settle.
struct Stress {
  StressCase about;
  std::optional<StressRig> rig;  ///< Empty: the asset's own hair.
  SolverScene scene;
  std::function<HeadPose(double seconds)> head;
  /// Step lengths, repeated; seconds. Entries that are no lengths (0, negative, not a number) take no time.
  std::vector<double> dt{1.0 / 60};
  std::size_t steps = 240;
  /// For solvers that do not ship: they are up to a hundred times slower, and take fewer.
  std::optional<std::size_t> steps_of_others;
  double top_speed = 10;  ///< m/s of the fastest point of the head's path near the hair, as it is meant to be.
  bool settles = true;    ///< Hair comes to rest within the time for it.
};

/// Time steps, parameters, shapes, movements, then long runs.
[[nodiscard]] std::vector<Stress> stress_cases();

}  // namespace coif
