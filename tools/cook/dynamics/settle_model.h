#pragma once

#include "cook/dynamics/bake_dynamics.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe.h"
#include "write/asset_writer.h"

#include <span>
#include <vector>

namespace coif {

/// Chooses the model that moves the hair, as "dynamics.model" says or for what has a preset the passive one, and gives bones that
/// nobody gave numbers to those of the preset; all but those that a spring moves keep the shape that was modelled, unless
/// "dynamics.sags". `sources` and `damping_ratios`: one for each bone of `contents`, which holds skeleton and dynamics.
void settle_model(const Recipe& recipe, const std::vector<MotionSource>& sources,
                  std::span<const double> damping_ratios, AssetContents& contents, Findings& findings);

}  // namespace coif
