#include "models.h"
#include "passive_method.h"

namespace coif {
namespace {

const Solver kCascade{.state_bytes = sizeof(CoifState),
                      .coefficient_bytes = sizeof(CoifCoefficients),
                      .carries_frames = true,
                      .has_substeps = true,
                      .row_code = &character_cascade_code,
                      .set_coefficients = &cascade::set_coefficients,
                      .put_to_rest = &cascade::put_to_rest,
                      .turn = &cascade::turn,
                      .calm = &cascade::calm,
                      .tails = &tails_of_palette};

const Solver kPassive{.state_bytes = sizeof(PassiveState),
                      .coefficient_bytes = sizeof(PassiveCoefficients),
                      .scratch_bytes = kPassiveScratch,
                      .scratch_from = kPassiveBonesOnStack,
                      .has_substeps = true,
                      .row_code = &character_passive_code,
                      .set_coefficients = &passive::set_coefficients,
                      .put_to_rest = &passive::put_to_rest,
                      .turn = &passive::turn,
                      .calm = &passive::calm,
                      .tails = &tails_of_palette};

const Solver* solver_of(ChainModel model) { return model == ChainModel::kPassive ? &kPassive : &kCascade; }

}  // namespace

const Solver kCharacterSolver{.for_model = &solver_of, .character = &kCharacterCode};

}  // namespace coif
