#include "import/scene_surface.h"

#include "base/srgb.h"
#include "import/assimp_scene.h"
#include "import/source_warnings.h"

#include <assimp/material.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace coif::importer {
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

bool is_usable(const aiUVTransform& moved) {
  const Eigen::Vector2f scale(moved.mScaling.x, moved.mScaling.y), offset(moved.mTranslation.x, moved.mTranslation.y);
  return scale.allFinite() && offset.allFinite() && std::isfinite(moved.mRotation) && (scale.array() != 0).all() &&
         scale.cwiseAbs().minCoeff() > 1e-6f;
}

/// COLLADA moves the coordinates over the texture.
void place_over_texture(const aiUVTransform& moved, TexturePlace& place) {
  place.linear = Eigen::Rotation2Df(moved.mRotation).toRotationMatrix() *
                 Eigen::Vector2f(moved.mScaling.x, moved.mScaling.y).asDiagonal();
  place.offset = Eigen::Vector2f(moved.mTranslation.x, moved.mTranslation.y);
}

bool is_by_blender(const SourceSurface& surface) { return surface.generator.find("Blender") != std::string::npos; }

/// FBX moves the texture over the surface, so that a scale of 2 shows half of it, and turns in degrees. Blender inverts
/// only the scale, adds the offset directly, and turns in radians.
void place_on_surface(const FbxTexturePlace& moved, const SourceSurface& surface, TexturePlace& place) {
  constexpr double kDegree = std::numbers::pi / 180;
  const Eigen::Vector2d scale(moved.scaling), offset(moved.translation);
  const Eigen::Translation2d scale_pivot(Eigen::Vector2d(moved.scaling_pivot)),
      rotation_pivot(Eigen::Vector2d(moved.rotation_pivot));
  const Eigen::Rotation2Dd turn(is_by_blender(surface) ? moved.degrees : moved.degrees * kDegree);
  Eigen::Affine2d uv_from_texture(rotation_pivot);
  uv_from_texture = uv_from_texture * turn * rotation_pivot.inverse() * scale_pivot *
                    Eigen::Affine2d(Eigen::Matrix2d(scale.asDiagonal())) * scale_pivot.inverse();
  if (!is_by_blender(surface)) uv_from_texture.pretranslate(offset);
  const Eigen::Affine2d texture_from_uv = uv_from_texture.inverse(Eigen::Affine);
  if (!texture_from_uv.matrix().allFinite()) return;
  place.linear = texture_from_uv.linear().cast<float>();
  if (moved.swaps_axes) place.linear = place.linear.rowwise().reverse().eval();
  place.offset = texture_from_uv.translation().cast<float>();
  if (is_by_blender(surface)) place.offset += offset.cast<float>();
}

/// The placement that assimp reports for an FBX's texture.
FbxTexturePlace place_by_assimp(const aiUVTransform& moved) {
  return {.scaling = {double(moved.mScaling.x), double(moved.mScaling.y)},
          .degrees = double(moved.mRotation),
          .translation = {double(moved.mTranslation.x), double(moved.mTranslation.y)}};
}

TexturePlace stated_place(const aiMaterial& material, aiTextureType type, const std::string& geometry,
                          const SourceSurface& surface) {
  TexturePlace place;
  place.uv_set = stated_uv_set(material, type, geometry, surface);
  aiUVTransform moved;
  const bool is_moved = material.Get(AI_MATKEY_UVTRANSFORM(type, 0), moved) == AI_SUCCESS;
  if (surface.format != SourceFormat::kFbx) {
    if (is_moved && is_usable(moved)) place_over_texture(moved, place);
    return place;
  }
  aiString name, path;
  material.Get(AI_MATKEY_NAME, name);
  const bool is_named = material.GetTexture(type, 0, &path) == AI_SUCCESS;
  const FbxTexturePlace* const stated =
      surface.fbx != nullptr && is_named ? surface.fbx->find(text_of(name), text_of(path)) : nullptr;
  if (stated != nullptr) {
    place_on_surface(*stated, surface, place);
  } else if (is_moved && is_usable(moved)) {
    place_on_surface(place_by_assimp(moved), surface, place);
  }
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

/// Some programs write an OBJ's colours as whole numbers up to 255. No screen shows colours that are that much brighter
/// than white.
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
                           const std::string& label, Diagnostics& warnings) {
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

}  // namespace coif::importer
