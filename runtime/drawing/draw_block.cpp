#include <coif/drawing.h>
#include <coif/shading_models.h>

#include <cmath>

namespace coif {
namespace {

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <std::size_t N>
bool is_finite(const float (&values)[N]) {
  for (float value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

bool is_share(float value) { return value >= 0.0f && value <= 1.0f; }

void fill_clip_from_view(const float (&clip)[16], const Vec3& eye, float (&out)[16]) {
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 3; ++column) out[4 * column + row] = clip[4 * column + row];
    const double moved = double(clip[row]) * eye.x + double(clip[4 + row]) * eye.y + double(clip[8 + row]) * eye.z;
    out[12 + row] = static_cast<float>(moved + clip[12 + row]);
  }
}

/// Writes the unit vector; false for a vector without direction.
bool fill_direction(const Vec3& v, float* out) {
  const double length = std::sqrt(double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z);
  if (!(length > 0.0)) return false;
  out[0] = static_cast<float>(v.x / length);
  out[1] = static_cast<float>(v.y / length);
  out[2] = static_cast<float>(v.z / length);
  return true;
}

/// A light that is not a spot gets a cone that contains everything.
bool fill_cone(const Light& light, float* spot, float& sharpness) {
  spot[3] = -2.0f;
  sharpness = 1.0f;
  if (light.kind != Light::Kind::kSpot) return true;
  const bool is_cone = light.outer_cosine >= -1.0f && light.inner_cosine <= 1.0f &&
                       light.outer_cosine < light.inner_cosine && is_finite(light.spot_axis);
  if (!is_cone || !fill_direction(light.spot_axis, spot)) return false;
  spot[3] = light.outer_cosine;
  sharpness = 1.0f / (light.inner_cosine - light.outer_cosine);
  return true;
}

bool fill_light(const Light& light, const Vec3& eye, std::size_t i, DrawBlock& block) {
  if (!is_finite(light.from) || !is_finite(light.color) || light.kind > Light::Kind::kSpot) return false;
  float* const position = block.light_position[i];
  if (light.kind == Light::Kind::kDirectional) {
    if (!fill_direction(light.from, position)) return false;
  } else {
    position[0] = static_cast<float>(double(light.from.x) - eye.x);
    position[1] = static_cast<float>(double(light.from.y) - eye.y);
    position[2] = static_cast<float>(double(light.from.z) - eye.z);
    position[3] = 1.0f;
  }
  float* const color = block.light_color[i];
  color[0] = light.color.x;
  color[1] = light.color.y;
  color[2] = light.color.z;
  return fill_cone(light, block.light_spot[i], color[3]);
}

/// A harmonic's own factor, times what a matte surface keeps of its degree: 1, 2/3, 1/4.
constexpr float kSkyFactors[SkyLight::kHarmonics] = {0.282095f,        0.488603f / 1.5f, 0.488603f / 1.5f,
                                                     0.488603f / 1.5f, 1.092548f / 4,    1.092548f / 4,
                                                     0.315392f / 4,    1.092548f / 4,    0.546274f / 4};

bool fill_sky(const SkyLight& sky, DrawBlock& block) {
  for (std::uint32_t i = 0; i < SkyLight::kHarmonics; ++i) {
    const Vec3& harmonic = sky.harmonics[i];
    if (!is_finite(harmonic)) return false;
    block.sky[i][0] = kSkyFactors[i] * harmonic.x;
    block.sky[i][1] = kSkyFactors[i] * harmonic.y;
    block.sky[i][2] = kSkyFactors[i] * harmonic.z;
  }
  block.sky[0][3] = 1.0f;
  return true;
}

void fill_rgb_and(const float (&rgb)[3], float last, float (&out)[4]) {
  for (int i = 0; i < 3; ++i) out[i] = rgb[i];
  out[3] = last;
}

void fill_component(Component component, float lights, float (&out)[4]) {
  const bool all = component == Component::kAll;
  const bool specular = all || component == Component::kSpecular;
  out[0] = all || component == Component::kAmbient ? 1.0f : 0.0f;
  out[1] = all || component == Component::kDiffuse ? lights : 0.0f;
  out[2] = specular || component == Component::kPrimary ? lights : 0.0f;
  out[3] = specular || component == Component::kSecondary ? lights : 0.0f;
}

}  // namespace

// Negated so that NaN fails. An exponent of zero would make the shader compute pow(0, 0).
bool is_valid(const MaterialRecord& m) {
  return is_finite(m.base_color) && is_finite(m.ambient) && is_finite(m.primary_color) &&
         is_finite(m.secondary_color) && std::isfinite(m.primary_shift) && std::isfinite(m.secondary_shift) &&
         std::isfinite(m.primary_exponent) && m.primary_exponent > 0.0f && std::isfinite(m.secondary_exponent) &&
         m.secondary_exponent > 0.0f && is_share(m.opaque_threshold) && is_share(m.discard_threshold) &&
         is_shading_valid(m);
}

Status fill_draw_block(const DrawView& view, const MaterialRecord& material, std::uint32_t rows_of_head,
                       DrawBlock& block) {
  if (!is_finite(view.clip_from_world) || !is_finite(view.eye) || !is_valid(material)) return Status::kBadArgument;
  if (view.lights.size() > kMaxLights || view.component > Component::kDirection) return Status::kBadArgument;

  block = {};
  fill_clip_from_view(view.clip_from_world, view.eye, block.clip_from_view);
  for (int i = 0; i < 4; ++i) block.base_color[i] = material.base_color[i];
  fill_rgb_and(material.ambient, static_cast<float>(rows_of_head), block.ambient);
  fill_rgb_and(material.primary_color, material.primary_exponent, block.primary);
  fill_rgb_and(material.secondary_color, material.secondary_exponent, block.secondary);
  block.shift[0] = material.primary_shift;
  block.shift[1] = material.secondary_shift;
  block.shift[2] = view.framebuffer_is_srgb ? 0.0f : 1.0f;
  block.shift[3] = static_cast<float>(view.lights.size());
  fill_component(view.component, 1.0f - material.light_cut, block.component);
  block.fiber[0] = material.tilt;
  block.fiber[1] = material.roughness;
  block.fiber[2] = material.scatter;
  block.strands[0] = material.glow;
  block.strands[1] = material.root_shade;
  block.strands[2] = material.variation;
  for (std::size_t i = 0; i < view.lights.size(); ++i) {
    if (!fill_light(view.lights[i], view.eye, i, block)) return Status::kBadArgument;
  }
  if (view.sky != nullptr && !fill_sky(*view.sky, block)) return Status::kBadArgument;
  return Status::kOk;
}

}  // namespace coif
