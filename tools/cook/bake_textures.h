#pragma once

#include "cook/base_color.h"
#include "cook/left_out.h"
#include "cook/transparency.h"

#include <coif/asset_records.h>

namespace coif {

struct BakedTextures {
  std::vector<TextureRecord> records;
  std::vector<std::byte> texels;
  std::vector<Image> used;  ///< For each mip of the base colour which texels the hair shows, one channel.
  Transparency transparency;
  std::vector<std::filesystem::path> files;  ///< Image files of the recipe that were read here.
  double constant_shift = 0.5;               ///< Of all strands, where no texture says it for each: 0.5 shifts nothing.
  double constant_mask = 1;
  std::vector<LeftOut> left_out;
};

/// Base colour with alpha, and shift with mask (the recipe's, else generated), each with all mips, in the formats
/// that the recipe asks for. Alpha is averaged as it is: what it loses to the threshold is given back by
/// keep_coverage(), once the threshold is known. In an atlas shift and mask follow each surface's own coordinates. An
/// image that the recipe names and that cannot be read is an error. Shift and mask that are the same everywhere are
/// numbers instead. Without texture coordinates nothing is stored. `hair` has the coordinates that find_base_color
/// left.
tl::expected<BakedTextures, ToolError> bake_textures(const BaseColor& color, const HairMesh& hair, bool strands_along_u,
                                                     const Recipe& recipe, const CookSettings& settings);

}  // namespace coif
