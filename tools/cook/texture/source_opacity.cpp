#include "cook/texture/recipe_maps.h"
#include "cook/texture/source_images.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cook {

// Alpha that a file keeps in an image of its own: a map_d of OBJ, TransparentColor of FBX, transparent of COLLADA.

namespace {

constexpr const char* kChannelNames[] = {"", "red", "green", "blue", "alpha", "luminance"};  // as TextureChannel

std::string texture_key(const importer::SourceTexture& texture) {
  return texture.image != importer::kNoIndex ? fmt::format("{}", texture.image) : texture.path;
}

}  // namespace

const Image* SourceImages::opacity_of(const importer::SourceMaterial& material) {
  const importer::SourceTexture& texture = material.opacity_texture;
  if (texture.image < source_.images.size()) return embedded(material, texture.image);
  const auto path = folder_.find(texture.path);
  note_question(TextureQuestion::Kind::kFind, {texture.path});
  if (path) return read(*path, fmt::format("material '{}': opacity texture {}", material.name, path->string()));
  findings_.warn("C144",
                 fmt::format("material '{}': opacity texture '{}': no such file beside the source or in its texture "
                             "folders; put it there, or "
                             "name an image in the recipe: \"textures\": {{\"opacity\": ...}}; it is cooked without it",
                             material.name, texture.path));
  return nullptr;
}

const Image* SourceImages::with_opacity(const importer::SourceMaterial& material) {
  const Image* const base = of(material);
  if (!material.opacity_texture.is_there()) return base;
  const Image* const opacity = opacity_of(material);
  if (opacity == nullptr) return base;
  const TextureChannel channel = channel_in(*opacity, material.opacity_channel);
  const std::string key = fmt::format("{}\n{}\n{}\n{}", texture_key(material.base_texture),
                                      texture_key(material.opacity_texture), int(channel), material.opacity_inverted);
  if (const auto known = joined_.find(key); known != joined_.end()) return &known->second;
  findings_.note(
      fmt::format("material '{}': alpha is the {}{} of opacity texture '{}'; another is chosen by \"textures\": "
                  "{{\"opacity\": {{\"file\": ..., \"channel\": ..., \"invert\": ...}}}} in the recipe",
                  material.name, material.opacity_inverted ? "inverted " : "", kChannelNames[std::size_t(channel)],
                  material.opacity_texture.path));
  return &joined_.emplace(key, with_alpha(base, channel_of(*opacity, channel, material.opacity_inverted)))
              .first->second;
}

}  // namespace coif::cook
