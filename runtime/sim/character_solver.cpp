#include "models.h"
#include "passive_method.h"

namespace coif {
namespace {

const Solver kPassive{.state_bytes = sizeof(PassiveState),
                      .velocity_at = offsetof(PassiveState, velocity),
                      .coefficient_bytes = sizeof(PassiveCoefficients),
                      .scratch_bytes = kCharacterScratch,
                      .scratch_from = kPassiveBonesOnStack,
                      .has_substeps = true,
                      .character = &kCharacterCode,
                      .row_code = &character_passive_code,
                      .complete_lane = &find_carried,
                      .set_coefficients = &passive::set_coefficients,
                      .put_to_rest = &passive::put_to_rest,
                      .turn = &passive::turn,
                      .calm = &passive::calm,
                      .could_be = &passive::could_be,
                      .tails = &tails_of_palette};

const Solver* solver_of(ChainModel model) {
  return model == ChainModel::kPassive ? &kPassive : &kCharacterCascadeSolver;
}

}  // namespace

const Solver kCharacterSolver{.for_model = &solver_of, .character = &kCharacterCode};

}  // namespace coif
