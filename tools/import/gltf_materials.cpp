#include "import/gltf_scene.h"

#include "base/text.h"
#include "gltf/document.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string_view>

namespace coif::importer {
namespace {

using nlohmann::json;

/// The values of a sampler's wrapS and wrapT: glTF 2.0, 5.26.
TextureWrap wrap_of(const json& value) {
  const auto number = index_of(value, 1 << 16);
  return number == 33071u ? TextureWrap::kClamp : number == 33648u ? TextureWrap::kMirror : TextureWrap::kRepeat;
}

float number_or(const json& value, double otherwise, double most) {
  return float(std::clamp(number_of(value).value_or(otherwise), 0.0, most));
}

class MaterialReader {
 public:
  MaterialReader(const json& document, gltf::GltfBuffers& buffers, SourceModel& model)
      : document_(document),
        buffers_(buffers),
        model_(model),
        textures_(list_of(member(document, "textures"))),
        images_(list_of(member(document, "images"))) {}

  std::string read(std::vector<GltfUvs>& uvs) {
    for (const json& entry : list_of(member(document_, "materials"))) {
      SourceMaterial material;
      material.name = printable_text_of(member(entry, "name"));
      const json& specular = gltf::extension(entry, "KHR_materials_pbrSpecularGlossiness");
      const json& metallic = member(entry, "pbrMetallicRoughness");
      const json& base = member(specular, "diffuseTexture").is_null() ? member(metallic, "baseColorTexture")
                                                                      : member(specular, "diffuseTexture");
      material.base_color =
          color_of(specular.is_object() ? member(specular, "diffuseFactor") : member(metallic, "baseColorFactor"));
      material.base_texture = texture_of(base, material.name);
      uvs.push_back(uvs_of(base, material.name));
      const json& normal = member(entry, "normalTexture");
      material.normal_texture = texture_of(normal, material.name);
      material.normal_strength = strength_of(member(normal, "scale"));
      warn_of_other_uvs(normal, uvs.back(), material);
      read_alpha(entry, material);
      if (!material.base_texture.is_there()) take_emission(entry, material, uvs.back());
      add_other_maps(entry, metallic, specular, material);
      material.roughness = specular.is_object() ? 1 - number_or(member(specular, "glossinessFactor"), 1, 1)
                                                : number_or(member(metallic, "roughnessFactor"), 1, 1);
      material.double_sided = member(entry, "doubleSided") == true;
      model_.materials.push_back(std::move(material));
      if (!fault_.empty()) return fault_;
    }
    settle_unseen_materials(model_.materials, model_.warnings);
    return {};
  }

 private:
  static Eigen::Vector4f color_of(const json& value) {
    Eigen::Vector4f color = Eigen::Vector4f::Ones();
    for (std::size_t i = 0; i < 4 && value.is_array() && value.size() == 4; ++i) {
      color[Eigen::Index(i)] = float(std::max(number_of(value[i]).value_or(1), 0.0));
    }
    return color.allFinite() ? color : Eigen::Vector4f::Ones();
  }

  // Files without a sensible number show the map as it is painted.
  static float strength_of(const json& value) {
    const double strength = number_of(value).value_or(1);
    return strength >= 0 && strength <= double{kMostNormalStrength} ? float(strength) : 1;
  }

  static void read_alpha(const json& entry, SourceMaterial& material) {
    const json& mode = member(entry, "alphaMode");
    material.alpha_use = mode.is_null() || mode == "OPAQUE" ? AlphaUse::kOpaque
                         : mode == "MASK"                   ? AlphaUse::kMask
                         : mode == "BLEND"                  ? AlphaUse::kBlend
                                                            : AlphaUse::kUnknown;
    material.alpha_cutoff = number_or(member(entry, "alphaCutoff"), 0.5, 1);
  }

  /// Exporters write a material without light as one that emits; its colour is the emission.
  void take_emission(const json& entry, SourceMaterial& material, GltfUvs& uvs) {
    const json& info = member(entry, "emissiveTexture");
    if (!info.is_object() || !material.base_color.head<3>().isZero(0)) return;
    material.base_texture = texture_of(info, material.name);
    if (!material.base_texture.is_there()) return;
    uvs = uvs_of(info, material.name);
    material.base_color.head<3>().setOnes();
    warn(model_.warnings, source_code::kClear,
         "material '{}': its base colour is black, and its texture '{}' shines; that is taken for the base colour: "
         "connect it to the base colour and export again",
         material.name, material.base_texture.path);
  }

