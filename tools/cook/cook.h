#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/recipe.h"
#include "cook/stages/cook_log.h"
#include "cook/strands/choose_patches.h"
#include "cook/texture/source_images.h"
#include "import/source_model.h"

#include <nlohmann/json_fwd.hpp>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
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

// What a cook gave, as bytes: on its way from a child process, and in a cache. The documents go into MessagePack, whose
// texts may hold any bytes, as names in artists' files do.

[[nodiscard]] nlohmann::json report_document(const CookReport& report);
/// Throws a std::exception where the document has another shape.
[[nodiscard]] CookReport report_from(const nlohmann::json& document);

[[nodiscard]] nlohmann::json questions_document(const std::vector<TextureQuestion>& questions);
/// Throws a std::exception where the document has another shape.
[[nodiscard]] std::vector<TextureQuestion> questions_from(const nlohmann::json& document);

/// All of a result, for another process of this program.
[[nodiscard]] std::vector<std::uint8_t> encode_result(const CookResult& result);
/// What encode_result() made. Throws a std::exception for any other bytes.
[[nodiscard]] CookResult decode_result(std::span<const std::uint8_t> bytes);

}  // namespace coif::cook
