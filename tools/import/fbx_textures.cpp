#include "import/assimp_scene.h"

#include "import/fbx_objects.h"
#include "import/scene_surface.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace coif::importer {
namespace {

std::string file_name(std::string_view path) {
  const std::string text = printable_text(path);
  const std::size_t slash = text.find_last_of("/\\");
  return slash == std::string::npos ? text : text.substr(slash + 1);
}

/// By the names of the material and of the image file. Among several the first counts.
using MaterialTextures = std::map<std::pair<std::string, std::string>, const FbxObject*>;

MaterialTextures material_textures(const FbxObjects& objects) {
  MaterialTextures out;
  for (const FbxObject& material : objects.all()) {
    if (material.kind != FbxKind::kMaterial) continue;
    for (const FbxConnection& connection : objects.on_properties(material.id)) {
      for (const FbxObject* const texture : textures_of(objects, connection.from))
        out.emplace(std::pair(printable_text(material.name), file_name(texture->file)), texture);
    }
  }
  return out;
}

}  // namespace

void apply_fbx_wraps(const FbxObjects& objects, std::span<SourceMaterial> materials) {
  const MaterialTextures textures = material_textures(objects);
  for (SourceMaterial& material : materials) {
    for (SourceTexture* const texture : {&material.base_texture, &material.opacity_texture}) {
      const auto found = textures.find({material.name, file_name(texture->path)});
      if (!texture->is_there() || found == textures.end()) continue;
      for (int axis = 0; axis < 2; ++axis) {
        texture->wrap[axis] = found->second->is_clamped[axis] ? TextureWrap::kClamp : TextureWrap::kRepeat;
      }
    }
  }
}

FbxTexturePlaces::FbxTexturePlaces(const FbxObjects& objects) {
  for (const auto& [names, texture] : material_textures(objects)) places_.emplace(names, texture->place);
}

const FbxTexturePlace* FbxTexturePlaces::find(const std::string& material, const std::string& file) const {
  const auto found = places_.find({material, file_name(file)});
  return found == places_.end() ? nullptr : &found->second;
}

}  // namespace coif::importer
