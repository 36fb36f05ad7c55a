#pragma once
// Code that the solvers of one model share: members of Solver.

#include "solver.h"

namespace coif {

/// The dynamics of a bone in a step.
struct ScaledDynamics {
  double stiffness, damping, friction;  ///< 1/s^2, 1/s, 1/s.
};

/// The asset's values times the step's factors, within kMostStiffness and kMostDamping.
inline ScaledDynamics bone_motion(const StepTerms& step, const DynamicsRecord& dynamics) {
  const auto bounded = [](float own, float factor, float most) {
    const double product = double(own) * double(factor);
    return product < double(most) ? product : double(most);
  };
  return {bounded(dynamics.stiffness, step.scale.stiffness, kMostStiffness),
          bounded(dynamics.damping, step.scale.damping, kMostDamping),
          bounded(dynamics.friction, step.scale.friction, kMostDamping)};
}

namespace cascade {
void set_coefficients(const StepTerms& step, const DynamicsRecord& dynamics, float length, const CoefficientLanes& to);
void put_to_rest(const ChainLane& chain, const Quat& head_rotation);
void turn(const ChainLane& chain, const Quat& by);
void calm(const ChainLane& chain);
bool could_be(const SavedLane& lane, std::size_t at);
}  // namespace cascade

namespace passive {
void set_coefficients(const StepTerms& step, const DynamicsRecord& dynamics, float length, const CoefficientLanes& to);
void put_to_rest(const ChainLane& chain, const Quat& head_rotation);
void turn(const ChainLane& chain, const Quat& by);
void calm(const ChainLane& chain);
bool could_be(const SavedLane& lane, std::size_t at);
}  // namespace passive

}  // namespace coif