  /// The image that a texture shows: one that every reader knows, or the WebP in its place.
  const json* image_of(const json& texture, const std::string& material) {
    for (const json* const source :
         {&member(texture, "source"), &member(gltf::extension(texture, "EXT_texture_webp"), "source")}) {
      if (const auto image = index_of(*source, images_.size())) return &images_[*image];
    }
    if (!member(gltf::extension(texture, "KHR_texture_basisu"), "source").is_null()) {
      warn(model_.warnings, source_code::kImages,
           "material '{}': its image is in KTX2 alone, which is not read; npx @gltf-transform/cli "
           "ktxdecompress OLD.glb NEW.glb makes it a PNG",
           material);
    } else if (!member(gltf::extension(texture, "EXT_texture_avif"), "source").is_null()) {
      warn(model_.warnings, source_code::kImages,
           "material '{}': its image is in AVIF alone, which is not read; npx @gltf-transform/cli png OLD.glb NEW.glb "
           "makes "
           "it a PNG",
           material);
    } else {
      warn(model_.warnings, source_code::kImages,
           "material '{}': it has a texture without an image that can be read; assign one and export again", material);
    }
    return nullptr;
  }

  SourceTexture texture_of(const json& info, const std::string& material) {
    SourceTexture out;
    if (!info.is_object()) return out;
    const auto texture = index_of(member(info, "index"), textures_.size());
    if (!texture) {
      warn(model_.warnings, source_code::kImages,
           "material '{}': it refers to texture {} of {}; assign its image and export again", material,
           excerpt(member(info, "index").dump(-1, ' ', true, json::error_handler_t::replace), 20), textures_.size());
      return out;
    }
    const json& samplers = list_of(member(document_, "samplers"));
    if (const auto sampler = index_of(member(textures_[*texture], "sampler"), samplers.size())) {
      out.wrap[0] = wrap_of(member(samplers[*sampler], "wrapS"));
      out.wrap[1] = wrap_of(member(samplers[*sampler], "wrapT"));
    }
    if (const json* const image = image_of(textures_[*texture], material)) read_image(*image, out);
    return out;
  }

  void read_image(const json& image, SourceTexture& out) {
    const json& uri = member(image, "uri");
    const auto number = std::uint32_t(&image - &images_[0]);
    const std::string name = printable_text_of(member(image, "name"));
    const bool is_data = uri.is_string() && uri.get_ref<const std::string&>().starts_with("data:");
    if (uri.is_string() && !is_data) {
      out.path = printable_text_of(uri);
      return;
    }
    out.path = name.empty() ? fmt::format("images[{}]", number) : name;
    const auto [known, is_new] = image_at_.emplace(number, kNoIndex);
    if (is_new) known->second = embed(image, uri, is_data, out.path);
    out.image = known->second;
  }

  std::uint32_t embed(const json& image, const json& uri, bool is_data, const std::string& name) {
    std::vector<std::uint8_t> bytes;
    if (is_data) {
      const auto decoded = gltf::bytes_of_data_uri(uri.get_ref<const std::string&>());
      if (!decoded) return reject(name, "its data: URI is damaged");
      const auto* const first = reinterpret_cast<const std::uint8_t*>(decoded->data());
      bytes.assign(first, first + decoded->size());
    } else {
      const auto view = buffers_.view(member(image, "bufferView"));
      if (!view) {
        fault_ = fmt::format("image '{}' {}", name, view.error());
        return kNoIndex;
      }
      const auto* const first = reinterpret_cast<const std::uint8_t*>(view->bytes.data());
      bytes.assign(first, first + view->bytes.size());
    }
    if (bytes.empty()) return reject(name, "it is empty");
    model_.images.push_back({name, std::move(bytes)});
    return static_cast<std::uint32_t>(model_.images.size() - 1);
  }

  std::uint32_t reject(const std::string& name, const char* why) {
    warn(model_.warnings, source_code::kImages, "embedded image '{}' left out: {}", name, why);
    return kNoIndex;
  }

