#pragma once

#include "base/tool_error.h"
#include "cook/order/order_figures.h"
#include "cook/recipe/findings.h"
#include "cook/recipe/recipe.h"
#include "cook/strands/choose_patches.h"
#include "cook/texture/source_images.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace coif {

/// What a cook's result depends on beside the source's and the recipe's own bytes.
struct CookInputs {
  std::vector<std::filesystem::path>
      source_files;  ///< What the source names, side files and images; some may be absent.
  std::vector<std::filesystem::path> recipe_files;  ///< What the recipe names, found from the recipe's folder.
  std::vector<TextureQuestion> questions;           ///< To the TextureFolder of the source.
  /// Images that the source names for any use, read or not (named_image_files()). No result depends on those that were not read, but
  /// none of them may be written over.
  std::vector<std::filesystem::path> named_files;
};

struct PassTime {
  std::string name;  ///< Each once.
  double ms = 0;
};

/// What the passes found, and figures of what they made.
struct CookReport : Findings {
  std::vector<PassTime> passes;
  std::uint32_t triangles = 0;
  std::uint32_t vertices = 0;
  std::uint32_t patches = 0;
  std::uint32_t patches_by_index = 0;
  std::uint32_t patches_by_position = 0;
  std::uint32_t chains = 0;
  std::uint32_t bones = 0;
  std::uint32_t simulated_bones = 0;
  OrderFigures order;
};

/// The patches as people know them: by numbers that do not depend on what else is said in the recipe.
struct ListedPatches {
  std::vector<PatchListing> patches;           ///< By number.
  std::vector<std::uint32_t> number_of_place;  ///< For each PatchRecord::file_place of the asset.
};

struct CookResult {
  std::vector<std::byte> asset;  ///< The bytes of a .coif; opens without error.
  CookReport report;
  CookInputs inputs;
  ListedPatches patches;  ///< Empty unless asked for.
};

/// Runs every pass on a source model. Pure: same model, recipe and settings give the same bytes.
tl::expected<CookResult, ToolError> cook(const SourceModel& source, const Recipe& recipe, const CookSettings& settings);

}  // namespace coif
