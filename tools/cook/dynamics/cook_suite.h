#pragma once

#include "motion/head_path.h"

namespace coif {

/// The motions that a cook runs to judge an asset: how many sub-steps it wants, and where frames need a twist. An asset stores their names,
/// so that this list may change without those that users choose from (all_motions()). `jog` is not one of them: it pumps hair from a
/// small sway to a large one, which takes longer than a cook looks.
inline constexpr Motion kCookSuite[] = {Motion::kStill, Motion::kNod,    Motion::kTurn,     Motion::kCharge, Motion::kRun,
                                        Motion::kJump,  Motion::kTumble, Motion::kTeleport, Motion::kBow,    Motion::kLie};

}  // namespace coif
