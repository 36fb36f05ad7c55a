#include "models.h"
#include "passive_method.h"

namespace coif {

const Solver kPassiveSolver{.state_bytes = sizeof(PassiveState),
                            .velocity_at = offsetof(PassiveState, velocity),
                            .coefficient_bytes = sizeof(PassiveCoefficients),
                            .scratch_bytes = kPassiveScratch,
                            .scratch_from = kPassiveBonesOnStack,
                            .carries_frames = false,
                            .has_substeps = true,
                            .may_be_uneven = true,
                            .row_code = &passive_row_code,
                            .complete_lane = &find_carried,
                            .set_coefficients = &passive::set_coefficients,
                            .put_to_rest = &passive::put_to_rest,
                            .turn = &passive::turn,
                            .calm = &passive::calm,
                            .could_be = &passive::could_be,
                            .tails = &tails_of_palette};

}  // namespace coif
