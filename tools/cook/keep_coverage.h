#pragma once

#include "cook/image.h"
#include "write/asset_writer.h"

#include <string>

namespace coif {

/// Base colour of `contents` as images, largest mip first; empty without such a texture.
[[nodiscard]] std::vector<Image> base_color_mips(const AssetContents& contents);

struct KeptCoverage {
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// Gives the smaller mips of the base colour the coverage that the largest has at the material's thresholds (see
/// keep_alpha_coverage()). The last thing done to the texels: until here all mips have plainly averaged alpha, and
/// whoever chooses the threshold sees what the artist painted. `used` says for each mip which texels the hair shows;
/// empty where there is no texture. Tells how near the mips came, and warns where hair will look thinner or fuller
/// from afar.
KeptCoverage keep_coverage(std::span<const Image> used, AssetContents& contents);

}  // namespace coif
