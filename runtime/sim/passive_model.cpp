#include "models.h"
#include "passive_method.h"
#include "saved_lane.h"
#include "vector_math.h"

namespace coif {
namespace {

PassiveState* state_of(const ChainLane& chain) { return static_cast<PassiveState*>(chain.state); }

}  // namespace

namespace passive {

void set_coefficients(const StepTerms& step, const DynamicsRecord& dynamics, float, const CoefficientLanes& to) {
  const auto [stiffness, damping, friction] = bone_motion(step, dynamics);
  const double dt = double(step.dt);
  const PassiveMethod method(dt);
  PassiveCoefficients& c = *static_cast<PassiveCoefficients*>(to.coefficients);
  fill(to, c.stiffness, stiffness);
  fill(to, c.damping, damping);
  fill(to, c.friction, friction);
  fill(to, c.gravity_scale, double(dynamics.gravity_scale));
  fill(to, c.reach, 0.5 * dt * dt / (1 + stiffness * dt * dt));
  fill(to, c.firm, stiffness + damping * method.velocity_per_way);
  fill(to, c.inertia, method.acceleration_per_way + friction * method.velocity_per_way);
}

void put_to_rest(const ChainLane& chain, const Quat& head_rotation) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    PassiveState& state = state_of(chain)[i];
    const std::uint32_t at = chain.state_lane;
    set_lane(state.direction, at, rotate(head_rotation, lane(chain.constants[i].rest, chain.constant_lane)));
    for (Lanes3* const vector : {&state.velocity, &state.acceleration, &state.lagged}) set_lane(*vector, at, Vec3{});
    state.tension.v[at] = state.contact.v[at] = 0.0f;
    state.bent.v[at] = kNotBent;
  }
}

void turn(const ChainLane& chain, const Quat& by) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    PassiveState& state = state_of(chain)[i];
    for (Lanes3* const vector : {&state.direction, &state.velocity, &state.acceleration, &state.lagged}) {
      set_lane(*vector, chain.state_lane, rotate(by, lane(*vector, chain.state_lane)));
    }
  }
}

void calm(const ChainLane& chain) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    PassiveState& state = state_of(chain)[i];
    for (Lanes3* const vector : {&state.velocity, &state.acceleration, &state.lagged}) {
      set_lane(*vector, chain.state_lane, Vec3{});
    }
  }
}

bool could_be(const SavedLane& lane, std::size_t at) {
  const float bent = lane.number(at + offsetof(PassiveState, bent));
  const float contact = lane.number(at + offsetof(PassiveState, contact));
  return is_unit_direction(lane.vector(at + offsetof(PassiveState, direction))) &&
         lane.number(at + offsetof(PassiveState, tension)) >= 0.0f && (bent >= 0.0f || bent == kNotBent) &&
         (contact == 0.0f || contact == 1.0f || contact == 2.0f || contact == 3.0f);
}

}  // namespace passive
}  // namespace coif
