#pragma once

#include "cook/recipe/patch_override.h"

#include <string>
#include <vector>

namespace coif::cook {

/// What makes triangles one patch.
enum class Connectivity { kAuto, kIsland, kIndex, kPosition };

/// What a recipe says of the strips that hair consists of.
struct StripRecipe {
  bool hair_brows = false;  ///< Brows and lashes stay, as far as they are part of the hair.
  bool hair_beard = false;
  Connectivity patch_connectivity = Connectivity::kAuto;
  double patch_widest = 0;                     ///< Metres; 0: from the head's size.
  std::vector<PatchOverride> patch_overrides;  ///< Where two say different things of a patch, the later one holds.
  std::string strand_root;                     ///< "auto", "low_u", "high_u", "low_v" or "high_v".
};

}  // namespace coif::cook
