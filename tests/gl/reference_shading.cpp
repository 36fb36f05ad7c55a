#include "gl/reference_shading.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

using Eigen::Array3d;
using Eigen::Vector3d;

double decode(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }
double encode(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

double smoothstep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

double strand_specular(const Vector3d& tangent, const Vector3d& view, const Vector3d& light, double exponent) {
  const double t_dot_h = tangent.dot((view + light).normalized());
  return smoothstep(-1, 0, t_dot_h) * std::pow(std::sqrt(std::max(1 - t_dot_h * t_dot_h, 0.0)), exponent);
}

Array3d to_array(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

}  // namespace

std::array<int, 3> reference_color(const ShadedPoint& point, const Vector3d& eye, std::span<const Light> lights,
                                   const MaterialRecord& m, Component component) {
  const Vector3d view = (eye - point.position).normalized();
  const double shift = point.shift_mask[0] / 255.0 - 0.5;
  const double mask = point.shift_mask[1] / 255.0;
  const Vector3d t1 = (point.tangent + (m.primary_shift + shift) * point.normal).normalized();
  const Vector3d t2 = (point.tangent + (m.secondary_shift + shift) * point.normal).normalized();

  Array3d diffuse = Array3d::Zero(), primary = Array3d::Zero(), secondary = Array3d::Zero();
  for (const Light& light : lights) {
    Vector3d towards(light.position.x, light.position.y, light.position.z);
    Array3d color(light.color.x, light.color.y, light.color.z);
    if (light.kind == Light::Kind::kPoint) {
      towards -= point.position;
      color /= towards.squaredNorm();
    }
    towards.normalize();
    diffuse += std::clamp(0.5 + 0.5 * point.normal.dot(towards), 0.0, 1.0) * color;
    primary += strand_specular(t1, view, towards, m.primary_exponent) * to_array(m.primary_color) * color;
    secondary += strand_specular(t2, view, towards, m.secondary_exponent) * to_array(m.secondary_color) * mask * color;
  }

  Array3d sum = Array3d::Zero();
  const auto shows = [&](auto... wanted) { return ((component == wanted) || ...); };
  if (shows(Component::kAll, Component::kAmbient)) sum += to_array(m.ambient);
  if (shows(Component::kAll, Component::kDiffuse)) sum += diffuse;
  if (shows(Component::kAll, Component::kSpecular, Component::kPrimary)) sum += primary;
  if (shows(Component::kAll, Component::kSpecular, Component::kSecondary)) sum += secondary;

  std::array<int, 3> result{};
  for (int i = 0; i < 3; ++i) {
    const double base = decode(point.base_texel[std::size_t(i)] / 255.0) * m.base_color[i];
    result[std::size_t(i)] = static_cast<int>(std::lround(255 * encode(base * sum[i])));
  }
  return result;
}

}  // namespace coif
