#include "pipeline/dependency.h"

#include "files/file_bytes.h"
#include "payload_hash.h"

#include <sys/stat.h>
#include <time.h>

#include <algorithm>

namespace coif {
namespace {

namespace fs = std::filesystem;

std::chrono::nanoseconds duration_of(const timespec& time) {
  return std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec);
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

}  // namespace

fs::path CookPlace::source_directory() const { return or_here(source.parent_path()); }

std::vector<Dependency> take_dependencies(const CookInputs& inputs, const CookPlace& place) {
  std::vector<Dependency> dependencies;
  take(inputs.source_files, Dependency::Base::kSource, place.source_directory(), dependencies);
  take(inputs.recipe_files, Dependency::Base::kRecipe, or_here(place.recipe_directory), dependencies);
  return dependencies;
}

fs::path path_of(const Dependency& dependency, const CookPlace& place) {
  const bool from_recipe = dependency.base == Dependency::Base::kRecipe;
  return (from_recipe ? or_here(place.recipe_directory) : place.source_directory()) / dependency.path;
}

bool are_unchanged(const std::vector<Dependency>& dependencies, const CookPlace& place) {
  return std::ranges::all_of(dependencies,
                             [&](const Dependency& d) { return hash_of_file(path_of(d, place)) == d.hash; });
}

bool are_still_answered(const std::vector<TextureQuestion>& questions, const CookPlace& place) {
  if (questions.empty()) return true;
  const TextureFolder folder(place.source);
  return std::ranges::all_of(questions, [&](const TextureQuestion& q) { return answer_to(q, folder) == q.answer; });
}

std::chrono::nanoseconds file_time_now() {
  timespec now{};
  clock_gettime(CLOCK_REALTIME_COARSE, &now);
  return duration_of(now);
}

std::optional<fs::path> changed_since(std::chrono::nanoseconds since, const std::vector<Dependency>& dependencies,
                                      const CookPlace& place) {
  std::vector<fs::path> paths{place.source};
  for (const Dependency& dependency : dependencies) paths.push_back(path_of(dependency, place));
  const auto found = std::ranges::find_if(paths, [&](const fs::path& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) == 0 && duration_of(status.st_ctim) >= since;
  });
  return found == paths.end() ? std::nullopt : std::optional(*found);
}

}  // namespace coif
