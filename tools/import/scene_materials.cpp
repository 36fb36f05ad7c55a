#include "import/assimp_scene.h"
#include "import/scene_surface.h"
#include "import/source_warnings.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>
#include <assimp/scene.h>
#include <assimp/texture.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <map>
#include <set>

namespace coif::importer {
namespace {

// assimp's value where an OBJ gives no Kd, or its material file is missing.
constexpr float kObjFiller = 0.6f;

Eigen::Vector4f base_color(const aiMaterial& material, SourceFormat format, bool textured) {
  const Eigen::Vector4f white = Eigen::Vector4f::Ones();
  aiColor4D color(1, 1, 1, 1);
  const bool replaced = textured && format != SourceFormat::kObj;
  if (replaced || material.Get(AI_MATKEY_COLOR_DIFFUSE, color) != AI_SUCCESS) return white;
  if (format == SourceFormat::kObj && color.r == kObjFiller && color.g == kObjFiller && color.b == kObjFiller) {
    return white;
  }
  color.a = 1;
  const Eigen::Vector4f out(color.r, color.g, color.b, color.a);
  return out.allFinite() ? Eigen::Vector4f(out.cwiseMax(0.0f)) : white;
}

struct NamedMap {
  aiString path;  ///< Empty: none.
  aiTextureType type = aiTextureType_NONE;
};

NamedMap first_map(const aiMaterial& material, std::initializer_list<aiTextureType> types) {
  NamedMap map;
  for (const aiTextureType type : types) {
    if (material.GetTexture(type, 0, &map.path) == AI_SUCCESS && map.path.length != 0) return {map.path, type};
  }
  return {};
}

/// Exporters write a material without light as one that emits; its colour is the emission.
NamedMap base_map(const aiMaterial& material) {
  const NamedMap base = first_map(material, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE});
  return base.path.length != 0 ? base : first_map(material, {aiTextureType_EMISSION_COLOR, aiTextureType_EMISSIVE});
}

// Exporters write either kind of map under several names; the texels decide which it is.
aiString normal_texture_path(const aiMaterial& material) {
  aiString path;
  for (const aiTextureType type : {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA, aiTextureType_HEIGHT}) {
    if (material.GetTexture(type, 0, &path) == AI_SUCCESS && path.length != 0) return path;
  }
  return aiString();
}

// Files without a sensible number show the map as it is painted.
float normal_strength(const aiMaterial& material) {
  float strength = 1;
  const bool is_given = material.Get(AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0), strength) == AI_SUCCESS ||
                        material.Get(AI_MATKEY_BUMPSCALING, strength) == AI_SUCCESS;
  return is_given && strength >= 0 && strength <= kMostNormalStrength ? strength : 1;
}

// Empty where it is the base colour's own, as exporters write it for an image with alpha.
aiString opacity_path(const aiMaterial& material, const aiString& base) {
  aiString path;
  if (material.GetTexture(aiTextureType_OPACITY, 0, &path) != AI_SUCCESS || path == base) return aiString();
  return path;
}

struct MapKind {
  aiTextureType type;
  const char* name;
};

// Maps that are ignored: the effect of light on hair is computed from its form and the recipe's numbers.
constexpr MapKind kOtherMaps[] = {{aiTextureType_AMBIENT_OCCLUSION, "occlusion"},
                                  {aiTextureType_LIGHTMAP, "occlusion"},
                                  {aiTextureType_AMBIENT, "ambient"},
                                  {aiTextureType_METALNESS, "metalness"},
                                  {aiTextureType_DIFFUSE_ROUGHNESS, "roughness"},
                                  {aiTextureType_SPECULAR, "specular"},
                                  {aiTextureType_SHININESS, "gloss"},
                                  {aiTextureType_UNKNOWN, "metalness and roughness"},
                                  {aiTextureType_DISPLACEMENT, "displacement"},
                                  {aiTextureType_EMISSIVE, "emission"},
                                  {aiTextureType_EMISSION_COLOR, "emission"}};

// A separate texture for opacity is the only sign that exporters agree on. They write roughness in scales of their own,
// or not at all.
void convert_alpha(const aiMaterial& material, SourceMaterial& out) {
  if (material.GetTextureCount(aiTextureType_OPACITY) != 0) out.alpha_use = AlphaUse::kBlend;
}

class TextureTable {
 public:
  TextureTable(const aiScene& scene, SourceModel& model) : scene_(scene), model_(model) {}

