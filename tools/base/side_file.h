#pragma once

// Files that another file names, as programs of every system write their names.

#include <filesystem>
#include <string>

namespace coif {

/// A name that another is taken for, both as messages show them.
struct Respelled {
  std::string written, found;
};

struct SideFile {
  std::filesystem::path path;
  bool is_respelled = false;  ///< There is none of the name as it is written; this one is meant.
};

/// Backslashes become slashes.
[[nodiscard]] std::string with_slashes(std::string path);

/// What follows the last slash.
[[nodiscard]] std::string last_name(const std::string& path);

/// Where the file lies that something in `folder` names: as it is written; else with slashes for backslashes and in
/// letters of either case; else by its last name in that folder, which a path of another machine ends with. As written
/// where there is none of these. What it names may lie anywhere, and be no regular file: lies_in() tells.
[[nodiscard]] SideFile find_side_file(const std::filesystem::path& folder, const std::string& written);

/// As a message names a file that something in `folder` names.
[[nodiscard]] std::string shown_from(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace coif
