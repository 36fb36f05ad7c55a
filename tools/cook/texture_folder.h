#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif {

/// The image files that belong to a source: in its own folder and in the folders below it that artists customarily use
/// (textures, maps, tex ...). Paths written in a source are those of another machine and may be hostile: nothing outside
/// the source's folder is ever found, not even through a link. Unreadable folders count as empty.
class TextureFolder {
 public:
  explicit TextureFolder(const std::filesystem::path& source);

  /// The file for a path as it stands in a source: with slashes or backslashes, absolute or relative, percent-encoded or
  /// not, in letters of either case. Looked for where the path says, if that is below the source's folder, then by its
  /// last name, then by the last name with the suffix of another image format.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& written) const;

  /// Images whose name says that they colour something called one of `names`, or hair. Normal maps and the like do not.
  [[nodiscard]] std::vector<std::filesystem::path> colors_of(std::span<const std::string> names) const;

  /// All images, those beside the source first, each folder in the order of names.
  [[nodiscard]] std::span<const std::filesystem::path> images() const { return images_; }

  /// `path` relative to the source's folder, with slashes: for messages and recipes.
  [[nodiscard]] std::string short_name(const std::filesystem::path& path) const;

 private:
  void list(const std::filesystem::path& folder);
  [[nodiscard]] bool is_inside(const std::filesystem::path& path) const;
  [[nodiscard]] std::optional<std::filesystem::path> follow(const std::string& written) const;
  [[nodiscard]] std::optional<std::filesystem::path> find_by_name(const std::string& name) const;

  std::filesystem::path root_;       ///< As the source's path has it.
  std::filesystem::path real_root_;  ///< Without links.
  std::vector<std::filesystem::path> images_;
};

}  // namespace coif