  SourceTexture find(const aiString& path) {
    SourceTexture out;
    out.path = text_of(path);
    const aiTexture* texture = path.length == 0 ? nullptr : scene_.GetEmbeddedTexture(path.C_Str());
    if (texture == nullptr) {
      if (out.path.starts_with('*')) out.path.clear();  // assimp's mark for "embedded", but nothing is
      return out;
    }
    // "*0" means nothing to the artist; the image's own name does.
    if (out.path.starts_with('*') && texture->mFilename.length != 0) out.path = text_of(texture->mFilename);
    out.image = image_of(*texture, out.path);
    return out;
  }

 private:
  std::uint32_t image_of(const aiTexture& texture, const std::string& name) {
    const auto known = image_of_.find(&texture);
    if (known != image_of_.end()) return known->second;
    std::uint32_t image = kNoIndex;
    if (texture.mHeight != 0 || texture.mWidth == 0 || texture.pcData == nullptr) {
      warn(model_.warnings, source_code::kImages, "embedded image '{}' left out: not PNG, JPEG or TGA", name);
    } else {
      // For encoded images mWidth is the size in bytes.
      const auto* first = reinterpret_cast<const std::uint8_t*>(texture.pcData);
      image = static_cast<std::uint32_t>(model_.images.size());
      model_.images.push_back({name, std::vector<std::uint8_t>(first, first + texture.mWidth)});
    }
    image_of_.emplace(&texture, image);
    return image;
  }

  const aiScene& scene_;
  SourceModel& model_;
  std::map<const aiTexture*, std::uint32_t> image_of_;  // looked up only; its order reaches no output
};

}  // namespace

namespace {

void add_other_maps(const aiMaterial& material, const aiString& base, TextureTable& textures, SourceMaterial& out) {
  for (const auto& [type, name] : kOtherMaps) {
    aiString path;
    if (material.GetTexture(type, 0, &path) != AI_SUCCESS || path.length == 0 || path == base) continue;
    const std::string image = textures.find(path).path;
    const std::string text = image.empty() ? std::string(name) + " map" : fmt::format("{} map '{}'", name, image);
    const bool is_new = std::ranges::find(out.other_textures, text) == out.other_textures.end();
    if (is_new && image != out.normal_texture.path) out.other_textures.push_back(text);
  }
}

}  // namespace

std::vector<std::string> named_images(const aiScene& scene) {
  std::set<std::string> names;
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial& material = *scene.mMaterials[i];
    for (int type = aiTextureType_NONE + 1; type <= AI_TEXTURE_TYPE_MAX; ++type) {
      aiString path;
      for (unsigned k = 0; material.GetTexture(aiTextureType(type), k, &path) == AI_SUCCESS; ++k) {
        if (scene.GetEmbeddedTexture(path.C_Str()) == nullptr) names.insert(text_of(path));
      }
    }
  }
  std::erase_if(names, [](const std::string& name) { return name.empty() || name.starts_with('*'); });
  return {names.begin(), names.end()};
}

void convert_materials(const aiScene& scene, SourceFormat format, SourceModel& model) {
  TextureTable textures(scene, model);
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    const aiMaterial& material = *scene.mMaterials[i];
    const NamedMap base = base_map(material);
    const aiString& path = base.path;
    SourceMaterial out;
    aiString name;
    if (material.Get(AI_MATKEY_NAME, name) == AI_SUCCESS) out.name = text_of(name);
    out.base_texture = textures.find(path);
    read_wrap(material, base.type, out.base_texture);
    out.normal_texture = textures.find(normal_texture_path(material));
    out.normal_strength = normal_strength(material);
    out.opacity_texture = textures.find(opacity_path(material, path));
    read_wrap(material, aiTextureType_OPACITY, out.opacity_texture);
    add_other_maps(material, path, textures, out);
    out.base_color = base_color(material, format, path.length != 0);
    if (base.type == aiTextureType_EMISSION_COLOR || base.type == aiTextureType_EMISSIVE) {
      out.base_color.setOnes();
      warn(model.warnings, source_code::kClear,
           "material '{}': only its light has a texture, '{}', which is taken for the base colour: connect it to the "
           "base "
           "(diffuse) colour and export again",
           out.name, out.base_texture.path);
    }
    convert_alpha(material, out);
    int two_sided = 0;
    out.double_sided = material.Get(AI_MATKEY_TWOSIDED, two_sided) == AI_SUCCESS && two_sided != 0;
    model.materials.push_back(std::move(out));
  }
}

}  // namespace coif::importer
