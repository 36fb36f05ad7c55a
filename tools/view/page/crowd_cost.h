#pragma once

#include <coif/asset.h>
#include <coif/hair.h>

namespace coif::view {

/// Nanoseconds that a sub-step of one simulated bone takes in this browser, in a crowd of heads that shake: what a game
/// would pay, where all lanes are full. Takes some milliseconds; 0 where nothing is simulated.
[[nodiscard]] double crowd_cost(const Asset& asset, const Solver& solver);

}  // namespace coif::view
