#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/recipe.h"
#include "cook/stages/cook_log.h"
#include "cook/strands/choose_patches.h"
#include "cook/texture/source_images.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace coif::cook {

/// What a cook's result depends on beside the source's and the recipe's own bytes.
struct CookInputs {
  std::vector<std::filesystem::path>
      source_files;  ///< What the source names, side files and images; some may be absent.
  std::vector<std::filesystem::path> recipe_files;  ///< What the recipe names, found from the recipe's folder.
  std::vector<TextureQuestion> questions;           ///< To the TextureFolder of the source.
  /// Images that the source names for any use, read or not (named_image_files()). No result depends on those that were
  /// not read, but none of them may be written over.
  std::vector<std::filesystem::path> named_files;
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

/// Runs the five stages on a source model (cook/stages). Pure: same model, recipe and settings give the same bytes.
/// Throws Stopped, and nothing else, where settings.threads.stop is requested.
tl::expected<CookResult, ToolError> cook(const importer::SourceModel& source, const Recipe& recipe,
                                         const CookSettings& settings);

}  // namespace coif::cook
