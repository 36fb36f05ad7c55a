#include "import/assimp_scene.h"

#include "import/fbx_objects.h"
#include "import/source_warnings.h"

#include <assimp/material.h>
#include <assimp/scene.h>

#include <algorithm>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace coif::importer {
namespace {

// Programs' names for the properties of their materials: the last part, without "file", in lower case and without
// underscores.
constexpr std::string_view kColorProperties[] = {"diffusecolor", "diffuse",      "diffusemap",  "diffusetexture",
                                                 "basecolor",    "basecolormap", "texcolormap", "color",
                                                 "colormap",     "albedo",       "albedomap",   "maincolor"};
constexpr std::string_view kOpacityProperties[] = {
    "transparentcolor", "transparencyfactor", "transparency",    "transparencymap",
    "opacity",          "opacitymap",         "texopacitymap",   "cutout",
    "cutoutmap",        "cutoutopacity",      "geometryopacity", "alpha",
    "alphamap"};

/// The part of "3dsMax|Parameters|cutout_map" or "Maya|opacity|file" behind the last bar that matters.
std::string property_name(std::string_view property) {
  constexpr std::string_view kFile = "|file";
  if (property.ends_with(kFile)) property.remove_suffix(kFile.size());
  if (const std::size_t bar = property.rfind('|'); bar != std::string_view::npos) property.remove_prefix(bar + 1);
  std::string name = lower_case(std::string(property));
  std::erase(name, '_');
  return name;
}

struct FbxMap {
  const FbxObject* texture = nullptr;  ///< The first layer; null: none.
  std::size_t layers = 0;
};

/// The first property, in the order of the list, that is connected to a texture.
FbxMap find_map(const FbxObjects& objects, const FbxObject& material, std::span<const std::string_view> properties) {
  for (const std::string_view wanted : properties) {
    for (const FbxConnection& connection : objects.on_properties(material.id)) {
      if (property_name(connection.property) != wanted) continue;
      const std::vector<const FbxObject*> layers = textures_of(objects, connection.from);
      if (!layers.empty() && !layers.front()->file.empty()) return {layers.front(), layers.size()};
    }
  }
  return {};
}

/// The index of the UV set with this name in the meshes that have the material.
unsigned uv_set_called(const aiScene& scene, unsigned material, std::string_view name) {
  for (const aiMesh* const mesh : std::span(scene.mMeshes, scene.mNumMeshes)) {
    if (mesh->mMaterialIndex != material || name.empty()) continue;
    for (unsigned set = 0; set < AI_MAX_NUMBER_OF_TEXTURECOORDS; ++set) {
      const aiString* const called = mesh->GetTextureCoordsName(set);
      if (called != nullptr && name == called->C_Str()) return set;
    }
  }
  return 0;
}

bool has_texture(const aiMaterial& material, std::span<const aiTextureType> types) {
  return std::ranges::any_of(types, [&](aiTextureType type) {
    aiString path;
    return material.GetTexture(type, 0, &path) == AI_SUCCESS && path.length != 0;
  });
}

void connect(const FbxMap& map, unsigned index, aiTextureType type, const aiScene& scene) {
  aiMaterial& material = *scene.mMaterials[index];
  const aiString path{std::string(map.texture->file)};
  const int uv_set = int(uv_set_called(scene, index, map.texture->uv_set));
  material.AddProperty(&path, AI_MATKEY_TEXTURE(type, 0));
  material.AddProperty(&uv_set, 1, AI_MATKEY_UVWSRC(type, 0));
}

void warn_of_layers(const FbxMap& map, const std::string& material, const char* what, Diagnostics& warnings) {
  if (map.layers < 2) return;
  warn(warnings, source_code::kImages,
       "material '{}': its {} is made of {} layers of textures, of which '{}' alone is read; bake them into one image "
       "and export again",
       material, what, map.layers, printable_text(map.texture->file, 100));
}

}  // namespace

void connect_fbx_textures(const FbxObjects& objects, const aiScene& scene, Diagnostics& warnings) {
  constexpr aiTextureType kColor[] = {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE};
  constexpr aiTextureType kOpacity[] = {aiTextureType_OPACITY};
  std::map<std::string, const FbxObject*> named;  // Among several the first.
  for (const FbxObject& object : objects.all()) {
    if (object.kind == FbxKind::kMaterial) named.emplace(printable_text(object.name), &object);
  }
  for (unsigned i = 0; i < scene.mNumMaterials; ++i) {
    aiString name;
    scene.mMaterials[i]->Get(AI_MATKEY_NAME, name);
    const auto found = named.find(text_of(name));
    if (found == named.end()) continue;
    const FbxMap color = find_map(objects, *found->second, kColorProperties);
    const FbxMap opacity = find_map(objects, *found->second, kOpacityProperties);
    if (color.texture != nullptr && !has_texture(*scene.mMaterials[i], kColor))
      connect(color, i, aiTextureType_DIFFUSE, scene);
    if (opacity.texture != nullptr && !has_texture(*scene.mMaterials[i], kOpacity))
      connect(opacity, i, aiTextureType_OPACITY, scene);
    warn_of_layers(color, text_of(name), "colour", warnings);
    warn_of_layers(opacity, text_of(name), "opacity", warnings);
  }
}

}  // namespace coif::importer
