#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>

namespace coif::cache {

/// What a cache's folder holds. Bytes are those of the files, without what the file system rounds up.
struct CacheUsage {
  std::size_t keys = 0;  ///< Sources, each with a recipe and a version of the program.
  std::size_t entries = 0;
  std::uint64_t bytes = 0;    ///< What the entries take.
  std::size_t leftovers = 0;  ///< Files that killed cooks left half written, a day old or more.
  std::uint64_t leftover_bytes = 0;
  std::optional<std::filesystem::file_time_type> oldest_use, newest_use;
};

/// Counts. Files that no cache wrote are passed over. Error (kFileAccess): the folder is absent or cannot be read.
[[nodiscard]] tl::expected<CacheUsage, ToolError> cache_usage(const std::filesystem::path& folder);

struct CacheTrimmed {
  std::size_t entries = 0;
  std::uint64_t bytes = 0;
  std::size_t leftovers = 0;
};

/// Removes leftovers and, from the least recently used on, entries until those that remain have at most `max_bytes` in
/// all. Files that no cache wrote stay. Cooks may use the cache meanwhile, on any machine: what they read is whole or
/// absent, and an entry that was used since the folder was read stays. Error (kFileAccess): as cache_usage(), and what
/// cannot be removed.
tl::expected<CacheTrimmed, ToolError> trim_cache(const std::filesystem::path& folder, std::uint64_t max_bytes);

}  // namespace coif::cache
