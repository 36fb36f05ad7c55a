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

/// The environment of the hair besides the head. Defaults are the runtime's (coif/hair.h).
struct SolverScene {
  Eigen::Vector3d gravity{0, -9.81, 0};            ///< World, m/s^2.
  Eigen::Vector3d wind = Eigen::Vector3d::Zero();  ///< World, m/s.
  std::uint32_t moving_colliders = 0;  ///< Most that will be set at once; above 0 only with kCharacterSolver.
  bool follows_body = false;           ///< set_body() will be called; only with kCharacterSolver.
};

/// A way to move the bones of one head: the runtime's solvers, the reference, and other methods, behind one interface
/// so that the same measurement runs over all of them.
class ChainSolver {
 public:
  ChainSolver() = default;
  ChainSolver(const ChainSolver&) = delete;
  ChainSolver& operator=(const ChainSolver&) = delete;
  virtual ~ChainSolver() = default;

  /// The rest pose under this head, at rest.
  virtual void reset(const HeadPose& head) = 0;

  /// Sets further colliders at the end of the coming step; see Hair::set_colliders(). False where the solver refuses
  /// them, as most refuse any; then it keeps those that it had.
  [[nodiscard]] virtual bool set_colliders(std::span<const MovingCollider> colliders) { return colliders.empty(); }

  /// Sets the asset's body at the end of the coming step, as Hair::set_body(), before the head's pose. False where the
  /// solver refuses it, as all do that follow no body.
  [[nodiscard]] virtual bool set_body(std::span<const BodyPose> bones) { return bones.empty(); }

  /// Moves the head to `head` within `dt` seconds. False where the solver refuses the input and keeps its state.
  [[nodiscard]] virtual bool step(const HeadPose& head, double dt) = 0;

  /// As step(), where the host also knows the head's velocity at the end; most solvers ignore it.
  [[nodiscard]] virtual bool step_told(const HeadPose& head, const HeadVelocity& /*velocity*/, double dt) {
    return step(head, dt);
  }

  /// Tails of the simulated bones, head space, metres; the order of Rig::bones. May hold NaN after a step that
  /// exploded.
  [[nodiscard]] virtual std::span<const Eigen::Vector3d> bone_ends() const = 0;
};

/// The runtime of a game: one head with the asset's hair, bone matrices included. Single precision.
class RuntimeSolver final : public ChainSolver {
 public:
  /// `asset` must be open and outlive the solver. `effort`: sub-steps of kCoifSolver, 0 for as many as the asset asks
  /// for; iterations of kThesisSolver.
  RuntimeSolver(const Asset& asset, const SolverScene& scene, const Solver& solver, int effort);

  void reset(const HeadPose& head) override;
  [[nodiscard]] bool set_colliders(std::span<const MovingCollider> colliders) override;
  [[nodiscard]] bool set_body(std::span<const BodyPose> bones) override;
  [[nodiscard]] bool step(const HeadPose& head, double dt) override;
  [[nodiscard]] bool step_told(const HeadPose& head, const HeadVelocity& velocity, double dt) override;
  [[nodiscard]] std::span<const Eigen::Vector3d> bone_ends() const override;
  /// One matrix per bone of the asset, as Hair::palette().
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
