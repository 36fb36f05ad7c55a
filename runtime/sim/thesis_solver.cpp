#include "solver.h"
#include "vector_math.h"

namespace coif {
namespace {

ThesisState* state_of(const ChainLane& chain) { return static_cast<ThesisState*>(chain.state); }

/// exp(-friction dt) in place of Algorithm 1's 1 - friction * dt, which turns negative at large steps.
void set_coefficients(const StepTerms& step, const DynamicsRecord& dynamics, float, const CoefficientLanes& to) {
  ThesisCoefficients& c = *static_cast<ThesisCoefficients*>(to.coefficients);
  const float kept = float(plain::exp(-double(dynamics.friction) * double(step.dt)));
  for (std::uint32_t i = to.begin; i < to.end; ++i) {
    c.kept_velocity.v[i] = kept;
    c.fall.v[i] = dynamics.gravity_scale * step.dt;
  }
}

void put_to_rest(const ChainLane& chain, const Quat& head_rotation) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    const BoneLanes& bone = chain.constants[i];
    const std::int32_t parent = chain.bones[i].parent;
    // A child starts at its parent's particle, wherever its own stored joint is, so lengths hold from the first step.
    const Vec3 start = parent < 0 ? rotate(head_rotation, lane(bone.joint, chain.constant_lane))
                                  : lane(state_of(chain)[parent].position, chain.state_lane);
    const Vec3 rest = lane(bone.rest, chain.constant_lane) * bone.length.v[chain.constant_lane];
    set_lane(state_of(chain)[i].position, chain.state_lane, start + rotate(head_rotation, rest));
    set_lane(state_of(chain)[i].velocity, chain.state_lane, Vec3{});
  }
}

void turn(const ChainLane& chain, const Quat& by) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    ThesisState& state = state_of(chain)[i];
    for (Lanes3* const vector : {&state.position, &state.velocity}) {
      set_lane(*vector, chain.state_lane, rotate(by, lane(*vector, chain.state_lane)));
    }
  }
}

void calm(const ChainLane& chain) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    set_lane(state_of(chain)[i].velocity, chain.state_lane, Vec3{});
  }
}

/// Particles may have any place and any velocity.
bool could_be(const SavedLane&, std::size_t) { return true; }

void tails(const ChainLane& chain, const Quat& head_rotation, std::span<const Mat34>, std::span<Vec3> ends) {
  for (std::size_t i = 0; i < chain.bones.size(); ++i) {
    ends[i] = rotate(conjugate(head_rotation), lane(state_of(chain)[i].position, chain.state_lane));
  }
}

}  // namespace

const Solver kThesisSolver{.state_bytes = sizeof(ThesisState),
                           .keeps_places = true,
                           .velocity_at = offsetof(ThesisState, velocity),
                           .coefficient_bytes = sizeof(ThesisCoefficients),
                           .scratch_bytes = 0,
                           .scratch_from = 0,
                           .carries_frames = false,
                           .has_substeps = false,
                           .reads_asked = true,
                           .row_code = &thesis_row_code,
                           .set_coefficients = &set_coefficients,
                           .put_to_rest = &put_to_rest,
                           .turn = &turn,
                           .calm = &calm,
                           .could_be = &could_be,
                           .tails = &tails};

}  // namespace coif
