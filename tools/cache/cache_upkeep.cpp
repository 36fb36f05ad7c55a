#include "cache/cook_cache.h"

#include <algorithm>
#include <chrono>
#include <string>
#include <system_error>
#include <vector>

namespace coif::cache {
namespace {

namespace fs = std::filesystem;

struct CacheFile {
  fs::path path;
  fs::file_time_type used;
  std::uint64_t bytes = 0;
};

struct CacheFiles {
  std::size_t keys = 0;
  std::vector<CacheFile> entries, leftovers;
};

bool is_digits(const std::string& text, std::size_t count) {
  return text.size() == count && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

/// None if the file has been removed meanwhile.
std::optional<CacheFile> look_at(const fs::path& path) {
  std::error_code error;
  CacheFile file{path, fs::last_write_time(path, error), 0};
  if (!error) file.bytes = fs::file_size(path, error);
  return error ? std::nullopt : std::optional(file);
}

/// Collects the entries and temporary files in the folder of one key.
void collect(const fs::path& folder, CacheFiles& files) {
  const auto now = fs::file_time_type::clock::now();
  const std::size_t before = files.entries.size();
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    const std::string name = it->path().filename().string();
    const std::size_t dot = name.find('.');
    std::error_code gone;
    if (dot == std::string::npos || !is_digits(name.substr(0, dot), kDigitsOfEntry) || !it->is_regular_file(gone))
      continue;
    const auto file = look_at(it->path());
    if (!file) continue;
    if (name.substr(dot) == kCacheSuffix) files.entries.push_back(*file);
    if (name.ends_with(".tmp") && now - file->used > kStaleInCache) files.leftovers.push_back(*file);
  }
  files.keys += files.entries.size() > before;
}

tl::expected<CacheFiles, ToolError> files_of(const fs::path& folder) {
  CacheFiles files;
  std::error_code error;
  fs::directory_iterator firsts(folder, error);
  if (error) return file_failure(ToolError::Kind::kFileAccess, folder, "cannot read the cache: {}", error.message());
  for (const fs::directory_iterator end; !error && firsts != end; firsts.increment(error)) {
    if (!is_digits(firsts->path().filename().string(), 2)) continue;
    std::error_code gone;
    for (fs::directory_iterator keys(firsts->path(), gone), last; !gone && keys != last; keys.increment(gone)) {
      if (is_digits(keys->path().filename().string(), kDigitsOfEntry - 2)) collect(keys->path(), files);
    }
  }
  if (error) return file_failure(ToolError::Kind::kFileAccess, folder, "cannot read the cache: {}", error.message());
  return files;
}

std::uint64_t bytes_of(const std::vector<CacheFile>& files) {
  std::uint64_t bytes = 0;
  for (const CacheFile& file : files) bytes += file.bytes;
  return bytes;
}

/// False where somebody used it since, or removed it already.
tl::expected<bool, ToolError> remove_unused(const CacheFile& file) {
  std::error_code error;
  const auto used = fs::last_write_time(file.path, error);
  if (error || used != file.used) return false;
  const bool removed = fs::remove(file.path, error);
  if (error) return file_failure(ToolError::Kind::kFileAccess, file.path, "cannot remove: {}", error.message());
  // Removes the folders above it that are now empty; a cook that needs them makes them again.
  fs::path folder = file.path.parent_path();
  for (int level = 0; level < 2 && fs::remove(folder, error) && !error; ++level) folder = folder.parent_path();
  return removed;
}

}  // namespace

tl::expected<CacheUsage, ToolError> cache_usage(const fs::path& folder) {
  const auto files = files_of(folder);
  if (!files) return tl::unexpected(files.error());
  CacheUsage usage{files->keys,
                   files->entries.size(),
                   bytes_of(files->entries),
                   files->leftovers.size(),
                   bytes_of(files->leftovers),
                   {},
                   {}};
  if (files->entries.empty()) return usage;
  const auto [oldest, newest] = std::ranges::minmax(files->entries, {}, &CacheFile::used);
  usage.oldest_use = oldest.used;
  usage.newest_use = newest.used;
  return usage;
}

tl::expected<CacheTrimmed, ToolError> trim_cache(const fs::path& folder, std::uint64_t max_bytes) {
  auto files = files_of(folder);
  if (!files) return tl::unexpected(files.error());
  CacheTrimmed trimmed;
  for (const CacheFile& file : files->leftovers) {
    const auto removed = remove_unused(file);
    if (!removed) return tl::unexpected(removed.error());
    trimmed.leftovers += *removed;
  }
  // Entries of equal age are sorted by path, so that the folder's order does not matter.
  std::ranges::sort(files->entries, [](const CacheFile& a, const CacheFile& b) {
    return std::pair(a.used, a.path) < std::pair(b.used, b.path);
  });
  std::uint64_t left = bytes_of(files->entries);
  for (const CacheFile& file : files->entries) {
    if (left <= max_bytes) break;
    const auto removed = remove_unused(file);
    if (!removed) return tl::unexpected(removed.error());
    if (!*removed) continue;
    left -= file.bytes;
    trimmed.bytes += file.bytes;
    ++trimmed.entries;
  }
  return trimmed;
}

}  // namespace coif::cache
