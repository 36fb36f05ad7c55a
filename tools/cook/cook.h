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

/// The inputs of a cook besides the source's and the recipe's own bytes.
struct CookInputs {
  /// Side files and images that the source names; some may be absent.
  std::vector<std::filesystem::path> source_files;
  std::vector<std::filesystem::path> recipe_files;  ///< Files that the recipe names, found from its folder.
  std::vector<TextureQuestion> questions;           ///< Questions to the source's TextureFolder.
  /// Images that the source names for any use, read or not (named_image_files()). The result does not depend on unread
  /// ones, but no output may overwrite any of them.
  std::vector<std::filesystem::path> named_files;
};

/// The patches by numbers for people, which do not depend on other values of the recipe.
struct ListedPatches {
  std::vector<PatchListing> patches;           ///< By number.
  std::vector<std::uint32_t> number_of_place;  ///< For each PatchRecord::file_place of the asset.
};

struct CookResult {
  std::vector<std::byte> asset;  ///< The bytes of a .coif; opens without error.
  CookReport report;
  CookInputs inputs;
  ListedPatches patches;  ///< Empty unless requested.
};

/// Runs the five stages on a source model (cook/stages). Pure: same model, recipe and settings give the same bytes.
/// Throws Stopped, and nothing else, where settings.threads.stop is requested.
tl::expected<CookResult, ToolError> cook(const importer::SourceModel& source, const Recipe& recipe,
                                         const CookSettings& settings);

// A cook's result as bytes: on its way from a child process, and in a cache. The documents are stored as MessagePack,
// whose texts may hold any bytes, as names in artists' files do.

[[nodiscard]] nlohmann::json report_document(const CookReport& report);
/// Throws a std::exception where the document has another shape.
[[nodiscard]] CookReport report_from(const nlohmann::json& document);

[[nodiscard]] nlohmann::json questions_document(const std::vector<TextureQuestion>& questions);
/// Throws a std::exception where the document has another shape.
[[nodiscard]] std::vector<TextureQuestion> questions_from(const nlohmann::json& document);

/// Encodes a whole result, for another process of this program.
[[nodiscard]] std::vector<std::uint8_t> encode_result(const CookResult& result);
/// Decodes the bytes of encode_result(). Throws a std::exception for any other bytes.
[[nodiscard]] CookResult decode_result(std::span<const std::uint8_t> bytes);

}  // namespace coif::cook
