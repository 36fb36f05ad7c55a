#pragma once

// Names of image files, and the spelling of paths in models.

#include "cook/recipe/findings.h"
#include "cook/texture/image.h"
#include "import/source_model.h"

#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

/// Ends in the suffix of a format that the cooker reads, in letters of either case.
[[nodiscard]] bool is_image_name(const std::string& file);

/// The name without the suffix of an image or picture editor's format (psd, dds ...). Other dots belong to the name.
[[nodiscard]] std::string stem_of_image(const std::string& file);

/// False where a word of the name shows that the image is not colour: a normal map, a mask, a thumbnail.
[[nodiscard]] bool names_color(const std::string& stem);

/// True where one of `names`, of three letters or more, is a word of the name, whatever the case: "curly" of
/// "curly_texture".
[[nodiscard]] bool names_as_word(const std::string& stem, std::span<const std::string> names);

/// True where the name contains "hair" or one of `names`. Only letters and digits count; names that every program gives
/// ("Material.001", "defaultobject") and those of one or two letters do not count.
[[nodiscard]] bool names_any(const std::string& stem, std::span<const std::string> names);

/// The image files that belong to a source: in its own folder, and in the customary folders below it and beside it
/// (textures, maps, tex ...). Paths in a source are those of another machine and may be hostile: nothing outside these
/// folders is ever found, not even through a link. Two exceptions: files beside the real source if that is a link, and
/// declared roots (folders_of_source()). Unreadable folders count as empty.
class TextureFolder {
 public:
  explicit TextureFolder(const std::filesystem::path& source, std::span<const std::filesystem::path> roots = {});

  /// The file for a path in a source: with slashes or backslashes, absolute or relative, percent-encoded or not,
  /// ignoring case. Looks at that path, if it is below the source's folder, then for its last name, then for the last
  /// name with the suffix of another image format.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& written) const;

  /// The real place of a file that find() does not return because it is a link out of all those folders.
  [[nodiscard]] std::optional<std::filesystem::path> find_outside(const std::string& written) const;

  /// Images whose name says that they colour something called one of `names`, or hair; not normal maps and the like.
  [[nodiscard]] std::vector<std::filesystem::path> colors_of(std::span<const std::string> names) const;

  /// All images, those beside the source first, each folder sorted by name.
  [[nodiscard]] std::span<const std::filesystem::path> images() const { return images_; }

  /// `path` relative to the source's folder, with slashes: for messages and recipes.
  [[nodiscard]] std::string short_name(const std::filesystem::path& path) const;

 private:
  void list(const std::filesystem::path& folder);
  [[nodiscard]] bool is_inside(const std::filesystem::path& path) const;
  [[nodiscard]] std::optional<std::filesystem::path> follow(const std::string& written) const;  ///< Inside or not.
  [[nodiscard]] std::optional<std::filesystem::path> find_by_name(const std::string& name) const;

  std::filesystem::path root_;                     ///< As in the source's path.
  bool leaves_root_ = false;                       ///< Paths may leave the root, since other folders are declared.
  std::vector<std::filesystem::path> real_roots_;  ///< folders_of_source().
  std::vector<std::filesystem::path> images_;
};

/// A question of a cook to the folder of its source, with its answer. As long as a folder gives the same answers, its
/// other contents do not matter.
struct TextureQuestion {
  enum class Kind {
    kFind,    ///< `words`: one path as written in the source. Answered by the file's short name, by two words where it
              ///< leads outside, or by nothing.
    kColors,  ///< `words`: names of the hair. The answer is the short names of images that may colour it.
    kImages,  ///< No words. Answered by all images' short names.
  };
  Kind kind = Kind::kFind;
  std::vector<std::string> words;
  std::vector<std::string> answer;
};

/// The folder's present answer.
[[nodiscard]] std::vector<std::string> answer_to(const TextureQuestion& question, const TextureFolder& folder);

/// The image files that a source's materials name for any use: where their paths lead from its folder, and where
/// they were found.
[[nodiscard]] std::vector<std::filesystem::path> named_image_files(const importer::SourceModel& source);

/// Finds and decodes the images that a source's materials name: embedded ones, and files beside the source. An image
/// that cannot be read is a warning, never an error: hair without a texture is still hair.
class SourceImages {
 public:
  explicit SourceImages(const importer::SourceModel& source) : source_(source), folder_(source.path, source.roots) {}

  /// The base image of a material; null where it names none or has none that can be read. Valid as long as this object.
  [[nodiscard]] const Image* of(const importer::SourceMaterial& material);

  /// The base image of a material with its opacity texture as alpha; as of() where it has none, or none that can be
  /// read.
  [[nodiscard]] const Image* with_opacity(const importer::SourceMaterial& material);

  /// Its normal or bump map; null where it names none that can be read.
  [[nodiscard]] const Image* normals_of(const importer::SourceMaterial& material);

  /// The data about its single strands; null where there is none.
  [[nodiscard]] const Image* strands_of(const importer::SourceMaterial& material);

  /// For hair whose materials name no image: the only file beside the source whose name says that it colours hair or
  /// something called one of `names`, or the only one that no other material names. Among several it is the one whose
  /// name has one of `names` as a word; if several remain, a warning lists them.
  [[nodiscard]] const Image* guess(std::span<const std::string> names);

  [[nodiscard]] const Findings& findings() const { return findings_; }
  /// Every file that was read, in the order of reading.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  /// All questions to the folder, in their order.
  [[nodiscard]] const std::vector<TextureQuestion>& questions() const { return questions_; }

 private:
  using Decoded = std::map<std::string, std::optional<Image>>;

  const Image* embedded(const importer::SourceMaterial& material, std::uint32_t index);
  const Image* beside(const importer::SourceMaterial& material);
  [[nodiscard]] std::vector<std::filesystem::path> named_by_none() const;
  const Image* read(const std::filesystem::path& path, const std::string& for_what);
  const Image* keep(const std::string& key, tl::expected<Image, std::string> image, const std::string& for_what);
  void note_question(TextureQuestion::Kind kind, std::vector<std::string> words);
  void warn_of_absent(const importer::SourceMaterial& material);
  const Image* opacity_of(const importer::SourceMaterial& material);
  void tell_other_maps(const importer::SourceMaterial& material);  ///< Reports each once.

  const importer::SourceModel& source_;
  TextureFolder folder_;
  std::map<std::string, Image> joined_;  ///< Base images with their opacity, by both names.
  Decoded decoded_;                      ///< By file or number, so that two materials share an image.
  Findings findings_;
  std::vector<std::filesystem::path> files_;
  std::vector<TextureQuestion> questions_;
};

}  // namespace coif::cook
