#pragma once

#include "cook/dynamics/bake_dynamics.h"
#include "cook/rig/skeleton.h"
#include "cook/strands/hair_strips.h"

#include <span>
#include <vector>

namespace coif::cook {

struct RigRecipe;

/// For each chain of the rig, whether its hair is tied: a pony tail, a pigtail or a braid, which hangs free as one
/// round bundle. Loose hair hangs in sheets, or beside other locks.
///
/// A chain is tied where it is at least 15 cm long, its hair is no wider than 0.6 of that and at least 0.45 times as
/// thick as wide (both: two standard deviations across the bones, by area), and no other chain of at least half its
/// length hangs nearer beside its lower half than a quarter of both their widths from surface to surface.
[[nodiscard]] std::vector<bool> find_tied_chains(const HairStrips& hair, const HairRig& rig);

/// Lets the bones of tied chains that a preset moves swing as tied hair does, where neither the recipe nor `of_chain`
/// (empty, or one for each chain) says a friction or a damping of their own. Notes which chains are tied.
void loosen_tied_chains(const Skeleton& skeleton, const std::vector<bool>& tied, const RigRecipe& recipe,
                        std::span<const PatchOverride> of_chain, SaidMotion& motion, Findings& findings);

}  // namespace coif::cook
