#pragma once

#include "hair_memory.h"
#include "report/chain_solver.h"

#include <coif/hair.h>

#include <cstddef>
#include <vector>

namespace coif {

/// What a game runs: one head with the asset's hair, bone matrices included. Single precision.
class RuntimeSolver final : public ChainSolver {
 public:
  /// `asset` is open and must outlive the solver. `effort`: sub-steps of kCoifSolver, 0 for as many as the asset asks
  /// for; iterations of kThesisSolver.
  RuntimeSolver(const Asset& asset, const SolverScene& scene, const Solver& solver, int effort);

  void reset(const HeadPose& head) override;
  [[nodiscard]] bool step(const HeadPose& head, double dt) override;
  [[nodiscard]] std::span<const Eigen::Vector3d> bone_ends() const override;
  /// Of all the asset's bones, as Hair::palette().
  [[nodiscard]] std::span<const Mat34> palette() const { return hair_.palette(0); }

 private:
  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  StepSettings settings_;
  std::uint32_t rigid_count_;
  mutable std::vector<Vec3> all_ends_;
  mutable std::vector<Eigen::Vector3d> ends_;
};

}  // namespace coif
