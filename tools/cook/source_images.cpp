#include "cook/source_images.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

namespace coif {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostNamed = 8;

/// "a.png, b.png and 3 more".
std::string listed(const TextureFolder& folder, std::span<const fs::path> images) {
  std::vector<std::string> names;
  for (const fs::path& image : images.first(std::min(images.size(), kMostNamed))) {
    names.push_back(folder.short_name(image));
  }
  const std::string text = fmt::format("{}", fmt::join(names, ", "));
  return images.size() <= kMostNamed ? text : fmt::format("{} and {} more", text, images.size() - kMostNamed);
}

}  // namespace

const Image* SourceImages::of(const SourceMaterial& material) {
  if (material.base_texture.image < source_.images.size()) return embedded(material);
  return material.base_texture.path.empty() ? nullptr : beside(material);
}

const Image* SourceImages::embedded(const SourceMaterial& material) {
  const std::uint32_t index = material.base_texture.image;
  const SourceImage& image = source_.images[index];
  const std::string key = fmt::format("{}", index);
  if (const auto known = decoded_.find(key); known != decoded_.end()) {
    return known->second ? &*known->second : nullptr;
  }
  return keep(key, decode_image(image.bytes),
              fmt::format("material '{}': embedded image '{}'", material.name, image.name));
}

const Image* SourceImages::beside(const SourceMaterial& material) {
  const std::string& written = material.base_texture.path;
  const std::optional<fs::path> path = folder_.find(written);
  note_question(TextureQuestion::Kind::kFind, {written});
  if (!path) {
    warn_of_absent(material);
    return nullptr;
  }
  if (folder_.short_name(*path) != written) {
    warnings_.push_back(
        fmt::format("material '{}': texture '{}' taken from {}", material.name, written, folder_.short_name(*path)));
  }
  return read(*path, fmt::format("material '{}': {}", material.name, path->string()));
}

const Image* SourceImages::guess(std::span<const std::string> names) {
  const std::vector<fs::path> candidates = folder_.colors_of(names);
  note_question(TextureQuestion::Kind::kColors, {names.begin(), names.end()});
  if (candidates.empty()) {
    notes_.push_back("no material of the hair names a texture");
    return nullptr;
  }
  if (candidates.size() > 1) {
    warnings_.push_back(
        fmt::format("no material of the hair names a texture, and several images beside the source may be meant: {}; "
                    "choose one in the recipe: \"textures\": {{\"base_color\": \"{}\"}}",
                    listed(folder_, candidates), folder_.short_name(candidates[0])));
    return nullptr;
  }
  const Image* image = read(candidates[0], candidates[0].string());
  if (image != nullptr) {
    warnings_.push_back(
        fmt::format("no material of the hair names a texture; {} is taken, since its name fits; say "
                    "\"textures\": {{\"base_color\": ...}} in the recipe if it is another",
                    folder_.short_name(candidates[0])));
  }
  return image;
}

const Image* SourceImages::read(const fs::path& path, const std::string& for_what) {
  const std::string key = path.string();
  if (const auto known = decoded_.find(key); known != decoded_.end()) {
    return known->second ? &*known->second : nullptr;
  }
  files_.push_back(path);
  return keep(key, read_image(path), for_what);
}

const Image* SourceImages::keep(const std::string& key, tl::expected<Image, std::string> image,
                                const std::string& for_what) {
  if (!image) {
    warnings_.push_back(fmt::format("{}: {}; it is cooked without a base texture", for_what, image.error()));
    decoded_.emplace(key, std::nullopt);
    return nullptr;
  }
  return &*decoded_.emplace(key, std::move(*image)).first->second;
}

void SourceImages::note_question(TextureQuestion::Kind kind, std::vector<std::string> words) {
  TextureQuestion question{kind, std::move(words), {}};
  question.answer = answer_to(question, folder_);
  questions_.push_back(std::move(question));
}

void SourceImages::warn_of_absent(const SourceMaterial& material) {
  note_question(TextureQuestion::Kind::kImages, {});
  const std::string there =
      folder_.images().empty()
          ? "put it there"
          : fmt::format("put it there, or choose one of {} by \"textures.base_color\" in the recipe",
                        listed(folder_, folder_.images()));
  warnings_.push_back(
      fmt::format("material '{}': texture '{}': no such file beside the source or in its texture "
                  "folders; {}; it is cooked without a base texture",
                  material.name, material.base_texture.path, there));
}

}  // namespace coif
