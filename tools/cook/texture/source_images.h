#pragma once

// What the names of image files say, and how paths are spelt in models.

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

/// False where a word in the name says that the image is something else than colour: a normal map, a mask, a thumbnail.
[[nodiscard]] bool names_color(const std::string& stem);

/// True where one of `names`, of three letters or more, is a word of the name, whatever the case: "curly" of
/// "curly_texture".
[[nodiscard]] bool names_as_word(const std::string& stem, std::span<const std::string> names);

/// True where the name holds "hair" or one of `names`. Letters and digits count alone; names that every program gives
/// ("Material.001", "defaultobject") and those of one or two letters do not count.
[[nodiscard]] bool names_any(const std::string& stem, std::span<const std::string> names);

/// The image files that belong to a source: in its own folder, and in the folders below it and beside it that artists
/// customarily use (textures, maps, tex ...). Paths written in a source are those of another machine and may be
/// hostile: nothing outside of these folders is ever found, not even through a link, but for what lies beside the real
/// source if that is a link, and in declared roots (folders_of_source()). Unreadable folders count as empty.
class TextureFolder {
 public:
  explicit TextureFolder(const std::filesystem::path& source, std::span<const std::filesystem::path> roots = {});

  /// The file for a path as it stands in a source: with slashes or backslashes, absolute or relative, percent-encoded
  /// or not, in letters of either case. Looked for where the path says, if that is below the source's folder, then by
  /// its last name, then by the last name with the suffix of another image format.
  [[nodiscard]] std::optional<std::filesystem::path> find(const std::string& written) const;

  /// Where a file that find() does not give because it is a link out of all those folders really lies.
  [[nodiscard]] std::optional<std::filesystem::path> find_outside(const std::string& written) const;

  /// Images whose name says that they colour something called one of `names`, or hair. Normal maps and the like do not.
  [[nodiscard]] std::vector<std::filesystem::path> colors_of(std::span<const std::string> names) const;

  /// All images, those beside the source first, each folder in the order of names.
  [[nodiscard]] std::span<const std::filesystem::path> images() const { return images_; }

  /// `path` relative to the source's folder, with slashes: for messages and recipes.
  [[nodiscard]] std::string short_name(const std::filesystem::path& path) const;

 private:
  void list(const std::filesystem::path& folder);
  [[nodiscard]] bool is_inside(const std::filesystem::path& path) const;
  [[nodiscard]] std::optional<std::filesystem::path> follow(const std::string& written) const;  ///< Inside or not.
  [[nodiscard]] std::optional<std::filesystem::path> find_by_name(const std::string& name) const;

  std::filesystem::path root_;                     ///< As the source's path has it.
  bool leaves_root_ = false;                       ///< Paths may, since other folders are declared.
  std::vector<std::filesystem::path> real_roots_;  ///< folders_of_source().
  std::vector<std::filesystem::path> images_;
};

/// What a cook asked of the folder beside its source, and what it learned. As long as a folder gives the same answers
/// to the same questions, what else comes and goes there does not matter.
struct TextureQuestion {
  enum class Kind {
    kFind,    ///< `words`: one path as written in the source. Answered by the file's short name, by two words where it
              ///< leads outside, or by nothing.
    kColors,  ///< `words`: what the hair is called. Answered by the short names of the images that may colour it.
    kImages,  ///< No words. Answered by all images' short names.
  };
  Kind kind = Kind::kFind;
  std::vector<std::string> words;
  std::vector<std::string> answer;
};

/// What the folder answers today.
[[nodiscard]] std::vector<std::string> answer_to(const TextureQuestion& question, const TextureFolder& folder);

/// The image files that a source's materials name for any use: where their paths lead from its folder, and where
/// they were found.
[[nodiscard]] std::vector<std::filesystem::path> named_image_files(const importer::SourceModel& source);

/// Finds and decodes the images that a source's materials name: embedded ones, and files beside the source. What cannot
/// be had is a warning, never an error: hair without a texture is still hair.
class SourceImages {
 public:
  explicit SourceImages(const importer::SourceModel& source) : source_(source), folder_(source.path, source.roots) {}

  /// The base image of a material; null where it names none or has none that can be read. Valid as long as this object.
  [[nodiscard]] const Image* of(const importer::SourceMaterial& material);

  /// The base image of a material with its opacity texture as alpha; as of() where it has none, or none that can be
  /// read.
  [[nodiscard]] const Image* with_opacity(const importer::SourceMaterial& material);

  /// Its normal or bump map; null where it names none or has none that can be read.
  [[nodiscard]] const Image* normals_of(const importer::SourceMaterial& material);

  /// What is known of its single strands; null where nothing is.
  [[nodiscard]] const Image* strands_of(const importer::SourceMaterial& material);

  /// For hair whose materials name no image at all: the one file beside the source whose name says that it colours hair
  /// or something called one of `names`, or the only one that no other material names. Of several the one in whose name
  /// one of `names` stands as a word; where that leaves several, a warning lists them.
  [[nodiscard]] const Image* guess(std::span<const std::string> names);

  [[nodiscard]] const Findings& findings() const { return findings_; }
  /// Every file that was read, in the order of reading.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  /// All that was asked of the folder, in the order of asking.
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
  void tell_other_maps(const importer::SourceMaterial& material);  ///< Each once.

  const importer::SourceModel& source_;
  TextureFolder folder_;
  std::map<std::string, Image> joined_;  ///< Base images with their opacity, by both names.
  Decoded decoded_;                      ///< By file or number, so that two materials share what they show.
  Findings findings_;
  std::vector<std::filesystem::path> files_;
  std::vector<TextureQuestion> questions_;
};

}  // namespace coif::cook
