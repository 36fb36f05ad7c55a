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

// Names of the files of a cache: K1/K2...K32/E1...E32.entry, digits of a key and of the circumstances of an entry.
inline constexpr std::size_t kDigitsOfEntry = 32;
inline constexpr const char* kCacheSuffix = ".entry";
inline constexpr std::chrono::hours kStaleInCache{24};  ///< Older temporary files were left by killed processes.

/// The place of a cook on this machine. Paths that depend on it are stored relative to it.
struct CookPlace {
  std::filesystem::path source;                ///< The source file.
  std::filesystem::path recipe_directory;      ///< CookSettings::recipe_directory.
  std::vector<std::filesystem::path> roots{};  ///< ImportSettings::roots.

  [[nodiscard]] std::filesystem::path source_directory() const;
};

/// A file that a result depends on, and its content then.
struct Dependency {
  enum class Base { kSource, kRecipe } base = Base::kSource;
  std::string path;                   ///< From the base's folder; absolute where it lies elsewhere.
  std::optional<std::uint64_t> hash;  ///< XXH64; none: there was no file that could be read.
};

/// Everything that is known before the import and changes a cook's result.
struct CookIdentity {
  std::string tool;      ///< The version of the cook, with a mark that distinguishes two builds of one version.
  std::string importer;  ///< importer_name().
  CookPlace place;
  std::span<const std::byte> source_bytes;
  std::string recipe;  ///< print_recipe(): how a recipe is written, and its comments, change nothing.
  bool draft = false;  ///< CookSettings::draft.
};

/// 32 hexadecimal digits from two XXH64 with different seeds: proof against accidents, not against forgers. Only the
/// file name of the source's path counts (its suffix chooses the reader, its stem helps to find textures), and roots
/// count relative to it. So checkouts in different folders share a cache.
[[nodiscard]] std::string cook_key(const CookIdentity& identity);

/// The digits of any bytes.
[[nodiscard]] std::string content_digits(std::span<const std::byte> bytes);

/// A cook in the form that a cache keeps: its result, and the inputs of that result.
struct CacheEntry {
  std::vector<Dependency> dependencies;
  std::vector<cook::TextureQuestion> questions;
  std::vector<std::string>
      named;                ///< CookInputs::named_files, from the source's folder; absolute where they lie elsewhere.
  cook::CookReport report;  ///< The report of the original cook, times included.
  std::vector<std::byte> asset;
};

/// Encodes an entry as one file: a magic word, the hash of everything that follows, the length of a MessagePack
/// document, the document, the asset's bytes.
[[nodiscard]] std::vector<std::byte> encode_entry(const CacheEntry& entry);

/// Decodes an entry. None unless the bytes are exactly those of one entry.
[[nodiscard]] std::optional<CacheEntry> decode_entry(std::span<const std::byte> bytes);

/// The inputs of an entry's result as bytes. Entries with equal bytes are equal.
[[nodiscard]] std::vector<std::byte> circumstances(const CacheEntry& entry);

/// Results of cooks in a folder, found by their inputs. Works in two steps, like ccache's direct mode: a key of
/// everything known before the import leads to a folder of entries, and each entry lists the files that its cook read
/// or looked for in vain. Any number of processes, on any machines that share the folder, may use it at once: an entry
/// is one file that appears whole or not at all, and it is used only if its hash fits. The folder may be deleted, whole
/// or in part, at any time. An entry's modification time is the time of its last use.
class CookCache {
 public:
  explicit CookCache(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// The result of the same cook, with the inputs where they lie here. Whatever is absent, damaged or out of date is
  /// nothing.
  [[nodiscard]] std::optional<cook::CookResult> find(const std::string& key, const CookPlace& place) const;

  /// Stores a result. `begin`: file_clock_now() (platform/files.h) before the first input was read; if an input has
  /// changed since, the result is not stored. The error says why the result was not stored; the cook itself is not
  /// affected.
  tl::expected<void, ToolError> store(const std::string& key, const CookPlace& place, const cook::CookResult& result,
                                      std::chrono::nanoseconds begin) const;

 private:
  [[nodiscard]] std::filesystem::path folder_of(const std::string& key) const;

  std::filesystem::path folder_;
};

/// The contents of a cache's folder. Bytes are file sizes, without the file system's rounding.
struct CacheUsage {
  std::size_t keys = 0;  ///< Sources, each with a recipe and a version of the program.
  std::size_t entries = 0;
  std::uint64_t bytes = 0;    ///< Sum of the entries' sizes.
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

/// Removes leftovers and the least recently used entries until the remaining ones have at most `max_bytes` in all.
/// Files that no cache wrote stay. Cooks on any machine may use the cache meanwhile: what they read is whole or absent,
/// and an entry that was used since the folder was read stays. Errors (kFileAccess): those of cache_usage(), and a file
/// that cannot be removed.
tl::expected<CacheTrimmed, ToolError> trim_cache(const std::filesystem::path& folder, std::uint64_t max_bytes);

}  // namespace coif::cache
