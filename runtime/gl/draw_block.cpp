#include "gl/draw_block.h"

#include <cmath>
#include <cstddef>

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

/// Unit; false for no direction.
bool fill_direction(const Vec3& v, float* out) {
  const double length = std::sqrt(double(v.x) * v.x + double(v.y) * v.y + double(v.z) * v.z);
  if (!(length > 0.0)) return false;
  out[0] = static_cast<float>(v.x / length);
  out[1] = static_cast<float>(v.y / length);
  out[2] = static_cast<float>(v.z / length);
  return true;
}

/// A light that is no spot gets a cone that everything is in.
bool fill_cone(const Light& light, float* spot, float& sharpness) {
  spot[3] = -2.0f;
  sharpness = 1.0f;
  if (light.kind != Light::Kind::kSpot) return true;
  const bool is_cone = light.outer_cosine >= -1.0f && light.inner_cosine <= 1.0f &&
                       light.outer_cosine < light.inner_cosine && is_finite(light.direction);
  if (!is_cone || !fill_direction(light.direction, spot)) return false;
  spot[3] = light.outer_cosine;
  sharpness = 1.0f / (light.inner_cosine - light.outer_cosine);
  return true;
}

bool fill_light(const Light& light, const Vec3& eye, std::size_t i, DrawBlock& block) {
  if (!is_finite(light.position) || !is_finite(light.color) || light.kind > Light::Kind::kSpot) return false;
  float* const position = block.light_position[i];
  if (light.kind == Light::Kind::kDirectional) {
    if (!fill_direction(light.position, position)) return false;
  } else {
    position[0] = static_cast<float>(double(light.position.x) - eye.x);
    position[1] = static_cast<float>(double(light.position.y) - eye.y);
    position[2] = static_cast<float>(double(light.position.z) - eye.z);
    position[3] = 1.0f;
  }
  float* const color = block.light_color[i];
  color[0] = light.color.x;
  color[1] = light.color.y;
  color[2] = light.color.z;
  return fill_cone(light, block.light_spot[i], color[3]);
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

bool is_shading_valid(const MaterialRecord& m) {
  const float least_roughness = m.shading == ShadingModel::kMarschner ? kLeastRoughness : 0.0f;
  return m.shading <= ShadingModel::kMarschner && m.tilt >= -kMostTilt && m.tilt <= kMostTilt &&
         m.roughness >= least_roughness && m.roughness <= kMostRoughness && is_share(m.scatter) &&
         is_share(m.light_cut);
}

// Negated so that NaN fails; an exponent of zero would ask the shader for pow(0, 0).
bool is_valid(const MaterialRecord& m) {
  return is_finite(m.base_color) && is_finite(m.ambient) && is_finite(m.primary_color) &&
         is_finite(m.secondary_color) && std::isfinite(m.primary_shift) && std::isfinite(m.secondary_shift) &&
         std::isfinite(m.primary_exponent) && m.primary_exponent > 0.0f && std::isfinite(m.secondary_exponent) &&
         m.secondary_exponent > 0.0f && is_share(m.opaque_threshold) && is_share(m.discard_threshold) &&
         is_shading_valid(m);
}

bool is_valid(const HeadPose& pose) {
  constexpr double kUnitTolerance = 2e-3;  // of the squared length; Hair::set_head() takes the same
  const double x = pose.rotation.x, y = pose.rotation.y, z = pose.rotation.z, w = pose.rotation.w;
  const double square = x * x + y * y + z * z + w * w;
  return std::isfinite(pose.position[0]) && std::isfinite(pose.position[1]) && std::isfinite(pose.position[2]) &&
         std::fabs(square - 1.0) < kUnitTolerance;
}

HeadMatrix head_matrix(const HeadPose& pose, const Vec3& eye) {
  const double x = pose.rotation.x, y = pose.rotation.y, z = pose.rotation.z, w = pose.rotation.w;
  const double s = 2.0 / (x * x + y * y + z * z + w * w);
  const auto f = [](double value) { return static_cast<float>(value); };
  return {{{f(1 - s * (y * y + z * z)), f(s * (x * y - w * z)), f(s * (x * z + w * y)), f(pose.position[0] - eye.x)},
           {f(s * (x * y + w * z)), f(1 - s * (x * x + z * z)), f(s * (y * z - w * x)), f(pose.position[1] - eye.y)},
           {f(s * (x * z - w * y)), f(s * (y * z + w * x)), f(1 - s * (x * x + y * y)), f(pose.position[2] - eye.z)}}};
}

Status fill_draw_block(const DrawDesc& desc, const MaterialRecord& material, std::uint32_t rows_of_head,
                       DrawBlock& block) {
  if (!is_finite(desc.clip_from_world) || !is_finite(desc.eye) || !is_valid(material)) return Status::kBadArgument;
  if (desc.lights.size() > kMaxLights || desc.component > Component::kDirection) return Status::kBadArgument;

  block = {};
  fill_clip_from_view(desc.clip_from_world, desc.eye, block.clip_from_view);
  for (int i = 0; i < 4; ++i) block.base_color[i] = material.base_color[i];
  fill_rgb_and(material.ambient, static_cast<float>(rows_of_head), block.ambient);
  fill_rgb_and(material.primary_color, material.primary_exponent, block.primary);
  fill_rgb_and(material.secondary_color, material.secondary_exponent, block.secondary);
  block.shift[0] = material.primary_shift;
  block.shift[1] = material.secondary_shift;
  block.shift[2] = desc.framebuffer_is_srgb ? 0.0f : 1.0f;
  block.shift[3] = static_cast<float>(desc.lights.size());
  fill_component(desc.component, 1.0f - material.light_cut, block.component);
  block.fiber[0] = material.tilt;
  block.fiber[1] = material.roughness;
  block.fiber[2] = material.scatter;
  for (std::size_t i = 0; i < desc.lights.size(); ++i) {
    if (!fill_light(desc.lights[i], desc.eye, i, block)) return Status::kBadArgument;
  }
  return Status::kOk;
}

}  // namespace coif
