#include "import/scene_surface.h"

#include "base/srgb.h"
#include "import/assimp_scene.h"
#include "import/source_warnings.h"

#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace coif {
namespace {

std::optional<aiTextureType> first_type(const aiMaterial& material, std::span<const aiTextureType> types) {
  const auto* const found = std::ranges::find_if(types.data(), types.data() + types.size(), [&](aiTextureType type) {
    aiString path;
    return material.GetTexture(type, 0, &path) == AI_SUCCESS && path.length != 0;
  });
  return found == types.data() + types.size() ? std::nullopt : std::optional(*found);
}

unsigned stated_uv_set(const aiMaterial& material, aiTextureType type, const std::string& geometry,
                       const SourceSurface& surface) {
  if (surface.collada != nullptr) {
    aiString name;
    material.Get(AI_MATKEY_NAME, name);
    const auto use = type == aiTextureType_OPACITY ? ColladaTextures::Use::kOpacity : ColladaTextures::Use::kBase;
    if (const auto bound = surface.collada->uv_set(geometry, text_of(name), use)) return *bound;
  }
  int uv_set = 0;
  return material.Get(AI_MATKEY_UVWSRC(type, 0), uv_set) == AI_SUCCESS && uv_set > 0 ? unsigned(uv_set) : 0;
}

/// COLLADA moves the coordinates over the texture. FBX moves the texture over the surface, so that a scale of 2 shows half of it; but
/// Blender undoes the scale alone and adds the offset as it is.
TexturePlace stated_place(const aiMaterial& material, aiTextureType type, const std::string& geometry,
                          const SourceSurface& surface) {
  TexturePlace place;
  place.uv_set = stated_uv_set(material, type, geometry, surface);
  aiUVTransform moved;
  if (material.Get(AI_MATKEY_UVTRANSFORM(type, 0), moved) != AI_SUCCESS) return place;
  const Eigen::Vector2f scale(moved.mScaling.x, moved.mScaling.y), offset(moved.mTranslation.x, moved.mTranslation.y);
  const bool is_usable = scale.allFinite() && offset.allFinite() && std::isfinite(moved.mRotation) &&
                         (scale.array() != 0).all() && scale.cwiseAbs().minCoeff() > 1e-6f;
  if (!is_usable) return place;
  if (surface.format != SourceFormat::kFbx) {
    place.linear = Eigen::Rotation2Df(moved.mRotation).toRotationMatrix() * scale.asDiagonal();
    place.offset = offset;
    return place;
  }
  const Eigen::Rotation2Df turned_back(-moved.mRotation);
  const Eigen::Vector2f shrunk = scale.cwiseInverse();
  place.linear = shrunk.asDiagonal() * turned_back.toRotationMatrix();
  place.offset =
      surface.generator.find("Blender") != std::string::npos ? offset : Eigen::Vector2f(-(place.linear * offset));
  return place;
}

TextureWrap wrap_of(const aiMaterial& material, const char* key, unsigned type) {
  int mode = aiTextureMapMode_Wrap;
  if (material.Get(key, type, 0, mode) != AI_SUCCESS) return TextureWrap::kRepeat;
  if (mode == aiTextureMapMode_Mirror) return TextureWrap::kMirror;
  // A decal is nothing outside; its edge, which is clear where that matters, is nearest to it.
  return mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? TextureWrap::kClamp : TextureWrap::kRepeat;
}

float linear_of(float stored) { return stored <= 1 ? float(decode_srgb(double(stored))) : stored; }

/// Some programs write colours of an OBJ as whole numbers up to 255: no screen shows what is that much brighter than white.
bool are_bytes(std::span<const aiColor4D> colors) {
  constexpr float kMostOfLight = 2;
  bool is_bright = false;
  for (const aiColor4D& color : colors) {
    for (const float number : {color.r, color.g, color.b}) {
      if (!(number >= 0 && number <= 255) || number != std::floor(number)) return false;
      is_bright = is_bright || number > kMostOfLight;
    }
  }
  return is_bright;
}

}  // namespace

TexturePlace texture_place(const aiMaterial& material, const std::string& geometry, const SourceSurface& surface,
                           const std::string& label, std::vector<Warning>& warnings) {
  constexpr aiTextureType kBase[] = {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE, aiTextureType_EMISSION_COLOR,
                                     aiTextureType_EMISSIVE};
  constexpr aiTextureType kOpacity[] = {aiTextureType_OPACITY};
  const auto base = first_type(material, kBase), opacity = first_type(material, kOpacity);
  if (!base && !opacity) return {};
  const TexturePlace place = stated_place(material, base ? *base : *opacity, geometry, surface);
  if (base && opacity && !(stated_place(material, *opacity, geometry, surface) == place)) {
    warn(warnings, source_code::kUvs,
         "{}: its opacity texture has other texture coordinates than its base texture, whose are taken for "
         "both; give both the same UV map and mapping, and export again",
         label);
  }
  return place;
}

void read_wrap(const aiMaterial& material, unsigned type, SourceTexture& texture) {
  texture.wrap[0] = wrap_of(material, _AI_MATKEY_MAPPINGMODE_U_BASE, type);
  texture.wrap[1] = wrap_of(material, _AI_MATKEY_MAPPINGMODE_V_BASE, type);
}

std::vector<Eigen::Vector4f> vertex_colors(const aiMesh& mesh) {
  std::vector<Eigen::Vector4f> colors;
  if (!mesh.HasVertexColors(0)) return colors;
  const std::span all(mesh.mColors[0], mesh.mNumVertices);
  const float unit = are_bytes(all) ? 255 : 1;
  for (const aiColor4D& given : all) {
    const float alpha = given.a > 1 ? given.a / unit : given.a;
    colors.emplace_back(linear_of(given.r / unit), linear_of(given.g / unit), linear_of(given.b / unit), alpha);
  }
  return colors;
}

}  // namespace coif
