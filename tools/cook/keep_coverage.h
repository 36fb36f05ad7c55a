#pragma once

#include "cook/image.h"
#include "write/asset_writer.h"

namespace coif {

/// Base colour of `contents` as images, largest mip first; empty without such a texture.
[[nodiscard]] std::vector<Image> base_color_mips(const AssetContents& contents);

/// Texel alpha at which the product with the material's alpha reaches `threshold`, which is of that product; 2, which no
/// texel has, where it never does.
[[nodiscard]] double threshold_in_texture(const MaterialRecord& material, double threshold);

/// Gives the smaller mips of the base colour the coverage that the largest has at the material's opaque threshold (see
/// keep_alpha_coverage()). The last thing done to the texels: until here all mips have plainly averaged alpha, and whoever
/// chooses the threshold sees what the artist painted. `used` says for each mip which texels the hair shows; empty where
/// there is no texture.
void keep_coverage(std::span<const Image> used, AssetContents& contents);

}  // namespace coif
