#include "import/scene_surface.h"

#include "base/text.h"
#include "import/collada_document.h"

#include <pugixml.hpp>

#include <algorithm>
#include <iterator>
#include <new>
#include <ranges>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

namespace coif::importer {
namespace {

std::string id_in(const pugi::xml_attribute& reference) { return std::string(collada_id(reference)); }

std::optional<TextureWrap> wrap_in(const pugi::xml_node& sampler, const char* element) {
  const std::string_view word = sampler.child(element).child_value();
  if (word.empty()) return std::nullopt;
  if (word == "MIRROR") return TextureWrap::kMirror;
  // A border is one colour outside; the texture's edge, which is clear where that matters, is nearest to it.
  return word == "WRAP" ? TextureWrap::kRepeat : TextureWrap::kClamp;
}

}  // namespace

/// Reads the document in one walk; references are resolved at the end of the walk.
class ColladaTextures::Walk : public pugi::xml_tree_walker {
 public:
  explicit Walk(ColladaTextures& out) : out_(out) {}

  bool for_each(pugi::xml_node& node) override {
    const std::string_view name = node.name();
    if (name == "effect") effect_ = node;
    if (name == "newparam" && node.child("sampler2D"))
      samplers_[node.attribute("sid").value()] = node.child("sampler2D");
    if (name == "diffuse" && node.child("texture")) out_.effects_[effect_id()].base = texture_in(node);
    if (name == "transparent" && node.child("texture")) add_opacity(node);
    if (name == "material") add_material(node);
    if (name == "geometry") uv_sets_[node.attribute("id").value()] = uv_sets_of(node);
    if (name == "skin" || name == "morph") {
      sources_[node.parent().attribute("id").value()] = id_in(node.attribute("source"));
    }
    if (name == "instance_material") bindings_.push_back(node);
    return true;
  }

  void bind() const {
    for (const pugi::xml_node& binding : bindings_) {
      const std::string material = id_in(binding.attribute("target"));
      const auto effect = effect_of_.find(material);
      const auto found = effect == effect_of_.end() ? out_.effects_.end() : out_.effects_.find(effect->second);
      if (found == out_.effects_.end()) continue;
      const std::string geometry = geometry_of(binding.parent().parent().parent());  // technique_common, bind_material
      bind(binding, geometry, material, Use::kBase, found->second.base);
      bind(binding, geometry, material, Use::kOpacity, found->second.opacity);
    }
  }

 private:
  /// The UV sets of a mesh's triangles of one material, and those that assimp gives them: it continues with the sets of
  /// the triangles after them.
  struct UvSets {
    std::set<unsigned> own, given;
  };

  /// By the material's symbol.
  static std::map<std::string, UvSets> uv_sets_of(const pugi::xml_node& geometry) {
    std::vector<std::pair<std::string, std::set<unsigned>>> parts;
    for (const pugi::xml_node& part : geometry.child("mesh").children()) {
      std::set<unsigned> sets;
      for (const pugi::xml_node& input : part.children("input")) {
        if (std::string_view(input.attribute("semantic").value()) == "TEXCOORD")
          sets.insert(input.attribute("set").as_uint());
      }
      if (part.child("p")) parts.emplace_back(part.attribute("material").value(), std::move(sets));
    }
    std::map<std::string, UvSets> out;
    std::set<unsigned> given;
    for (auto& [symbol, own] : std::views::reverse(parts)) {
      given.insert(own.begin(), own.end());
      out[symbol] = {std::move(own), given};
    }
    return out;
  }

  [[nodiscard]] std::string effect_id() const { return effect_.attribute("id").value(); }

  [[nodiscard]] Texture texture_in(const pugi::xml_node& use) const {
    const pugi::xml_node texture = use.child("texture");
    Texture out;
    out.texcoord = texture.attribute("texcoord").value();
    const auto sampler = samplers_.find(texture.attribute("texture").value());
    if (sampler == samplers_.end()) return out;
    out.wrap[0] = wrap_in(sampler->second, "wrap_s");
    out.wrap[1] = wrap_in(sampler->second, "wrap_t");
    return out;
  }

