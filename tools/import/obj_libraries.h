#pragma once

// The material libraries of an OBJ, as programs of every system write their names and their text.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace coif {

/// Lines as the format means them: without a byte order mark, ended by \n, continued ones in one, without blanks at their ends. What
/// assimp 5.2 does not know is taken away: quotes around the names of images, capital letters of keywords, "-halo", and statements
/// without a number where it wants one, for which it would refuse the whole model.
[[nodiscard]] std::string plain_library_text(std::string_view bytes);

/// Files that one mtllib statement names.
struct ObjLibraries {
  std::vector<std::filesystem::path> paths;  ///< Which are there; empty: none.
  bool is_respelled = false;                 ///< find_side_file().
};

/// `written`: the rest of the statement's line: a name with blanks in it or behind it, within quotes, or several names.
[[nodiscard]] ObjLibraries find_libraries(const std::filesystem::path& folder, std::string_view written);

}  // namespace coif
