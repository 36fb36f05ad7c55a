#pragma once

#include "cook/dynamics/bake_dynamics.h"
#include "cook/recipe/findings.h"
#include "write/asset_writer.h"

namespace coif::cook {

/// Stiffness and damping of hair that nobody gave numbers to, from what hair is, for the passive model: of those bones
/// of `contents` (skeleton and dynamics) that a preset moves, says `said`.
///
/// Free hairs of a lock bend like one: the stiffness of hair against its weight is a length, that of hair which its own
/// weight just bends over, (E I / (rho g))^(1/3), whatever the lock's thickness; 5 cm for human hair (Goldstein, Warren
/// and Ball 2012, "Shape of a Ponytail and the Statistical Physics of Hair Fiber Bundles"), more where locks hold
/// together. So a joint between bones of the mean length l has the stiffness rho g b^3 / l against bending; hair
/// shorter than b stands and longer hair hangs, and swings as a pendulum. Each joint is damped at its share, one of
/// said.damping_ratios, of what would keep it from swinging past.
void bake_natural_dynamics(const SaidMotion& said, AssetContents& contents, Findings& findings);

}  // namespace coif::cook
