#pragma once

#include "cook/cook_inputs.h"
#include "cook/left_out.h"
#include "cook/recipe.h"
#include "import/source_model.h"
#include "tool_error.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace coif {

struct CookSettings {
  unsigned threads = 1;                              ///< The result's bytes do not depend on it.
  std::filesystem::path recipe_directory;            ///< Where texture paths of the recipe start.
  std::uint64_t source_hash = 0;                     ///< XXH64 of the source file, for the provenance record.
  std::function<void(const char* pass)> progress{};  ///< Called before each pass, where set.
};

struct PassTime {
  std::string name;
  double ms = 0;
};

struct CookReport {
  std::vector<PassTime> passes;
  std::vector<std::string> warnings;
  std::uint32_t triangles = 0;
  std::uint32_t vertices = 0;
  std::uint32_t patches = 0;
  std::uint32_t patches_by_index = 0;
  std::uint32_t patches_by_position = 0;
  std::uint32_t chains = 0;
  std::uint32_t bones = 0;
  std::uint32_t simulated_bones = 0;
  std::vector<std::string> notes;  ///< What was chosen, and why.
  std::vector<LeftOut> left_out;   ///< What of the source is not in the asset, and why.
};

struct CookResult {
  std::vector<std::byte> asset;  ///< The bytes of a .coif; opens without error.
  CookReport report;
  CookInputs inputs;
};

/// Runs every pass on a source model. Pure: same model, recipe and settings give the same bytes.
tl::expected<CookResult, ToolError> cook(const SourceModel& source, const Recipe& recipe, const CookSettings& settings);

}  // namespace coif
