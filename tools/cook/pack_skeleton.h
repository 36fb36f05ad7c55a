#pragma once

#include "cook/bake_textures.h"
#include "cook/recipe.h"
#include "cook/settle_colliders.h"
#include "cook/skeleton.h"
#include "write/asset_writer.h"

namespace coif {

/// Writes skeleton, bones, names, chains and colliders of `contents`, in head space. Rest directions are in the parent's
/// frame, which at rest has the axes of the model.
void pack_skeleton(const Skeleton& skeleton, const Colliders& colliders, AssetContents& contents);

/// The recipe's material; its base colour times `color`'s factor, thresholds as chosen, highlights with the shift and mask
/// that all strands have in common.
[[nodiscard]] MaterialRecord pack_material(const BaseColor& color, const BakedTextures& textures, const HairMesh& hair,
                                           const Recipe& recipe);

}  // namespace coif
