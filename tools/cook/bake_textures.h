#pragma once

#include "cook/cook.h"
#include "cook/hair_mesh.h"

#include <coif/asset_records.h>

namespace coif {

struct BakedTextures {
  std::vector<TextureRecord> records;
  std::vector<std::byte> texels;
  std::vector<std::string> warnings;
  std::vector<std::string> left_out;
};

/// Base colour with alpha (the recipe's, else the source material's) and shift with mask (the recipe's, else generated),
/// each with all mips. A source image that is missing or broken is a warning and leaves the hair untextured; one that the
/// recipe names is an error. Without texture coordinates nothing is stored.
tl::expected<BakedTextures, ToolError> bake_textures(const SourceModel& source, const HairMesh& hair,
                                                     bool strands_along_u, const Recipe& recipe,
                                                     const CookSettings& settings);

}  // namespace coif
