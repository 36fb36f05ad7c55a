#include "cook/recipe/recipe_texture.h"

#include "cook/recipe/recipe_keys.h"

#include <algorithm>
#include <iterator>

namespace coif::cook {
namespace {

using nlohmann::json;
using Outcome = tl::expected<void, std::string>;

constexpr const char* kWantedTexture =
    "a path, or {\"file\": \"hair.png\", \"channel\": \"auto\", \"r\", \"g\", \"b\", \"a\" or \"luminance\", "
    "\"invert\": true or false}";
constexpr const char* kChannelWords[] = {"auto", "r", "g", "b", "a", "luminance"};  // as TextureChannel

bool read_channel(const json& value, TextureChannel& out) {
  const auto* const word =
      value.is_string() ? std::ranges::find(kChannelWords, value.get<std::string>()) : std::end(kChannelWords);
  if (word == std::end(kChannelWords)) return false;
  out = TextureChannel(word - std::begin(kChannelWords));
  return true;
}

}  // namespace

const char* channel_word(TextureChannel channel) { return kChannelWords[std::size_t(channel)]; }

Outcome read_recipe_texture(const json& value, RecipeTexture& out) {
  RecipeTexture texture;
  if (value.is_string()) {
    texture.file = value.get<std::string>();
    out = std::move(texture);
    return {};
  }
  if (!value.is_object() || !member(value, "file").is_string()) return wants(kWantedTexture, value);
  for (const auto& [name, part] : value.items()) {
    bool fits = false;
    if (name == "file") {
      texture.file = part.get<std::string>();
      fits = true;
    } else if (name == "channel") {
      fits = read_channel(part, texture.channel);
    } else if (name == "invert" && part.is_boolean()) {
      texture.is_inverted = part.get<bool>();
      fits = true;
    }
    if (!fits) return wants(kWantedTexture, value);
  }
  out = std::move(texture);
  return {};
}

json write_recipe_texture(const RecipeTexture& texture) {
  if (texture.channel == TextureChannel::kAuto && !texture.is_inverted) return texture.file;
  json value{{"file", texture.file}, {"channel", channel_word(texture.channel)}};
  if (texture.is_inverted) value["invert"] = true;
  return value;
}

}  // namespace coif::cook
