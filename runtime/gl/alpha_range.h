#pragma once

#include <coif/asset.h>

namespace coif {

/// Between which values an asset's alpha lies, 0..1, before the material's base colour.
struct AlphaRange {
  float lowest = 1;
  float highest = 1;
};

/// Over all mips of the base texture: what lies between texels, and between mips, lies between their values too. Both 1
/// without that texture. Linear in the texels, ended early where all values occur, as they do in most strand textures.
[[nodiscard]] AlphaRange alpha_range_of(const Asset& asset);

}  // namespace coif
