#include "cache/cook_cache.h"

#include "base/files.h"
#include "payload_hash.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cache {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostEntries = 16;  ///< Entries of one key: one source with so many states of its textures.
constexpr const char* kFolderMark = "\x1f";

struct AgedFile {
  fs::path path;
  fs::file_time_type time;
};

/// Newest first: the entry that was used last is the likeliest to fit.
std::vector<AgedFile> files_in(const fs::path& folder) {
  std::vector<AgedFile> files;
  std::error_code error;
  for (fs::directory_iterator it(folder, error), end; !error && it != end; it.increment(error)) {
    std::error_code gone;
    const fs::file_time_type time = it->last_write_time(gone);
    if (!gone) files.push_back({it->path(), time});
  }
  std::ranges::sort(files, [](const AgedFile& a, const AgedFile& b) { return a.time > b.time; });
  return files;
}

void remove_surplus(const fs::path& folder) {
  std::size_t entries = 0;
  for (const AgedFile& file : files_in(folder)) {
    const bool is_entry = file.path.extension() == kCacheSuffix;
    const bool stale =
        is_entry ? ++entries > kMostEntries : fs::file_time_type::clock::now() - file.time > kStaleInCache;
    std::error_code ignored;
    if (stale) fs::remove(file.path, ignored);
  }
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size()) {
    text.replace(at, from.size(), to);
  }
}

/// Messages contain paths of files; those of another checkout would be wrong here.
void replace_in_messages(cook::CookReport& report, const std::string& from, const std::string& to) {
  for (Diagnostic& warning : report.warnings) replace_all(warning.message, from, to);
  for (std::string& text : report.notes) replace_all(text, from, to);
  for (cook::LeftOut& left_out : report.left_out) {
    replace_all(left_out.what, from, to);
    replace_all(left_out.why, from, to);
  }
}

fs::path or_here(const fs::path& folder) { return folder.empty() ? fs::path(".") : folder; }

std::optional<std::uint64_t> hash_of_file(const fs::path& path) {
  const auto bytes = FileBytes::read(path);
  return bytes ? std::optional(xxh64(bytes->span())) : std::nullopt;
}

void take(const std::vector<fs::path>& files, Dependency::Base base, const fs::path& folder,
          std::vector<Dependency>& dependencies) {
  for (const fs::path& file : files) {
    dependencies.push_back({base, file.lexically_proximate(folder).string(), hash_of_file(file)});
  }
}

/// The present state of the files of `inputs`.
std::vector<Dependency> take_dependencies(const cook::CookInputs& inputs, const CookPlace& place) {
  std::vector<Dependency> dependencies;
  take(inputs.source_files, Dependency::Base::kSource, place.source_directory(), dependencies);
  take(inputs.recipe_files, Dependency::Base::kRecipe, or_here(place.recipe_directory), dependencies);
  return dependencies;
}

fs::path path_of(const Dependency& dependency, const CookPlace& place) {
  const bool from_recipe = dependency.base == Dependency::Base::kRecipe;
  return (from_recipe ? or_here(place.recipe_directory) : place.source_directory()) / dependency.path;
}

/// True where all files have the same content as then.
bool are_unchanged(const std::vector<Dependency>& dependencies, const CookPlace& place) {
  return std::ranges::all_of(dependencies,
                             [&](const Dependency& d) { return hash_of_file(path_of(d, place)) == d.hash; });
}

/// True where the folder of the source's textures gives the same answers as then.
bool are_still_answered(const std::vector<cook::TextureQuestion>& questions, const CookPlace& place) {
  if (questions.empty()) return true;
  const cook::TextureFolder folder(place.source, place.roots);
  return std::ranges::all_of(questions,
                             [&](const cook::TextureQuestion& q) { return cook::answer_to(q, folder) == q.answer; });
}

/// The first of the files (source included) that was written, replaced or renamed at `since` or later.
std::optional<fs::path> changed_since(std::chrono::nanoseconds since, const std::vector<Dependency>& dependencies,
                                      const CookPlace& place) {
  std::vector<fs::path> paths{place.source};
  for (const Dependency& dependency : dependencies) paths.push_back(path_of(dependency, place));
  const auto found = std::ranges::find_if(paths, [&](const fs::path& path) {
    const auto changed = platform::file_change_time(path);
    return changed && *changed >= since;
  });
  return found == paths.end() ? std::nullopt : std::optional(*found);
}