  /// KHR_texture_transform: the UVs are scaled, turned against the clock as seen in the image, and moved.
  GltfUvs uvs_of(const json& info, const std::string& material) {
    GltfUvs out;
    const json& transform = gltf::extension(info, "KHR_texture_transform");
    const json& set =
        member(transform, "texCoord").is_null() ? member(info, "texCoord") : member(transform, "texCoord");
    out.set = index_of(set, 16).value_or(0);
    if (!transform.is_object()) return out;
    const Eigen::Vector2d offset = pair_of(member(transform, "offset"), 0),
                          scale = pair_of(member(transform, "scale"), 1);
    const double angle = number_of(member(transform, "rotation")).value_or(0);
    Eigen::Matrix2d turn;
    turn << std::cos(angle), std::sin(angle), -std::sin(angle), std::cos(angle);
    out.image_from_uv.linear() = (turn * scale.asDiagonal()).cast<float>();
    out.image_from_uv.translation() = offset.cast<float>();
    if (!out.image_from_uv.matrix().allFinite()) {
      warn(model_.warnings, source_code::kUvs, "material '{}': its texture transform is no number; none is applied",
           material);
      out.image_from_uv.setIdentity();
    }
    return out;
  }

  static Eigen::Vector2d pair_of(const json& value, double otherwise) {
    if (!value.is_array() || value.size() != 2) return Eigen::Vector2d::Constant(otherwise);
    return {number_of(value[0]).value_or(otherwise), number_of(value[1]).value_or(otherwise)};
  }

  /// One set of UVs is kept, the base colour's.
  void warn_of_other_uvs(const json& info, const GltfUvs& base, SourceMaterial& material) {
    if (!material.normal_texture.is_there() || !material.base_texture.is_there()) return;
    const GltfUvs own = uvs_of(info, material.name);
    if (own.set == base.set && own.image_from_uv.isApprox(base.image_from_uv, 1e-5f)) return;
    warn(model_.warnings, source_code::kUvs,
         "material '{}': its normal map is laid out otherwise than its base colour and is left out; bake both "
         "for one UV map",
         material.name);
    material.normal_texture = {};
  }

  void add_other_maps(const json& entry, const json& metallic, const json& specular, SourceMaterial& material) {
    const std::pair<const json*, const char*> maps[] = {
        {&member(entry, "occlusionTexture"), "occlusion"},
        {&member(specular, "specularGlossinessTexture"), "specular"},
        {&member(metallic, "metallicRoughnessTexture"), "metalness and roughness"},
        {&member(entry, "emissiveTexture"), "emission"}};
    for (const auto& [info, name] : maps) {
      const auto texture = index_of(member(*info, "index"), textures_.size());
      if (!texture) continue;
      const json& source = member(textures_[*texture], "source");
      const auto image = index_of(source, images_.size());
      if (!image) continue;
      std::string shown = printable_text_of(member(images_[*image], "name"));
      if (const json& uri = member(images_[*image], "uri");
          uri.is_string() && !uri.get_ref<const std::string&>().starts_with("data:")) {
        shown = printable_text_of(uri);
      }
      if (!shown.empty() && (shown == material.base_texture.path || shown == material.normal_texture.path)) continue;
      const std::string text = shown.empty() ? std::string(name) + " map" : fmt::format("{} map '{}'", name, shown);
      if (std::ranges::find(material.other_textures, text) == material.other_textures.end())
        material.other_textures.push_back(text);
    }
  }

  const json& document_;
  gltf::GltfBuffers& buffers_;
  SourceModel& model_;
  const json& textures_;
  const json& images_;
  std::map<std::uint32_t, std::uint32_t> image_at_;  // looked up only; its order reaches no output
  std::string fault_;
};

}  // namespace

tl::expected<std::vector<GltfUvs>, std::string> read_gltf_materials(const json& document, gltf::GltfBuffers& buffers,
                                                                    SourceModel& model) {
  std::vector<GltfUvs> uvs;
  std::string bad = MaterialReader(document, buffers, model).read(uvs);
  if (!bad.empty()) return tl::unexpected(std::move(bad));
  return uvs;
}

}  // namespace coif::importer
