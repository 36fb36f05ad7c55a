#pragma once

#include "base/tool_error.h"
#include "cook/cook.h"

#include <tl/expected.hpp>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cache {

// How the files of a cache are called: K1/K2...K32/E1...E32.entry, digits of a key and of what an entry is the result
// of.
inline constexpr std::size_t kDigitsOfEntry = 32;
inline constexpr const char* kCacheSuffix = ".entry";
inline constexpr std::chrono::hours kStaleInCache{24};  ///< Older temporary files are those of killed processes.

/// Where a cook stands on this machine. What depends on it is kept relative to it.
struct CookPlace {
  std::filesystem::path source;                ///< The source file.
  std::filesystem::path recipe_directory;      ///< CookSettings::recipe_directory.
  std::vector<std::filesystem::path> roots{};  ///< ImportSettings::roots.

  [[nodiscard]] std::filesystem::path source_directory() const;
};

/// A file that a result depends on, and what it held.
struct Dependency {
  enum class Base { kSource, kRecipe } base = Base::kSource;
  std::string path;                   ///< From the base's folder; absolute where it lies elsewhere.
  std::optional<std::uint64_t> hash;  ///< XXH64; none: there was no file that could be read.
};

/// All that is known before the import and changes what a cook makes.
struct CookIdentity {
  std::string tool;      ///< The cooker: its version, and whatever tells two builds of one version apart.
  std::string importer;  ///< importer_name().
  CookPlace place;
  std::span<const std::byte> source_bytes;
  std::string recipe;  ///< print_recipe(): how a recipe is written, and its comments, change nothing.
  bool draft = false;  ///< CookSettings::draft.
};

/// 32 hexadecimal digits, from two XXH64 with different seeds: proof against accidents, not against forgers. Of the
/// source's path the file's name counts alone (its suffix chooses the reader, its stem helps to find textures), and
/// roots count as they lie from it, so checkouts in different folders share a cache.
[[nodiscard]] std::string cook_key(const CookIdentity& identity);

/// The same digits for any bytes.
[[nodiscard]] std::string content_digits(std::span<const std::byte> bytes);

/// A cook as a cache keeps it: the result, and what it is the result of.
struct CacheEntry {
  std::vector<Dependency> dependencies;
  std::vector<cook::TextureQuestion> questions;
  std::vector<std::string>
      named;                ///< CookInputs::named_files, from the source's folder; absolute where they lie elsewhere.
  cook::CookReport report;  ///< As the cook that made it told it, times included.
  std::vector<std::byte> asset;
};

/// One file: a magic word, the hash of all that follows, the length of a MessagePack document, the document, the
/// asset's bytes.
[[nodiscard]] std::vector<std::byte> encode_entry(const CacheEntry& entry);

/// Nothing unless the bytes are those of one entry, to the last bit.
[[nodiscard]] std::optional<CacheEntry> decode_entry(std::span<const std::byte> bytes);

/// What an entry is the result of, as bytes: entries with the same are the same.
[[nodiscard]] std::vector<std::byte> circumstances(const CacheEntry& entry);

/// Results of cooks in a folder, found by what they are made of. Two steps, as ccache's direct mode: a key from what is
/// known before the import leads to a folder of entries, and each entry lists the files that its cook read and what it
/// looked for in vain. Any number of processes, on any machines that share the folder, may use it at once: an entry is
/// one file that appears whole or not at all and is believed only where its hash fits. The folder may be deleted, whole
/// or in part, at any time; an entry's modification time is that of its last use.
class CookCache {
 public:
  explicit CookCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The result of the same cook, with the inputs where they lie here. Whatever is absent, damaged or out of date is
  /// nothing.
  [[nodiscard]] std::optional<cook::CookResult> find(const std::string& key, const CookPlace& place) const;

  /// Keeps a result. `begin`: file_clock_now() (platform/files.h) before the first input was read; inputs that changed
  /// since may not be those that were read, and the result is not kept. Errors say what keeps it from being kept; the
  /// cook itself is none the worse.
  tl::expected<void, ToolError> store(const std::string& key, const CookPlace& place, const cook::CookResult& result,
                                      std::chrono::nanoseconds begin) const;

 private:
  [[nodiscard]] std::filesystem::path folder_of(const std::string& key) const;

  std::filesystem::path folder_;
};

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