cook::CookResult result_from(CacheEntry entry, const CookPlace& place) {
  cook::CookResult result{std::move(entry.asset), std::move(entry.report), {}, {}};
  replace_in_messages(result.report, kFolderMark, place.source_directory().string() + "/");
  for (const Dependency& dependency : entry.dependencies) {
    const bool from_recipe = dependency.base == Dependency::Base::kRecipe;
    auto& files = from_recipe ? result.inputs.recipe_files : result.inputs.source_files;
    files.push_back(path_of(dependency, place));
  }
  result.inputs.questions = std::move(entry.questions);
  for (const std::string& path : entry.named) result.inputs.named_files.push_back(place.source_directory() / path);
  return result;
}

tl::expected<void, ToolError> write_entry(const fs::path& file, std::span<const std::byte> bytes) {
  std::error_code error;
  fs::create_directories(file.parent_path(), error);
  if (error) {
    const fs::path cache = file.parent_path().parent_path().parent_path();
    return file_failure(ToolError::Kind::kFileAccess, cache, "cannot create the cache's folder: {}", error.message());
  }
  // Something other than an entry may lie there: writing into a pipe would wait for a reader for ever.
  if (fs::exists(file, error) && !fs::is_regular_file(file, error)) fs::remove(file, error);
  return write_output(file, bytes);
}

}  // namespace

fs::path CookPlace::source_directory() const { return or_here(source.parent_path()); }

fs::path CookCache::folder_of(const std::string& key) const { return folder_ / key.substr(0, 2) / key.substr(2); }

std::optional<cook::CookResult> CookCache::find(const std::string& key, const CookPlace& place) const {
  for (const AgedFile& file : files_in(folder_of(key))) {
    if (file.path.extension() != kCacheSuffix) continue;
    const auto bytes = FileBytes::read(file.path);
    auto entry = bytes ? decode_entry(bytes->span()) : std::nullopt;
    if (!entry || !are_unchanged(entry->dependencies, place) || !are_still_answered(entry->questions, place)) continue;
    std::error_code ignored;
    fs::last_write_time(file.path, fs::file_time_type::clock::now(), ignored);
    return result_from(std::move(*entry), place);
  }
  return {};
}

tl::expected<void, ToolError> CookCache::store(const std::string& key, const CookPlace& place,
                                               const cook::CookResult& result, std::chrono::nanoseconds begin) const {
  CacheEntry entry{take_dependencies(result.inputs, place), result.inputs.questions, {}, result.report, result.asset};
  for (const fs::path& named : result.inputs.named_files)
    entry.named.push_back(named.lexically_proximate(place.source_directory()).string());
  if (const auto changed = changed_since(begin, entry.dependencies, place)) {
    return tl::unexpected(ToolError{ToolError::Kind::kFileAccess,
                                    changed->string() + ": changed while it was cooked; the result is not cached"});
  }
  const std::string folder = place.source_directory().string();
  // A relative folder such as "." occurs in texts that mean something else.
  if (place.source.is_absolute()) replace_in_messages(entry.report, folder + "/", kFolderMark);
  const fs::path file = folder_of(key) / (content_digits(circumstances(entry)) + kCacheSuffix);
  auto written = write_entry(file, encode_entry(entry));
  // A process that trims the cache may have removed the empty folder.
  if (!written && !fs::exists(file.parent_path())) written = write_entry(file, encode_entry(entry));
  remove_surplus(folder_of(key));
  return written;
}

std::string content_digits(std::span<const std::byte> bytes) {
  return fmt::format("{:016x}{:016x}", xxh64(bytes, 0), xxh64(bytes, 1));
}

std::string cook_key(const CookIdentity& identity) {
  constexpr const char* kLayout = "coif cache 4";  // of the entries, too: another layout never meets this one's
  std::vector<std::string> parts{kLayout,
                                 identity.tool,
                                 identity.importer,
                                 identity.place.source.filename().string(),
                                 content_digits(identity.source_bytes),
                                 identity.recipe,
                                 identity.draft ? "draft" : ""};
  for (const fs::path& root : identity.place.roots) {
    std::error_code error;
    parts.push_back(fs::proximate(root, identity.place.source_directory(), error).string());
  }
  std::string text;
  // Lengths in front, so that no two different lists of parts read the same.
  for (const std::string& part : parts) text += fmt::format("{}:{}", part.size(), part);
  return content_digits(std::as_bytes(std::span(text)));
}

}  // namespace coif::cache
