#pragma once

// What assimp gets to see of the files beside a model.

#include "base/side_file.h"

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace coif::importer {

/// What assimp asked for beside the model, by name.
struct Asked {
  std::set<std::string>
      names;  ///< Looked for or opened, whether there was such a file or not: a model changes with each.
  std::vector<std::string> not_opened;  ///< In their order.
  std::vector<std::string> libraries;   ///< plain_library_text() of each that an OBJ opened, in their order.
  std::vector<Respelled> respelled;     ///< Libraries with another name than is written.
};

/// Files as assimp sees them, with a record: the model, and what really lies in its folders. Nothing else is there for
/// it. Of an OBJ the model is without a byte order mark and text_with_even_colors(), and a library is what
/// find_libraries() and plain_library_text() make of it.
class AskedFiles : public Assimp::DefaultIOSystem {
 public:
  /// `text`: what the model holds for assimp, where that is not what the file holds. `asked` outlives this object.
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

/// Lines as the format means them: without a byte order mark, ended by \n, continued ones in one, without blanks at
/// their ends. What assimp 5.2 does not know is taken away: quotes around the names of images, capital letters of
/// keywords, "-halo", and statements without a number where it wants one, for which it would refuse the whole model.
[[nodiscard]] std::string plain_library_text(std::string_view bytes);

/// Files that one mtllib statement names.
struct ObjLibraries {
  std::vector<std::filesystem::path> paths;  ///< Which are there; empty: none.
  bool is_respelled = false;                 ///< find_side_file().
};

/// `written`: the rest of the statement's line: a name with blanks in it or behind it, within quotes, or several names.
[[nodiscard]] ObjLibraries find_libraries(const std::filesystem::path& folder, std::string_view written);

/// The text of an OBJ in which some vertices have a colour and others none, with white for those; assimp 5.2 would give
/// colours to the wrong vertices, and read memory that is none of theirs. A vertex's alpha, which is no part of the
/// format, and for which it would leave the vertex out, is taken away. None where nothing is to be changed.
[[nodiscard]] std::optional<std::string> text_with_even_colors(std::string_view text);

/// The file's bytes; none where it cannot be read.
[[nodiscard]] std::vector<char> bytes_of(const std::filesystem::path& path);

}  // namespace coif::importer
