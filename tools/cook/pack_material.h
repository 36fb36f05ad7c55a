#pragma once

#include "cook/bake_textures.h"
#include "cook/hair_mesh.h"
#include "cook/recipe.h"

#include <coif/asset_records.h>

namespace coif {

/// The recipe's material; its base colour times `color`'s factor, thresholds as chosen, highlights with the shift and mask
/// that all strands have in common.
[[nodiscard]] MaterialRecord pack_material(const BaseColor& color, const BakedTextures& textures, const HairMesh& hair,
                                           const Recipe& recipe);

}  // namespace coif
