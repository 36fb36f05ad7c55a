#pragma once

#include "platform/stop.h"

#include <cstdint>
#include <filesystem>
#include <functional>

namespace coif::cook {

/// The caller's settings of a cook, besides the recipe.
struct CookSettings {
  platform::Threads threads = 1;                     ///< The result's bytes do not depend on it.
  std::filesystem::path recipe_directory{};          ///< The recipe's texture paths are relative to it.
  std::uint64_t source_hash = 0;                     ///< XXH64 of the source file, for the provenance record.
  std::function<void(const char* pass)> progress{};  ///< Called before each pass, where set.
  bool list_patches = false;                         ///< Fill in CookResult::patches.
  bool draft = false;                                ///< Cook draft_of() the recipe, without the slow passes.
};

}  // namespace coif::cook
