#pragma once

#include "cook/recipe/patch_override.h"

#include <string>
#include <vector>

namespace coif::cook {

/// The condition for triangles to be one patch.
enum class Connectivity { kAuto, kIsland, kIndex, kPosition };

/// The recipe's values for the strips that hair consists of.
struct StripRecipe {
  bool hair_brows = false;  ///< Keeps brows and lashes that are part of the hair.
  bool hair_beard = false;
  Connectivity patch_connectivity = Connectivity::kAuto;
  double patch_widest = 0;                     ///< Metres; 0: from the head's size.
  std::vector<PatchOverride> patch_overrides;  ///< If two give a different value for a patch, the later one holds.
  std::string strand_root;                     ///< "auto", "low_u", "high_u", "low_v" or "high_v".
};

}  // namespace coif::cook
