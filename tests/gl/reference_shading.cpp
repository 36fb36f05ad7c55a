#include "gl/reference_shading.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace coif {
namespace {

using Eigen::Array3d;
using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;

double decode(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }
double encode(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  return c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
}

double smoothstep(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

Array3d to_array(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

Array3d base_color(const ShadedPoint& point, const MaterialRecord& m) {
  Array3d base;
  for (int i = 0; i < 3; ++i) base[i] = decode(point.base_texel[std::size_t(i)] / 255.0) * m.base_color[i];
  return base;
}

double shift_of(const ShadedPoint& point) { return point.shift_mask[0] / 255.0 - 0.5; }
double mask_of(const ShadedPoint& point) { return point.shift_mask[1] / 255.0; }

Vector3d shifted(const ShadedPoint& point, double amount) {
  return (point.tangent + amount * point.normal).normalized();
}

double thesis_lobe(const Vector3d& tangent, const Vector3d& view, const Vector3d& light, double exponent) {
  const double t_dot_h = tangent.dot((view + light).normalized());
  return smoothstep(-1, 0, t_dot_h) * std::pow(std::sqrt(std::max(1 - t_dot_h * t_dot_h, 0.0)), exponent);
}

ReflectedLight thesis(const ShadedPoint& point, const Vector3d& view, const Vector3d& light, const MaterialRecord& m) {
  const Array3d base = base_color(point, m);
  const Vector3d t1 = shifted(point, m.primary_shift + shift_of(point));
  const Vector3d t2 = shifted(point, m.secondary_shift + shift_of(point));
  return {base * std::clamp(0.5 + 0.5 * point.normal.dot(light), 0.0, 1.0),
          base * thesis_lobe(t1, view, light, m.primary_exponent) * to_array(m.primary_color),
          base * thesis_lobe(t2, view, light, m.secondary_exponent) * to_array(m.secondary_color) * mask_of(point)};
}

double angle(const Vector3d& a, const Vector3d& b) { return std::acos(std::clamp(a.dot(b), -1.0, 1.0)); }

/// In angles, where the shader has sines and cosines.
ReflectedLight kajiya_kay(const ShadedPoint& point, const Vector3d& view, const Vector3d& light,
                          const MaterialRecord& m) {
  const Array3d base = base_color(point, m);
  const Vector3d t = shifted(point, shift_of(point));
  const double from_cone = kPi - angle(t, light) - angle(t, view);
  const double lobe = std::pow(std::max(std::cos(from_cone), 0.0), m.primary_exponent);
  return {base * std::sin(angle(point.tangent, light)), base * lobe * to_array(m.primary_color), Array3d::Zero()};
}

double fresnel(double cosine) {
  const double normal = std::pow(0.55 / 2.55, 2);
  return normal + (1 - normal) * std::pow(1 - std::clamp(cosine, 0.0, 1.0), 5);
}

double bell(double x, double width) { return std::exp(-x * x / (2 * width * width)) / (width * std::sqrt(2 * kPi)); }

ReflectedLight marschner(const ShadedPoint& point, const Vector3d& view, const Vector3d& light,
                         const MaterialRecord& m) {
  const Array3d base = base_color(point, m).min(1.0);
  const Vector3d t = shifted(point, shift_of(point));
  const double theta_l = kPi / 2 - angle(t, light), theta_v = kPi / 2 - angle(t, view);
  const double phi = angle((light - t.dot(light) * t).normalized(), (view - t.dot(view) * t).normalized());
  const double cos_d = std::cos((theta_l - theta_v) / 2);
  const double along = std::sin(theta_l) + std::sin(theta_v);

  const double r =
      bell(along + 2 * m.tilt, m.roughness) * std::cos(phi / 2) / 4 * fresnel(std::cos(angle(light, view) / 2));

  const double sin_d = std::sin((theta_l - theta_v) / 2);
  const double bent = std::sqrt(1.55 * 1.55 - sin_d * sin_d) / cos_d;
  const double h = std::min(std::cos(phi / 2) * (1 + (0.6 - 0.8 * std::cos(phi)) / bent), 1.0);
  const double f_tt = fresnel(cos_d * std::sqrt(1 - h * h));
  const double path = std::sqrt(1 - h * h / (bent * bent)) / (2 * cos_d);
  const Array3d tt = bell(along - m.tilt, m.roughness / 2) * std::exp(-3.65 * std::cos(phi) - 3.98) * (1 - f_tt) *
                     (1 - f_tt) * base.pow(path);

  const double f = fresnel(cos_d / 2);
  const Array3d trt = bell(along - 4 * m.tilt, 2 * m.roughness) * std::exp(17 * std::cos(phi) - 16.78) * (1 - f) *
                      (1 - f) * f * base.pow(0.8 / cos_d);

  const double n_dot_l = point.normal.dot(light);
  const Array3d scattered = (1 - f) * (1 - f) * std::clamp((n_dot_l + 0.5) / 2.25, 0.0, 1.0) * base;
  const double lit = std::clamp(1 + 2 * n_dot_l, 0.0, 1.0);
  return {lit * ((1 - m.scatter) * kPi * tt + double(m.scatter) * scattered), Array3d::Constant(lit * kPi * r),
          lit * kPi * trt * mask_of(point)};
}

/// A fibre's own share of the mean light of its place, by its number in the texture.
double share_of_depth(const ShadedPoint& point, double ratio) {
  const double apart = std::min(1.4 * ratio / std::sqrt(1 + 2 * ratio), 1.0);
  return 1 + apart * std::clamp(shift_of(point) / 0.36, -1.0, 1.0);
}

/// In angles, where the shader has sines and cosines; the constants are those of shaders/SHADING.md.
ReflectedLight volume(const ShadedPoint& point, const Vector3d& view, const Vector3d& light, const MaterialRecord& m) {
  const Array3d base = base_color(point, m).max(0.002).min(0.95);
  const Vector3d t = shifted(point, 0.2 * shift_of(point));
  const double w = m.roughness, tilt = m.tilt;
  const double theta_l = kPi / 2 - angle(t, light), theta_v = kPi / 2 - angle(t, view);
  const double phi = angle((light - t.dot(light) * t).normalized(), (view - t.dot(view) * t).normalized());
  const auto rounded = [](double cosine) { return (cosine + std::hypot(cosine, 0.06)) / 2; };
  const double in_l = rounded(point.normal.dot(light)), in_v = std::hypot(point.normal.dot(view), 0.03);
  const double along = std::sin(theta_l) + std::sin(theta_v);
  const double off = 1 - std::cos((theta_l - theta_v) / 2);
  const double inner = std::sqrt(1 - std::pow(std::sin((theta_l - theta_v) / 2) / 1.55, 2));
  const Array3d loss = (base.log() / 5.509).square() / inner;
  const double mirrored = 0.075 + 0.42 * off * off, enters = (1 - mirrored) * (1 - mirrored);
  const double lit = std::cos(theta_l) * in_v / in_l;
  const double once = kPi / std::max(std::cos(theta_v) + lit, 0.25),
               often = kPi / (std::max(std::cos(theta_v), 0.7) + lit);

  const double r = bell(along + 2 * tilt, w) * mirrored / (2 * kPi);
  const Array3d tt = bell(along - tilt, w / 2) * enters * bell(kPi - phi, 0.73 + 0.47 * off) * (-1.86 * loss).exp();
  const Array3d trt = bell(along - 4 * tilt, 2 * w) * enters * 0.87 * mirrored * bell(phi, 0.506) * (-3.6 * loss).exp();

  const double mean = base.mean(), steep = 0.5 + 2.3 * std::pow(mean, 0.75);
  const double apart = 0.45 * (std::cos(theta_l) + std::cos(theta_v));
  const double wander = std::hypot(w * 1.3 * (1 + std::pow(mean, 0.7)), apart);
  const double cone =
      0.86 * bell(along + 0.05 + 0.4 * mean, wander) + 0.14 * 0.45 * std::cos(theta_l) * std::cos(theta_v);
  const auto leaves = [&](double in, double theta) {
    return (1 + steep * std::min(in / std::cos(theta), 1.0)) / (1 + steep);
  };
  const double more = 3.6 * leaves(in_l, theta_l) * leaves(in_v, theta_v) * cone / kPi;
  const double sharp = once * share_of_depth(point, lit / std::max(std::cos(theta_v), 0.25));
  const double soft =
      often * share_of_depth(point, 0.55 * (1 - std::sqrt(mean)) * lit / std::max(std::cos(theta_v), 0.7));
  return {sharp * tt + soft * more * base, Array3d::Constant(sharp * r), sharp * trt * mask_of(point)};
}

/// Light from everywhere, as kVolume shows it.
Array3d volume_sky(const ShadedPoint& point, const Vector3d& view, const MaterialRecord& m) {
  const Array3d base = base_color(point, m).max(0.002).min(0.95), dark = 1 - base;
  const double in_v = std::hypot(point.normal.dot(view), 0.03);
  const double leaving = in_v / std::sqrt(std::max(1 - std::pow(point.tangent.dot(view), 2), 0.04));
  const double grazing = std::pow(std::max(1 - leaving, 0.0), 1.5);
  return share_of_depth(point, 0.6 * (1 - std::sqrt(base.mean()))) *
         (base + dark * (0.013 * dark + (0.11 + 0.7 * grazing) * base.sqrt()));
}

/// Unit, and how much of its colour arrives.
Vector3d reaching(const Light& light, const Vector3d& position, double& share) {
  Vector3d towards(light.from.x, light.from.y, light.from.z);
  share = 1;
  if (light.kind == Light::Kind::kDirectional) return towards.normalized();
  towards -= position;
  share = 1 / towards.squaredNorm();
  towards.normalize();
  if (light.kind == Light::Kind::kSpot) {
    const Vector3d axis = Vector3d(light.spot_axis.x, light.spot_axis.y, light.spot_axis.z).normalized();
    const double edge = double(light.inner_cosine) - light.outer_cosine;
    const double inside = std::clamp((axis.dot(-towards) - light.outer_cosine) / edge, 0.0, 1.0);
    share *= inside * inside;
  }
  return towards;
}

}  // namespace

ReflectedLight reference_reflection(const ShadedPoint& point, const Vector3d& view, const Vector3d& towards,
                                    const MaterialRecord& material) {
  const auto model = material.shading == ShadingModel::kThesis      ? thesis
                     : material.shading == ShadingModel::kKajiyaKay ? kajiya_kay
                     : material.shading == ShadingModel::kMarschner ? marschner
                                                                    : volume;
  ReflectedLight light = model(point, view, towards, material);
  for (Array3d* part : {&light.diffuse, &light.primary, &light.secondary}) *part *= 1.0 - material.light_cut;
  return light;
}

std::array<int, 3> reference_color(const ShadedPoint& point, const Vector3d& eye, std::span<const Light> lights,
                                   const MaterialRecord& m, Component component) {
  const Vector3d view = (eye - point.position).normalized();
  const auto shows = [&](auto... wanted) { return ((component == wanted) || ...); };
  Array3d sum = Array3d::Zero();
  if (shows(Component::kAll, Component::kAmbient)) {
    const bool is_volume = m.shading == ShadingModel::kVolume;
    sum += to_array(m.ambient) * (is_volume ? volume_sky(point, view, m) : base_color(point, m));
  }
  for (const Light& light : lights) {
    double share = 1;
    const Vector3d towards = reaching(light, point.position, share);
    const ReflectedLight part = reference_reflection(point, view, towards, m);
    const Array3d color = share * Array3d(light.color.x, light.color.y, light.color.z);
    if (shows(Component::kAll, Component::kDiffuse)) sum += part.diffuse * color;
    if (shows(Component::kAll, Component::kSpecular, Component::kPrimary)) sum += part.primary * color;
    if (shows(Component::kAll, Component::kSpecular, Component::kSecondary)) sum += part.secondary * color;
  }
  std::array<int, 3> result{};
  for (int i = 0; i < 3; ++i) result[std::size_t(i)] = static_cast<int>(std::lround(255 * encode(sum[i])));
  return result;
}

}  // namespace coif
