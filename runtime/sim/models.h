#pragma once
// What the solvers of one model have in common, whatever else they know: see Solver, whose members these are.

#include "solver.h"

namespace coif {

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
