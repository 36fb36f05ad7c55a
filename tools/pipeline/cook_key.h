#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

namespace coif {

/// All that is known before the import and changes what a cook makes.
struct CookIdentity {
  std::string tool;      ///< The cooker: its version, and whatever tells two builds of one version apart.
  std::string importer;  ///< importer_name().
  std::filesystem::path source;
  std::span<const std::byte> source_bytes;
  std::string recipe;  ///< print_recipe(): how a recipe is written, and its comments, change nothing.
};

/// 32 hexadecimal digits, from two XXH64 with different seeds: proof against accidents, not against forgers. Of the
/// source's path the file's name counts alone (its suffix chooses the reader, its stem helps to find textures), so checkouts
/// in different folders share a cache.
[[nodiscard]] std::string cook_key(const CookIdentity& identity);

/// The same digits for any bytes.
[[nodiscard]] std::string content_digits(std::span<const std::byte> bytes);

}  // namespace coif
