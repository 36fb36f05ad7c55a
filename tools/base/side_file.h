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
  bool is_respelled = false;  ///< No file has the name as written; this one is meant.
};

/// Backslashes become slashes.
[[nodiscard]] std::string with_slashes(std::string path);

/// The part after the last slash.
[[nodiscard]] std::string last_name(const std::string& path);

/// Finds the file that something in `folder` names: as written; else with slashes for backslashes and ignoring case;
/// else by its last name in that folder, for paths of other machines. Returns the written path where none of these
/// exists. The result may lie anywhere and need not be a regular file: check with lies_in().
[[nodiscard]] SideFile find_side_file(const std::filesystem::path& folder, const std::string& written);

/// The name that messages use for a file that something in `folder` names.
[[nodiscard]] std::string shown_from(const std::filesystem::path& folder, const std::filesystem::path& path);

}  // namespace coif
