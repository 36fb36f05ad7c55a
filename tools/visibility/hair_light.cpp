#include "visibility/hair_light.h"

#include "base/color_texels.h"
#include "base/srgb.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif::visibility {
namespace {

constexpr int kEncodedSteps = 8192;

/// Indexed by the square root of a channel, which spreads the dark ones.
const std::array<float, kEncodedSteps + 1>& encoding() {
  static const auto table = [] {
    std::array<float, kEncodedSteps + 1> encoded{};
    for (int i = 0; i <= kEncodedSteps; ++i) {
      const double c = double(i) * i / (double(kEncodedSteps) * kEncodedSteps);
      encoded[std::size_t(i)] = float(coif::encode_srgb(c));
    }
    return encoded;
  }();
  return table;
}

const std::array<float, 256>& decoding() {
  static const auto table = [] {
    std::array<float, 256> linear{};
    for (int i = 0; i < 256; ++i) {
      linear[std::size_t(i)] = float(decode_srgb(i / 255.0));
    }
    return linear;
  }();
  return table;
}

float smoothstep(float x) {
  const float t = std::clamp(x, 0.0f, 1.0f);
  return t * t * (3 - 2 * t);
}

Eigen::Array3f array_of(const std::array<float, 3>& color) { return Eigen::Map<const Eigen::Array3f>(color.data()); }

float highlight(const Eigen::Vector3f& tangent, const Eigen::Vector3f& half, float exponent) {
  const float along = tangent.dot(half);
  const float across = std::sqrt(std::max(1 - along * along, 0.0f));
  return smoothstep(along + 1) * std::pow(across, exponent);
}

constexpr float kMeanMask = 0.5f;  ///< Value of the secondary highlight's mask, where a texture has one.

}  // namespace

ViewLights lights_in(const ViewAxes& view) {
  ViewLights lights;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    const auto& [right, up, back] = kStudioLights[i].towards;
    const Eigen::Vector3f towards = (view.right * right + view.up * up + view.back * back).normalized();
    lights[i] = {towards, (view.back + towards).normalized(), array_of(kStudioLights[i].color)};
  }
  return lights;
}

Eigen::Array3f encode_srgb(const Eigen::Array3f& linear) {
  Eigen::Array3f encoded;
  for (int k = 0; k < 3; ++k) {
    const float place = std::sqrt(std::clamp(linear[k], 0.0f, 1.0f)) * float(kEncodedSteps);
    encoded[k] = encoding()[std::size_t(place + 0.5f)];
  }
  return encoded;
}

ColorTexture::ColorTexture(const Asset& asset) {
  if (asset.material() != nullptr) {
    for (int k = 0; k < 3; ++k) factor_[k] = asset.material()->base_color[k];
  }
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr) return;
  for (std::uint32_t mip = 0; mip < texture->mip_count; ++mip) {
    Level level{int(std::max(1u, texture->width >> mip)), int(std::max(1u, texture->height >> mip)), {}};
    const auto texels = color_texels(asset, *texture, mip);
    for (std::size_t i = 0; i < texels.size(); ++i) {
      if (i % 4 != 3) level.rgb.push_back(std::to_integer<std::uint8_t>(texels[i]));
    }
    levels_.push_back(std::move(level));
  }
}

Eigen::Array3f ColorTexture::at(const Eigen::Vector2f& uv, const MipChoice& mip) const {
  if (levels_.empty()) return factor_;
  const Level& level = levels_[std::min<std::size_t>(levels_.size() - 1, mip.level + (mip.next > 0.5f ? 1 : 0))];
  const auto split = [](float place, int size) {
    const float texel = (place - std::floor(place)) * float(size) - 0.5f, first = std::floor(texel);
    const int index = (int(first) + size) % size;
    return std::tuple(index, (index + 1) % size, texel - first);
  };
  const auto [left, right, x] = split(uv.x(), level.width);
  const auto [upper, lower, y] = split(uv.y(), level.height);
  const auto texel = [&](int column, int row) -> Eigen::Array3f {
    const std::uint8_t* rgb = &level.rgb[3 * (std::size_t(row) * std::size_t(level.width) + std::size_t(column))];
    return {decoding()[rgb[0]], decoding()[rgb[1]], decoding()[rgb[2]]};
  };
  const Eigen::Array3f above = (1 - x) * texel(left, upper) + x * texel(right, upper);
  const Eigen::Array3f below = (1 - x) * texel(left, lower) + x * texel(right, lower);
  return factor_ * ((1 - y) * above + y * below);
}

HairLight::HairLight(const Asset& asset) : texture_(asset) {
  if (asset.material() != nullptr) material_ = *asset.material();
  constexpr float kUnit = 1.0f / 32767;
  for (const VertexRecord& v : asset.vertices()) {
    vertices_.push_back({Eigen::Vector3f(v.normal[0], v.normal[1], v.normal[2]) * kUnit,
                         Eigen::Vector3f(v.tangent[0], v.tangent[1], v.tangent[2]) * kUnit,
                         float(v.normal[3]) * kUnit});
  }
}

Eigen::Array3f HairLight::of_hair(const std::uint32_t (&corners)[3], const Eigen::Vector3f& share, bool is_front,
                                  const Eigen::Array3f& base, const ViewLights& lights) const {
  Vertex point{Eigen::Vector3f::Zero(), Eigen::Vector3f::Zero(), 0};
  for (int k = 0; k < 3; ++k) {
    const Vertex& corner = vertices_[corners[k]];
    point.normal += share[k] * corner.normal;
    point.tangent += share[k] * corner.tangent;
    point.openness += share[k] * corner.openness;
  }
  const Eigen::Vector3f normal = (is_front ? point.normal : Eigen::Vector3f(-point.normal)).normalized();
  const Eigen::Vector3f tangent = point.tangent.normalized();
  const bool shines = material_.shading == ShadingModel::kThesis;
  const Eigen::Vector3f first = (tangent + material_.primary_shift * normal).normalized();
  const Eigen::Vector3f second = (tangent + material_.secondary_shift * normal).normalized();
  const Eigen::Array3f primary = Eigen::Map<const Eigen::Array3f>(material_.primary_color);
  const Eigen::Array3f secondary = kMeanMask * Eigen::Map<const Eigen::Array3f>(material_.secondary_color);
  Eigen::Array3f sum = Eigen::Array3f::Zero();
  for (const ViewLight& light : lights) {
    const float diffuse = std::clamp(0.5f + 0.5f * normal.dot(light.towards), 0.0f, 1.0f);
    Eigen::Array3f reflected = Eigen::Array3f::Constant(diffuse);
    if (shines) {
      reflected += highlight(first, light.half, material_.primary_exponent) * primary +
                   highlight(second, light.half, material_.secondary_exponent) * secondary;
    }
    sum += light.color * reflected;
  }
  const Eigen::Array3f ambient = point.openness * Eigen::Map<const Eigen::Array3f>(material_.ambient);
  return base * (ambient + (1 - material_.light_cut) * sum);
}

Eigen::Array3f light_on_head(const Eigen::Vector3f& normal, const ViewLights& lights) {
  Eigen::Array3f sum = Eigen::Array3f::Constant(kClayAmbient);
  for (const ViewLight& light : lights) {
    sum += light.color * std::max((1 - kClayWrap) * normal.dot(light.towards) + kClayWrap, 0.0f);
  }
  return array_of(kClay) * sum;
}

Eigen::Array3f backdrop(float height) {
  const Eigen::Array3f bottom = array_of(kBackdropBottom), top = array_of(kBackdropTop);
  return bottom + smoothstep(height) * (top - bottom);
}

}  // namespace coif::visibility
