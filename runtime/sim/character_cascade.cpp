#include "models.h"

namespace coif {

const Solver kCharacterCascadeSolver{.state_bytes = sizeof(CoifState),
                                     .velocity_at = offsetof(CoifState, velocity),
                                     .coefficient_bytes = sizeof(CoifCoefficients),
                                     .carries_frames = true,
                                     .has_substeps = true,
                                     .character = &kCharacterCode,
                                     .row_code = &character_cascade_code,
                                     .set_coefficients = &cascade::set_coefficients,
                                     .put_to_rest = &cascade::put_to_rest,
                                     .turn = &cascade::turn,
                                     .calm = &cascade::calm,
                                     .could_be = &cascade::could_be,
                                     .tails = &tails_of_palette};

}  // namespace coif
