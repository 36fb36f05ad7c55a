#pragma once

// The files beside a model that assimp may read.

#include "base/side_file.h"

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace coif::importer {

/// The files beside the model that assimp asked for, by name.
struct Asked {
  std::set<std::string>
      names;  ///< Looked for or opened, whether there was such a file or not: a model changes with each.
  std::vector<std::string> not_opened;  ///< In the order of the requests.
  std::vector<std::string> libraries;   ///< plain_library_text() of each library that an OBJ opened, in their order.
  std::vector<Respelled> respelled;     ///< Libraries with another name than is written.
};

/// The file system that assimp sees, with a record: only the model, and files that really lie in its folders. The model
/// of an OBJ is text_with_even_colors() without a byte order mark, and a library is the result of find_libraries() and
/// plain_library_text().
class AskedFiles : public Assimp::DefaultIOSystem {
 public:
  /// `text`: the model's content for assimp, if it differs from the file's. `asked` must outlive this object.
  AskedFiles(std::filesystem::path model, std::optional<std::string> text, std::vector<std::filesystem::path> folders,
             bool is_obj, Asked& asked)
      : model_(std::move(model)),
        text_(std::move(text)),
        folders_(std::move(folders)),
        is_obj_(is_obj),
        asked_(asked) {}

  bool Exists(const char* name) const override;
  Assimp::IOStream* Open(const char* name, const char* mode) override;

 private:
  [[nodiscard]] bool is_allowed(const std::filesystem::path& name) const;
  [[nodiscard]] Assimp::IOStream* open_plainly(const std::string& name, const char* mode);
  [[nodiscard]] Assimp::IOStream* open_library(const std::string& name);

  std::filesystem::path model_;  ///< May be a link that leads anywhere.
  std::optional<std::string> text_;
  std::vector<std::filesystem::path> folders_;
  bool is_obj_;
  Asked& asked_;
};

// The material libraries of an OBJ, as programs of every system write their names and their text: obj_libraries.cpp.

inline constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

/// Normalises the lines of a library: no byte order mark, lines end with \n, continued lines are joined, no blanks at
/// their ends. Removes what assimp 5.2 cannot read: quotes around the names of images, capital letters of keywords,
/// "-halo", and statements that lack a number, for which it would refuse the whole model.
[[nodiscard]] std::string plain_library_text(std::string_view bytes);

/// Files that one mtllib statement names.
struct ObjLibraries {
  std::vector<std::filesystem::path> paths;  ///< Existing files; empty: none.
  bool is_respelled = false;                 ///< find_side_file().
};

/// `written`: the rest of the statement's line: a name with blanks in it or behind it, within quotes, or several names.
[[nodiscard]] ObjLibraries find_libraries(const std::filesystem::path& folder, std::string_view written);

/// The text of an OBJ in which only some vertices have a colour, with white for the others; assimp 5.2 would give
/// colours to the wrong vertices, and read memory out of range. Removes alphas of vertices, which are not part of the
/// format and for which it would drop the vertex. None where nothing has to change.
[[nodiscard]] std::optional<std::string> text_with_even_colors(std::string_view text);

/// The file's bytes; none where it cannot be read.
[[nodiscard]] std::vector<char> bytes_of(const std::filesystem::path& path);

}  // namespace coif::importer
