#include "models.h"

namespace coif {

const Solver kCascadeSolver{.state_bytes = sizeof(CoifState),
                            .velocity_at = offsetof(CoifState, velocity),
                            .coefficient_bytes = sizeof(CoifCoefficients),
                            .scratch_bytes = 0,
                            .scratch_from = 0,
                            .carries_frames = true,
                            .has_substeps = true,
                            .may_be_uneven = true,
                            .row_code = &coif_row_code,
                            .set_coefficients = &cascade::set_coefficients,
                            .put_to_rest = &cascade::put_to_rest,
                            .turn = &cascade::turn,
                            .calm = &cascade::calm,
                            .could_be = &cascade::could_be,
                            .tails = &tails_of_palette};

}  // namespace coif
