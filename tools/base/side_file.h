#pragma once

// Files that another file names, as programs of every system write their names.

#include <filesystem>
#include <string>

namespace coif {

struct SideFile {
  std::filesystem::path path;
  bool is_respelled = false;  ///< There is none of the name as it is written; this one is meant.
};

/// ASCII letters only; other bytes stay.
[[nodiscard]] std::string lower_case(std::string text);

/// Backslashes become slashes.
[[nodiscard]] std::string with_slashes(std::string path);

/// What follows the last slash.
[[nodiscard]] std::string last_name(const std::string& path);

/// Where the file lies that something in `folder` names: as it is written; else with slashes for backslashes and in letters of either
/// case; else by its last name in that folder, which a path of another machine ends with. As written where there is none of these. What
/// it names may lie anywhere, and be no regular file: lies_in() tells.
[[nodiscard]] SideFile find_side_file(const std::filesystem::path& folder, const std::string& written);

}  // namespace coif
