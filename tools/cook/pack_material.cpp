#include "cook/pack_material.h"

#include "cook/furnace_bound.h"
#include "shading_names.h"

#include <algorithm>
#include <numbers>

namespace coif {
namespace {

constexpr double kRadians = std::numbers::pi / 180;

template <std::size_t kCount>
void store(const std::array<double, kCount>& value, float (&out)[kCount]) {
  for (std::size_t k = 0; k < kCount; ++k) out[k] = float(value[k]);
}

/// After the colours, from which the cut follows.
void pack_shading(const Recipe& recipe, MaterialRecord& record) {
  record.shading = shading_model(recipe.shading).value_or(ShadingModel::kThesis);
  record.tilt = float(recipe.tilt * kRadians);
  record.roughness = float(recipe.roughness * kRadians);
  record.scatter = float(recipe.scatter);
  if (recipe.energy == "bounded") record.light_cut = bounding_cut(record);
}

}  // namespace

MaterialRecord pack_material(const BaseColor& color, const BakedTextures& textures, const HairMesh& hair,
                             const Recipe& recipe) {
  constexpr double kMostShift = 10;  // that an asset holds
  MaterialRecord record{};
  store(recipe.base_color, record.base_color);
  store(recipe.ambient, record.ambient);
  store(recipe.primary_color, record.primary_color);
  store(recipe.secondary_color, record.secondary_color);
  record.primary_exponent = float(recipe.primary_exponent);
  record.secondary_exponent = float(recipe.secondary_exponent);
  // What the shader adds and multiplies where it reads a texture (shaders/shading.glsl).
  const double shift = textures.constant_shift - 0.5;
  record.primary_shift = float(std::clamp(recipe.primary_shift + shift, -kMostShift, kMostShift));
  record.secondary_shift = float(std::clamp(recipe.secondary_shift + shift, -kMostShift, kMostShift));
  for (float& c : record.secondary_color) c *= float(textures.constant_mask);
  record.opaque_threshold = float(textures.transparency.opaque_threshold);
  record.discard_threshold = float(textures.transparency.discard_threshold);
  const bool both = recipe.sides == "both" || (recipe.sides == "auto" && hair.double_sided);
  if (both) record.flags |= kMaterialDoubleSided;
  for (int k = 0; k < 4; ++k) record.base_color[k] *= color.factor[k];
  pack_shading(recipe, record);
  return record;
}

}  // namespace coif
