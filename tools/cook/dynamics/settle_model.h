#pragma once

#include "cook/dynamics/bake_dynamics.h"
#include "cook/recipe/findings.h"
#include "write/asset_writer.h"

#include <span>

namespace coif::cook {

struct RigRecipe;

/// Completes the dynamics of `contents`, which holds a skeleton and `said.records` with hit radii, in these models, one
/// for each chain: bones that nobody gave numbers to get those of the preset, and all but those that a spring moves
/// keep the shape that was modelled, unless "dynamics.sags".
void settle_model(const RigRecipe& recipe, const SaidMotion& said, std::span<const ChainModel> models,
                  AssetContents& contents, Findings& findings);

}  // namespace coif::cook
