#pragma once

#include "lab/reference_solver.h"
#include "motion/head_path.h"

#include <functional>

namespace coif::lab {

/// `rig` with its tips found, as rig_of() does for an asset. All bones count as one chain.
[[nodiscard]] Rig with_tips(Rig rig);

/// Every bone may touch `collider`.
[[nodiscard]] Rig touching(Rig rig, const ColliderRecord& collider);

/// Times every 1/rate seconds, from 0.
[[nodiscard]] std::vector<double> evenly(double rate, double seconds);

/// One pair of runs: with steps of 1/rate and of half of that.
[[nodiscard]] ReferenceRun solve_at(const Rig& rig, const SolverScene& scene, const motion::HeadPath& path,
                                    double seconds, double rate);

/// As good as the reference gets.
[[nodiscard]] ReferenceRun solve_well(const Rig& rig, const SolverScene& scene, const motion::HeadPath& path,
                                      double seconds);

/// Another path, changed state by state.
class ChangedPath final : public motion::HeadPath {
 public:
  using Change = std::function<motion::HeadState(const motion::HeadState&)>;
  ChangedPath(motion::Motion motion, Change change) : path_(motion::path_of(motion)), change_(std::move(change)) {}

  [[nodiscard]] motion::HeadState at(double seconds, double inside) const override {
    return change_(path_->at(seconds, inside));
  }
  [[nodiscard]] std::vector<motion::PathBreak> breaks(double until) const override { return path_->breaks(until); }

 private:
  std::unique_ptr<motion::HeadPath> path_;
  Change change_;
};

/// In a mirror across x = 0.
[[nodiscard]] motion::HeadState mirrored(const motion::HeadState& state);
/// In a world that is turned.
[[nodiscard]] motion::HeadState turned(const motion::HeadState& state, const Eigen::Quaterniond& turn);

/// Largest distance of equal places, metres; NaN where one is, infinity where the counts differ.
[[nodiscard]] double worst_apart(const ReferenceRun& a, const ReferenceRun& b);

}  // namespace coif::lab
