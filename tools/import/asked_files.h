#pragma once

// What assimp gets to see of the files beside a model.

#include <assimp/DefaultIOSystem.h>

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace coif {

/// What assimp asked for beside the model, by name.
struct Asked {
  std::set<std::string>
      names;  ///< Looked for or opened, whether there was such a file or not: a model changes with each.
  std::vector<std::string> not_opened;  ///< In their order.
  std::vector<std::string> libraries;   ///< Of an OBJ: plain_library_text() of each that was opened, in their order.
  struct Respelled {
    std::string written, found;
  };
  std::vector<Respelled> respelled;  ///< Libraries with another name than is written, for messages.
};

/// Files as assimp sees them, with a record: the model, and what really lies in its folders. Nothing else is there for it. Of an OBJ the
/// model is without a byte order mark, and a library is found and read as obj_libraries.h says.
class AskedFiles : public Assimp::DefaultIOSystem {
 public:
  /// `asked` outlives this object.
  AskedFiles(std::filesystem::path model, std::vector<std::filesystem::path> folders, bool is_obj, Asked& asked)
      : model_(std::move(model)), folders_(std::move(folders)), is_obj_(is_obj), asked_(asked) {}

  bool Exists(const char* name) const override;
  Assimp::IOStream* Open(const char* name, const char* mode) override;

 private:
  [[nodiscard]] bool is_allowed(const std::filesystem::path& name) const;
  [[nodiscard]] Assimp::IOStream* open_plainly(const std::string& name, const char* mode);
  [[nodiscard]] Assimp::IOStream* open_library(const std::string& name);

  std::filesystem::path model_;  ///< May be a link that leads anywhere.
  std::vector<std::filesystem::path> folders_;
  bool is_obj_;
  Asked& asked_;
};

/// The file's bytes; none where it cannot be read.
[[nodiscard]] std::vector<char> bytes_of(const std::filesystem::path& path);

}  // namespace coif