  void add_opacity(const pugi::xml_node& use) {
    Effect& effect = out_.effects_[effect_id()];
    effect.opacity = texture_in(use);
    const std::string_view opaque = use.attribute("opaque").as_string("A_ONE");
    // Where alpha is meant and the image has none, the exporter used its luminance.
    effect.opacity_channel = opaque.starts_with("RGB") ? TextureChannel::kLuminance : TextureChannel::kAuto;
    effect.opacity_inverted = opaque.ends_with("ZERO");
  }

  void add_material(const pugi::xml_node& node) {
    const std::string id = node.attribute("id").value(), name = node.attribute("name").value();
    const std::string effect = id_in(node.child("instance_effect").attribute("url"));
    effect_of_.emplace(id, effect);
    name_of_.emplace(id, name.empty() ? id : name);
    out_.effect_of_.emplace(printable_text(name.empty() ? id : name), effect);
  }

  /// The geometry that is instanced, itself or by a controller that deforms it.
  [[nodiscard]] std::string geometry_of(const pugi::xml_node& instance) const {
    std::string id = id_in(instance.attribute("url"));
    for (std::size_t step = 0; step <= sources_.size(); ++step) {
      const auto source = sources_.find(id);
      if (source == sources_.end()) break;
      id = source->second;
    }
    return id;
  }

  void bind(const pugi::xml_node& binding, const std::string& geometry, const std::string& material, Use use,
            const std::optional<Texture>& texture) const {
    const auto symbols = uv_sets_.find(geometry);
    if (!texture || symbols == uv_sets_.end()) return;
    const auto sets = symbols->second.find(binding.attribute("symbol").value());
    if (sets == symbols->second.end()) return;
    for (const pugi::xml_node& input : binding.children("bind_vertex_input")) {
      const unsigned set = input.attribute("input_set").as_uint();
      const bool is_of_texture = texture->texcoord == input.attribute("semantic").value() &&
                                 std::string_view(input.attribute("input_semantic").value()) == "TEXCOORD";
      if (!is_of_texture || !sets->second.own.contains(set)) continue;
      const auto& given = sets->second.given;
      out_.uv_sets_.emplace(std::tuple(printable_text(geometry), printable_text(name_of_.at(material)), use),
                            unsigned(std::distance(given.begin(), given.find(set))));
      return;
    }
  }

  ColladaTextures& out_;
  pugi::xml_node effect_;
  std::map<std::string, pugi::xml_node> samplers_;
  std::map<std::string, std::string> effect_of_, name_of_;        // By the material's id.
  std::map<std::string, std::string> sources_;                    // By the controller's id.
  std::map<std::string, std::map<std::string, UvSets>> uv_sets_;  // By the geometry's id.
  std::vector<pugi::xml_node> bindings_;
};

ColladaTextures::ColladaTextures(pugi::xml_document& document) {
  Walk walk(*this);
  document.traverse(walk);
  walk.bind();
}

std::optional<unsigned> ColladaTextures::uv_set(const std::string& geometry, const std::string& material,
                                                Use use) const {
  const auto found = uv_sets_.find(std::tuple(geometry, material, use));
  return found == uv_sets_.end() ? std::nullopt : std::optional(found->second);
}

void ColladaTextures::apply(std::span<SourceMaterial> materials) const {
  const auto apply_wrap = [](const std::optional<Texture>& said, SourceTexture& texture) {
    for (int axis = 0; said && axis < 2; ++axis) texture.wrap[axis] = said->wrap[axis].value_or(texture.wrap[axis]);
  };
  for (SourceMaterial& material : materials) {
    const auto id = effect_of_.find(material.name);
    const auto effect = id == effect_of_.end() ? effects_.end() : effects_.find(id->second);
    if (effect == effects_.end()) continue;
    apply_wrap(effect->second.base, material.base_texture);
    if (!material.opacity_texture.is_there() || !effect->second.opacity) continue;
    apply_wrap(effect->second.opacity, material.opacity_texture);
    material.opacity_channel = effect->second.opacity_channel;
    material.opacity_inverted = effect->second.opacity_inverted;
  }
}

}  // namespace coif::importer
