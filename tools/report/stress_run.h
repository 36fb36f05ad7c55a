#pragma once

#include "report/measured_solvers.h"
#include "report/stress_cases.h"

namespace coif {

/// A rig under stress, and where it would come to rest: made once for all solvers.
class StressSubject {
 public:
  StressSubject(const Stress& stress, const Asset& asset, RigSample sample);

  /// Runs one solver, with the least effort that it is measured with, through the case, from its rest pose. What the outcomes mean:
  /// - nan: a bone's end was not finite after some step.
  /// - diverged: a bone's end was further from the bone's start than ten of its lengths; or faster, ten steps in a row,
  ///   than a hundred times what gravity, the head and the pull to the pose can make it; or a step that was refused
  ///   moved a bone.
  /// - rejected: none of that, and at least one step was refused with everything kept as it was.
  /// - ok: none of that.
  /// Figures are the worst up to the end, or to the step that decided. Settling is looked at where hair is free of the
  /// head and comes to rest in 8 s.
  [[nodiscard]] StabilityRow run(const MeasuredSolver& solver) const;

 private:
  const Stress& stress_;
  const Asset& asset_;
  RigSample sample_;
  double top_speed_;  ///< m/s in head space.
};

}  // namespace coif
