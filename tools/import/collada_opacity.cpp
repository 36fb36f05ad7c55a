#include "import/scene_surface.h"

#include "base/text.h"

#include <pugixml.hpp>

#include <cstring>
#include <map>
#include <new>
#include <string>

namespace coif {
namespace {

/// How COLLADA's "opaque" attribute says which numbers of a texture are the opacity.
struct OpaqueMode {
  TextureChannel channel = TextureChannel::kAuto;
  bool is_inverted = false;
};

OpaqueMode opaque_mode(const std::string& word) {
  // Where alpha is meant and the image has none, its luminance is what the exporter had.
  if (word == "A_ZERO") return {TextureChannel::kAuto, true};
  if (word == "RGB_ONE") return {TextureChannel::kLuminance, false};
  if (word == "RGB_ZERO") return {TextureChannel::kLuminance, true};
  return {};
}

/// Modes of the effects whose transparency is a texture, by id; materials' effects, by what assimp calls the material.
class TransparentEffects : public pugi::xml_tree_walker {
 public:
  bool for_each(pugi::xml_node& node) override {
    if (std::strcmp(node.name(), "transparent") == 0 && node.child("texture")) {
      pugi::xml_node effect = node;
      while (effect && std::strcmp(effect.name(), "effect") != 0) effect = effect.parent();
      modes[effect.attribute("id").value()] = opaque_mode(node.attribute("opaque").as_string("A_ONE"));
    }
    if (std::strcmp(node.name(), "material") == 0 && node.child("instance_effect")) {
      const std::string url = node.child("instance_effect").attribute("url").value();
      const std::string effect = url.substr(url.starts_with('#') ? 1 : 0);
      for (const char* name : {"name", "id"}) {
        if (*node.attribute(name).value() != 0) effects.emplace(printable_text(node.attribute(name).value()), effect);
      }
    }
    return true;
  }

  std::map<std::string, OpaqueMode> modes;
  std::map<std::string, std::string> effects;
};

}  // namespace

void apply_collada_opacity(std::string_view document, SourceModel& model) {
  pugi::xml_document parsed;
  const pugi::xml_parse_result result = parsed.load_buffer(document.data(), document.size());
  if (result.status == pugi::status_out_of_memory) throw std::bad_alloc();
  if (!result) return;
  TransparentEffects found;
  parsed.traverse(found);
  for (SourceMaterial& material : model.materials) {
    const auto effect = found.effects.find(material.name);
    if (!material.opacity_texture.is_there() || effect == found.effects.end()) continue;
    const auto mode = found.modes.find(effect->second);
    if (mode == found.modes.end()) continue;
    material.opacity_channel = mode->second.channel;
    material.opacity_inverted = mode->second.is_inverted;
  }
}

}  // namespace coif
