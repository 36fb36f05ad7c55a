#include "base/side_file.h"

#include "base/text.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

namespace coif {
namespace {

namespace fs = std::filesystem;

/// A folder with more entries is somebody's download folder; further entries are not looked at.
constexpr std::size_t kMostEntries = 4096;

bool is_there(const fs::path& path) {
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

/// The first by name of several: the order of a directory differs between machines.
std::optional<fs::path> entry_of_either_case(const fs::path& folder, const std::string& name) {
  std::optional<fs::path> found;
  std::error_code error;
  std::size_t count = 0;
  const std::string wanted = lower_case(name);
  for (fs::directory_iterator it(folder.empty() ? "." : folder, error), end; !error && it != end; it.increment(error)) {
    if (++count > kMostEntries) break;
    const fs::path entry = it->path().filename();
    if (lower_case(entry.string()) == wanted && (!found || entry < *found)) found = entry;
  }
  return found ? std::optional(folder / *found) : std::nullopt;
}

std::optional<fs::path> follow(const fs::path& folder, const std::string& path) {
  fs::path at = folder;
  for (const fs::path& part : fs::path(path).relative_path()) {
    if (part.empty() || part == ".") continue;
    if (part == ".." || is_there(at / part)) {
      at /= part;
      continue;
    }
    const auto entry = entry_of_either_case(at, part.string());
    if (!entry) return std::nullopt;
    at = *entry;
  }
  return is_there(at) ? std::optional(at) : std::nullopt;
}

bool is_name(std::string_view text) { return !text.empty() && text.find('\0') == std::string_view::npos; }

/// A path that begins with a slash or a drive's letter belongs to one machine.
bool is_of_the_folder(std::string_view slashes) {
  return !slashes.starts_with('/') && !(slashes.size() > 1 && slashes[1] == ':');
}

}  // namespace

std::string with_slashes(std::string path) {
  std::ranges::replace(path, '\\', '/');
  return path;
}

std::string last_name(const std::string& path) { return path.substr(path.find_last_of('/') + 1); }

SideFile find_side_file(const fs::path& folder, const std::string& written) {
  const fs::path as_written = folder / written;
  if (!is_name(written) || is_there(as_written)) return {as_written};
  const std::string slashes = with_slashes(written);
  if (is_of_the_folder(slashes)) {
    if (auto found = follow(folder, slashes)) return {*found, true};
  }
  const std::string name = last_name(slashes);
  const bool is_own = is_name(name) && name != "." && name != ".." && name != slashes;
  if (auto found = is_own ? follow(folder, name) : std::nullopt) return {*found, true};
  return {as_written};
}

std::string shown_from(const fs::path& folder, const fs::path& path) {
  return printable_text(path.lexically_proximate(folder).generic_string(), 100);
}

}  // namespace coif
