#pragma once

#include "base/hair_runtime.h"

#include <coif/hair.h>
#include <coif/math.h>

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace coif::lab {

/// What acts on the hair besides the head. Defaults are the runtime's (coif/hair.h).
struct SolverScene {
  Eigen::Vector3d gravity{0, -9.81, 0};            ///< World, m/s^2.
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();  ///< World, m/s.
  std::uint32_t moving_colliders = 0;  ///< Most that will be given at once; above 0 of kCharacterSolver alone.
  bool follows_body = false;           ///< set_body() will be called; of kCharacterSolver alone.
};

/// A way to move the bones of one head: the runtime's solvers, the reference, and what others do, behind one interface
/// so that the same measurement runs over all of them.
class ChainSolver {
 public:
  ChainSolver() = default;
  ChainSolver(const ChainSolver&) = delete;
  ChainSolver& operator=(const ChainSolver&) = delete;
  virtual ~ChainSolver() = default;

  /// The rest pose under this head, at rest.
  virtual void reset(const HeadPose& head) = 0;

  /// What the hair has to keep out of besides what it knows, at the end of the coming step; see Hair::set_colliders().
  /// False where the solver refuses them, as most refuse any, and keeps those that it had.
  [[nodiscard]] virtual bool set_colliders(std::span<const MovingCollider> colliders) { return colliders.empty(); }

  /// Where the asset's body is at the end of the coming step, as Hair::set_body(), before the head's pose is told.
  /// False where the solver refuses it, as all do that follow none.
  [[nodiscard]] virtual bool set_body(std::span<const BodyPose> bones) { return bones.empty(); }

  /// Moves the head to `head` within `dt` seconds. False where the solver refuses the input and keeps its state.
  [[nodiscard]] virtual bool step(const HeadPose& head, double dt) = 0;

  /// The same where the host also knows how fast the head arrives; most solvers have no use for it.
  [[nodiscard]] virtual bool step_told(const HeadPose& head, const HeadVelocity& /*velocity*/, double dt) {
    return step(head, dt);
  }

  /// Tails of the simulated bones, head space, metres; the order of Rig::bones. May hold NaN after a step that
  /// exploded.
  [[nodiscard]] virtual std::span<const Eigen::Vector3d> bone_ends() const = 0;
};

/// What a game runs: one head with the asset's hair, bone matrices included. Single precision.
class RuntimeSolver final : public ChainSolver {
 public:
  /// `asset` is open and must outlive the solver. `effort`: sub-steps of kCoifSolver, 0 for as many as the asset asks
  /// for; iterations of kThesisSolver.
  RuntimeSolver(const Asset& asset, const SolverScene& scene, const Solver& solver, int effort);

  void reset(const HeadPose& head) override;
  [[nodiscard]] bool set_colliders(std::span<const MovingCollider> colliders) override;
  [[nodiscard]] bool set_body(std::span<const BodyPose> bones) override;
  [[nodiscard]] bool step(const HeadPose& head, double dt) override;
  [[nodiscard]] bool step_told(const HeadPose& head, const HeadVelocity& velocity, double dt) override;
  [[nodiscard]] std::span<const Eigen::Vector3d> bone_ends() const override;
  /// Of all the asset's bones, as Hair::palette().
  [[nodiscard]] std::span<const Mat34> palette() const { return hair_.palette(0); }

 private:
  HairMemory memory_{nullptr, &std::free};
  Hair hair_;
  StepSettings settings_;
  std::uint32_t rigid_count_;
  bool has_colliders_ = false;
  mutable std::vector<Vec3> all_ends_;
  mutable std::vector<Eigen::Vector3d> ends_;
};

}  // namespace coif::lab
