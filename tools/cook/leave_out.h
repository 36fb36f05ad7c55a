#pragma once
// What the recipe's "scene" says that nobody will look for, and what nothing in the asset would ever use.

#include "cook/left_out.h"
#include "cook/make_lods.h"
#include "cook/recipe.h"
#include "cook/settle_colliders.h"
#include "write/asset_writer.h"

#include <vector>

namespace coif {

/// Takes the parts out of `contents` that the recipe's "scene" is without: bone names, quality, provenance, shift and mask,
/// all that is drawn.
[[nodiscard]] std::vector<LeftOut> leave_out_parts(const Recipe& recipe, AssetContents& contents);

/// The head alone in place of a skeleton that moves: every vertex follows it. For a scene that does not simulate.
[[nodiscard]] std::vector<LeftOut> leave_out_motion(Skeleton rigid, Skeleton& skeleton, SkinWeights& weights);

/// Levels of detail that are too fine or too coarse for every size at which the scene shows the head. One always stays. The
/// finest that stays simulates every bone and is what errors are measured from: those of the others grow by its own at
/// most, and are given so.
[[nodiscard]] std::vector<LeftOut> leave_out_levels(const Recipe& recipe, DetailLevels& lods);

/// Colliders that are in no bone's set, where bones move at all; the sets count afresh. `colliders` has its reach settled.
[[nodiscard]] std::vector<LeftOut> leave_out_colliders(Colliders& colliders);

}  // namespace coif
