#include "gl/draw_block.h"

#include <cmath>
#include <cstddef>

namespace coif {
namespace {

/// World from head space. Double, because the head's position in a large world is.
struct Frame {
  double axis[3][3];  // axis[i]: head space's i-th axis in the world
  double origin[3];
};

bool is_finite(const Vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <std::size_t N>
bool is_finite(const float (&values)[N]) {
  for (float value : values) {
    if (!std::isfinite(value)) return false;
  }
  return true;
}

bool is_valid(const HeadPose& pose) {
  constexpr double kUnitTolerance = 2e-3;  // of the squared length; Hair::set_head() takes the same
  const double x = pose.rotation.x, y = pose.rotation.y, z = pose.rotation.z, w = pose.rotation.w;
  const double square = x * x + y * y + z * z + w * w;
  return std::isfinite(pose.position[0]) && std::isfinite(pose.position[1]) && std::isfinite(pose.position[2]) &&
         std::fabs(square - 1.0) < kUnitTolerance;
}

bool is_share(float value) { return value >= 0.0f && value <= 1.0f; }

Frame frame_of(const HeadPose& pose) {
  const double x = pose.rotation.x, y = pose.rotation.y, z = pose.rotation.z, w = pose.rotation.w;
  const double s = 2.0 / (x * x + y * y + z * z + w * w);
  return {{{1 - s * (y * y + z * z), s * (x * y + w * z), s * (x * z - w * y)},
           {s * (x * y - w * z), 1 - s * (x * x + z * z), s * (y * z + w * x)},
           {s * (x * z + w * y), s * (y * z - w * x), 1 - s * (x * x + y * y)}},
          {pose.position[0], pose.position[1], pose.position[2]}};
}

void direction_to_head(const Frame& frame, const double (&world)[3], float* out) {
  for (int i = 0; i < 3; ++i) {
    out[i] =
        static_cast<float>(frame.axis[i][0] * world[0] + frame.axis[i][1] * world[1] + frame.axis[i][2] * world[2]);
  }
}

void point_to_head(const Frame& frame, const Vec3& world, float* out) {
  const double offset[3] = {world.x - frame.origin[0], world.y - frame.origin[1], world.z - frame.origin[2]};
  direction_to_head(frame, offset, out);
}

void fill_clip_from_head(const float (&clip)[16], const Frame& frame, float (&out)[16]) {
  for (int row = 0; row < 4; ++row) {
    const double x = clip[row], y = clip[4 + row], z = clip[8 + row], w = clip[12 + row];
    for (int i = 0; i < 3; ++i) {
      out[4 * i + row] = static_cast<float>(x * frame.axis[i][0] + y * frame.axis[i][1] + z * frame.axis[i][2]);
    }
    out[12 + row] = static_cast<float>(x * frame.origin[0] + y * frame.origin[1] + z * frame.origin[2] + w);
  }
}

bool fill_light(const Light& light, const Frame& frame, float* position, float* color) {
  if (!is_finite(light.position) || !is_finite(light.color)) return false;
  if (light.kind == Light::Kind::kPoint) {
    point_to_head(frame, light.position, position);
    position[3] = 1.0f;
  } else {
    const double x = light.position.x, y = light.position.y, z = light.position.z;
    const double length = std::sqrt(x * x + y * y + z * z);
    if (!(length > 0.0)) return false;
    direction_to_head(frame, {x / length, y / length, z / length}, position);
    position[3] = 0.0f;
  }
  color[0] = light.color.x;
  color[1] = light.color.y;
  color[2] = light.color.z;
  return true;
}

void fill_rgb_and(const float (&rgb)[3], float last, float (&out)[4]) {
  for (int i = 0; i < 3; ++i) out[i] = rgb[i];
  out[3] = last;
}

void fill_component(Component component, float (&out)[4]) {
  const bool all = component == Component::kAll;
  const bool specular = all || component == Component::kSpecular;
  out[0] = all || component == Component::kAmbient ? 1.0f : 0.0f;
  out[1] = all || component == Component::kDiffuse ? 1.0f : 0.0f;
  out[2] = specular || component == Component::kPrimary ? 1.0f : 0.0f;
  out[3] = specular || component == Component::kSecondary ? 1.0f : 0.0f;
}

}  // namespace

// Negated so that NaN fails; an exponent of zero would ask the shader for pow(0, 0).
bool is_valid(const MaterialRecord& m) {
  return is_finite(m.base_color) && is_finite(m.ambient) && is_finite(m.primary_color) &&
         is_finite(m.secondary_color) && std::isfinite(m.primary_shift) && std::isfinite(m.secondary_shift) &&
         std::isfinite(m.primary_exponent) && m.primary_exponent > 0.0f && std::isfinite(m.secondary_exponent) &&
         m.secondary_exponent > 0.0f && is_share(m.opaque_threshold) && is_share(m.discard_threshold);
}

Status fill_draw_block(const DrawDesc& desc, const MaterialRecord& material, DrawBlock& block) {
  if (!is_valid(desc.head)) return Status::kBadPose;
  if (!is_finite(desc.clip_from_world) || !is_finite(desc.eye) || !is_valid(material)) return Status::kBadArgument;
  if (desc.lights.size() > kMaxLights || desc.component > Component::kDirection) return Status::kBadArgument;

  block = {};
  const Frame frame = frame_of(desc.head);
  fill_clip_from_head(desc.clip_from_world, frame, block.clip_from_head);
  point_to_head(frame, desc.eye, block.eye);
  for (int i = 0; i < 4; ++i) block.base_color[i] = material.base_color[i];
  fill_rgb_and(material.ambient, 0.0f, block.ambient);
  fill_rgb_and(material.primary_color, material.primary_exponent, block.primary);
  fill_rgb_and(material.secondary_color, material.secondary_exponent, block.secondary);
  block.shift[0] = material.primary_shift;
  block.shift[1] = material.secondary_shift;
  block.shift[2] = desc.framebuffer_is_srgb ? 0.0f : 1.0f;
  block.shift[3] = static_cast<float>(desc.lights.size());
  fill_component(desc.component, block.component);
  for (std::size_t i = 0; i < desc.lights.size(); ++i) {
    if (!fill_light(desc.lights[i], frame, block.light_position[i], block.light_color[i])) return Status::kBadArgument;
  }
  return Status::kOk;
}

}  // namespace coif
