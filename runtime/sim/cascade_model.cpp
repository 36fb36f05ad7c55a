#include "models.h"
#include "saved_lane.h"
#include "vector_math.h"

namespace coif {
namespace {

CoifState* state_of(const ChainLane& chain) { return static_cast<CoifState*>(chain.state); }

/// Rewrites `step` in terms of the target's velocities u0 and u1 at both ends of the step, its way w, the bone's own
/// velocity v0, gravity g and air a, in place of load and bend (MODEL.md, "The step"). With friction c and the step h:
/// load = g s + c (a - (u0 + u1) / 2) - (u1 - u0) / h, bend = (u0 + u1) h / 2 - w + c h^2 / 12 (u1 - u0).
/// Computed in double precision, because the terms cancel.
struct Terms {
  double velocity, target_before, target_velocity, way, gravity, air;
};

Terms terms_of(double from_velocity, double from_load, double from_bend, double friction, double gravity_scale,
               double dt) {
  const double mean = 0.5 * (from_bend * dt - from_load * friction);
  const double change = from_bend * friction * dt * dt / 12 - from_load / dt;
  Terms terms;
  terms.velocity = from_velocity;
  terms.target_before = mean - change - from_velocity;
  terms.target_velocity = mean + change;
  terms.way = -from_bend;
  terms.gravity = from_load * gravity_scale;
  terms.air = from_load * friction;
  return terms;
}

}  // namespace

namespace cascade {

void set_coefficients(const StepTerms& step, const DynamicsRecord& dynamics, float length, const CoefficientLanes& to) {
  const auto [stiffness, damping, friction] = bone_motion(step, dynamics);
  const double dt = double(step.dt);
  const PoseResponse r = pose_response(stiffness, damping + friction, dt);
  const double scale = double(dynamics.gravity_scale), per_length = 1 / double(length);
  const Terms offset = terms_of(r.offset_from_velocity, r.offset_from_load, r.offset_from_bend, friction, scale, dt);
  const Terms velocity =
      terms_of(r.velocity_from_velocity, r.offset_from_velocity, r.velocity_from_bend, friction, scale, dt);
  CoifCoefficients& c = *static_cast<CoifCoefficients*>(to.coefficients);
  fill(to, c.offset_from_offset, r.offset_from_offset);
  fill(to, c.offset_from_velocity, offset.velocity * per_length);
  fill(to, c.offset_from_target_before, offset.target_before * per_length);
  fill(to, c.offset_from_target_velocity, offset.target_velocity * per_length);
  fill(to, c.offset_from_way, offset.way * per_length);
  fill(to, c.offset_from_gravity, offset.gravity * per_length);
  fill(to, c.offset_from_air, offset.air * per_length);
  fill(to, c.velocity_from_offset, r.velocity_from_offset * double(length));
  fill(to, c.velocity_from_velocity, velocity.velocity);
  fill(to, c.velocity_from_target_before, velocity.target_before);
  fill(to, c.velocity_from_target_velocity, velocity.target_velocity);
  fill(to, c.velocity_from_way, velocity.way);
  fill(to, c.velocity_from_gravity, velocity.gravity);
  fill(to, c.velocity_from_air, velocity.air);
  fill(to, c.velocity_from_constraint, r.velocity_per_offset * double(length));
}

void put_to_rest(const ChainLane& chain, const Quat& head_rotation) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    CoifState& state = state_of(chain)[i];
    const Vec3 rest = lane(chain.constants[i].rest, chain.constant_lane);
    const Vec3 direction = rotate(head_rotation, rest);
    set_lane(state.direction, chain.state_lane, direction);
    set_lane(state.arm, chain.state_lane, rotate(head_rotation, lane(chain.constants[i].pull, chain.constant_lane)));
    set_lane(state.velocity, chain.state_lane, Vec3{});
    state.spin.v[chain.state_lane] = 0.0f;
    if (chain.twist == nullptr) continue;
    set_lane(chain.twist[i].before, chain.state_lane, rest);
    chain.twist[i].cosine.v[chain.state_lane] = 1.0f;
    chain.twist[i].sine.v[chain.state_lane] = 0.0f;
  }
}

void turn(const ChainLane& chain, const Quat& by) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    CoifState& state = state_of(chain)[i];
    for (Lanes3* const vector : {&state.direction, &state.arm, &state.velocity}) {
      set_lane(*vector, chain.state_lane, rotate(by, lane(*vector, chain.state_lane)));
    }
  }
}

void calm(const ChainLane& chain) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    set_lane(state_of(chain)[i].velocity, chain.state_lane, Vec3{});
    state_of(chain)[i].spin.v[chain.state_lane] = 0.0f;
  }
}

bool could_be(const SavedLane& lane, std::size_t at) {
  return is_unit_direction(lane.vector(at + offsetof(CoifState, direction))) &&
         length(lane.vector(at + offsetof(CoifState, arm))) <= 1.0f + kSavedFrameTolerance;
}

}  // namespace cascade
}  // namespace coif
