#pragma once

#include "cook/cook_inputs.h"

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace coif {

/// Where a cook stands on this machine. What depends on it is kept relative to it.
struct CookPlace {
  std::filesystem::path source;            ///< The source file.
  std::filesystem::path recipe_directory;  ///< CookSettings::recipe_directory.

  [[nodiscard]] std::filesystem::path source_directory() const;
};

/// A file that a result depends on, and what it held.
struct Dependency {
  enum class Base { kSource, kRecipe } base = Base::kSource;
  std::string path;                   ///< From the base's folder; absolute where it lies elsewhere.
  std::optional<std::uint64_t> hash;  ///< XXH64; none: there was no file that could be read.
};

/// The files of `inputs` as they are now.
[[nodiscard]] std::vector<Dependency> take_dependencies(const CookInputs& inputs, const CookPlace& place);

[[nodiscard]] std::filesystem::path path_of(const Dependency& dependency, const CookPlace& place);

/// True where all of them hold what they held.
[[nodiscard]] bool are_unchanged(const std::vector<Dependency>& dependencies, const CookPlace& place);

/// True where the folder of the source's textures gives the same answers as then.
[[nodiscard]] bool are_still_answered(const std::vector<TextureQuestion>& questions, const CookPlace& place);

/// A moment as file systems stamp it, which is coarser than the clock.
[[nodiscard]] std::chrono::nanoseconds file_time_now();

/// The first of the files (source included) that was written, replaced or renamed at `since` or later.
[[nodiscard]] std::optional<std::filesystem::path> changed_since(std::chrono::nanoseconds since,
                                                                 const std::vector<Dependency>& dependencies,
                                                                 const CookPlace& place);

}  // namespace coif
