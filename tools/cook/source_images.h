#pragma once

#include "cook/image.h"
#include "cook/texture_question.h"
#include "import/source_model.h"

#include <map>

namespace coif {

/// Finds and decodes the images that a source's materials name: embedded ones, and files beside the source. What cannot
/// be had is a warning, never an error: hair without a texture is still hair.
class SourceImages {
 public:
  explicit SourceImages(const SourceModel& source) : source_(source), folder_(source.path) {}

  /// The base image of a material; null where it names none or has none that can be read. Valid as long as this object.
  [[nodiscard]] const Image* of(const SourceMaterial& material);

  /// For hair whose materials name no image at all: the one file beside the source whose name says that it colours hair or
  /// something called one of `names`. Where several do, a warning lists them.
  [[nodiscard]] const Image* guess(std::span<const std::string> names);

  [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// Every file that was read, in the order of reading.
  [[nodiscard]] const std::vector<std::filesystem::path>& files() const { return files_; }
  /// All that was asked of the folder, in the order of asking.
  [[nodiscard]] const std::vector<TextureQuestion>& questions() const { return questions_; }

 private:
  using Decoded = std::map<std::string, std::optional<Image>>;

  const Image* embedded(const SourceMaterial& material);
  const Image* beside(const SourceMaterial& material);
  const Image* read(const std::filesystem::path& path, const std::string& for_what);
  const Image* keep(const std::string& key, tl::expected<Image, std::string> image, const std::string& for_what);
  void note_question(TextureQuestion::Kind kind, std::vector<std::string> words);
  void warn_of_absent(const SourceMaterial& material);

  const SourceModel& source_;
  TextureFolder folder_;
  Decoded decoded_;  ///< By file or number, so that two materials share what they show.
  std::vector<std::string> warnings_;
  std::vector<std::string> notes_;
  std::vector<std::filesystem::path> files_;
  std::vector<TextureQuestion> questions_;
};

}  // namespace coif
