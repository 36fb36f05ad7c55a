#include "base/geometry.h"
#include "base/hair_runtime.h"
#include "cook/pack/pack.h"
#include "cook/recipe/drawn_recipe.h"

#include <coif/version.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

namespace coif::cook {
namespace {

template <std::size_t kCount>
void store(const std::array<double, kCount>& value, float (&out)[kCount]) {
  for (std::size_t k = 0; k < kCount; ++k) out[k] = float(value[k]);
}

constexpr double kFiberRoughness = 8;    ///< Degrees.
constexpr double kVolumeRoughness = 17;  ///< Degrees: fibres of roughness 0.3 (Chiang et al. 2016).

/// After the colours, from which the cut follows.
void pack_shading(const DrawnRecipe& recipe, MaterialRecord& record) {
  record.shading = shading_model(recipe.shading).value_or(ShadingModel::kThesis);
  record.tilt = float(recipe.tilt * kDegree);
  const bool is_volume = record.shading == ShadingModel::kVolume;
  record.roughness = float(recipe.roughness.value_or(is_volume ? kVolumeRoughness : kFiberRoughness) * kDegree);
  record.scatter = float(recipe.scatter);
  record.glow = float(recipe.glow);
  record.root_shade = float(recipe.root_shade);
  record.variation = float(recipe.variation);
  if (recipe.energy == ShadingEnergy::kBounded) record.light_cut = bounding_cut(record);
}

}  // namespace

MaterialRecord pack_material(const BaseColor& color, const BakedTextures& textures, const HairMesh& hair,
                             const DrawnRecipe& recipe) {
  constexpr double kMostShift = 10;  // The largest value in an asset.
  MaterialRecord record{};
  store(recipe.base_color, record.base_color);
  store(recipe.ambient, record.ambient);
  store(recipe.primary_color, record.primary_color);
  store(recipe.secondary_color, record.secondary_color);
  record.primary_exponent = float(recipe.primary_exponent);
  record.secondary_exponent = float(recipe.secondary_exponent);
  // The offset and factor of the shader where it reads a texture (shaders/shading.glsl).
  const double shift = textures.constant_shift - 0.5;
  record.primary_shift = float(std::clamp(recipe.primary_shift + shift, -kMostShift, kMostShift));
  record.secondary_shift = float(std::clamp(recipe.secondary_shift + shift, -kMostShift, kMostShift));
  for (float& c : record.secondary_color) c *= float(textures.constant_mask);
  record.opaque_threshold = float(textures.transparency.opaque_threshold);
  record.discard_threshold = float(textures.transparency.discard_threshold);
  const bool both = recipe.sides == Sides::kBoth || (recipe.sides == Sides::kAuto && hair.double_sided);
  if (both) record.flags |= kMaterialDoubleSided;
  for (int k = 0; k < 4; ++k) record.base_color[k] *= color.factor[k];
  pack_shading(recipe, record);
  return record;
}

namespace {

constexpr double kPi = std::numbers::pi;

/// Integral of sin^n over half a turn.
double sine_integral(double n) {
  return std::sqrt(kPi) * std::exp(std::lgamma(0.5 * (n + 1)) - std::lgamma(0.5 * n + 1));
}

// Over the half vector, dL = 4 (V.H) dH; a view across the strand sees most of the lobe.
double thesis_lobe(double exponent) { return 8 / kPi * sine_integral(exponent + 2); }

double mirror_cone_lobe(double exponent) { return 2 * sine_integral(exponent + 1); }

double thesis_bound(const MaterialRecord& m, int channel) {
  return double(m.base_color[channel]) * (2 + double(m.primary_color[channel]) * thesis_lobe(m.primary_exponent) +
                                          double(m.secondary_color[channel]) * thesis_lobe(m.secondary_exponent));
}

double kajiya_kay_bound(const MaterialRecord& m, int channel) {
  return double(m.base_color[channel]) *
         (kPi + double(m.primary_color[channel]) * mirror_cone_lobe(m.primary_exponent));
}

/// A fibre parts the light that it gets, whatever its colour.
double marschner_bound(const MaterialRecord&, int) { return 1; }

/// White hair that is seen nearly along itself and from its edge, where the fit is least good: furnace_test.
double volume_bound(const MaterialRecord&, int) { return 1.7; }

/// The bound of what lights add in one channel, in the order of ShadingModel.
constexpr double (*kBounds[])(const MaterialRecord& material, int channel) = {thesis_bound, kajiya_kay_bound,
                                                                              marschner_bound, volume_bound};
static_assert(std::size(kBounds) == kShadingModelCount);

}  // namespace

double furnace_bound(const MaterialRecord& material) {
  // Light from all of the hemisphere behind, times the cube of its cosine to the eye, over pi.
  constexpr double kGlowBound = 0.5;
  double most = 0;
  for (int k = 0; k < 3; ++k) {
    const double glow = kGlowBound * double(material.glow) * double(material.base_color[k]);
    most = std::max(most, kBounds[std::size_t(material.shading)](material, k) + glow);
  }
  return most * (1 + double(material.variation));
}

float bounding_cut(const MaterialRecord& material) { return float(1 - 1 / std::max(1.0, furnace_bound(material))); }

ProvenanceRecord make_provenance(const importer::SourceModel& source, std::uint64_t recipe_hash,
                                 std::uint64_t source_hash) {
  ProvenanceRecord record{};
  record.source_hash = source_hash;
  record.recipe_hash = recipe_hash;
  record.tool_version[0] = COIF_VERSION_MAJOR;
  record.tool_version[1] = COIF_VERSION_MINOR;
  record.tool_version[2] = COIF_VERSION_PATCH;
  std::copy_n(source.importer_version, 3, record.importer_version);
  return record;
}

}  // namespace coif::cook
