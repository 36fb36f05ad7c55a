#pragma once

#include <coif/asset.h>

namespace coif::fuzz {

/// Some frames of a game: a few heads that move, turn, jump and change their level of detail, stepped by both solvers and
/// skinned. Ends the process where a number is not finite or the memory asked for does not suit the asset.
void play_asset(const Asset& asset);

}  // namespace coif::fuzz
