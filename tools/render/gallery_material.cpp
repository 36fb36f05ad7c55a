#include "render/gallery_material.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace coif {
namespace {

constexpr double kMaxColor = 1000;  // of a material: formats/SPECIFICATION.md

double linear(std::byte srgb) {
  const double value = std::to_integer<int>(srgb) / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

MaterialRecord first_gallery() {
  MaterialRecord material{};
  std::fill_n(material.base_color, 4, 1.0f);
  std::fill_n(material.ambient, 3, 0.1f);
  std::fill_n(material.primary_color, 3, 0.5f);
  std::fill_n(material.secondary_color, 3, 0.4f);
  material.opaque_threshold = 0.85f;
  material.primary_exponent = 150;
  material.secondary_exponent = 30;
  material.primary_shift = 0.7f;
  material.secondary_shift = 0.5f;
  material.discard_threshold = 0.02f;
  material.flags = kMaterialDoubleSided;
  return material;
}

}  // namespace

MaterialRecord thesis_material(const Asset& asset) {
  MaterialRecord material = asset.material() != nullptr ? *asset.material() : first_gallery();
  material.shading = ShadingModel::kThesis;
  return material;
}

Eigen::Vector3d mean_base_color(const Asset& asset) {
  const TextureRecord* const texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr) return Eigen::Vector3d::Ones();
  const std::span<const std::byte> texels = asset.texels(*texture, 0);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double weight = 0;
  for (std::size_t i = 0; i + 3 < texels.size(); i += 4) {
    const double alpha = std::to_integer<int>(texels[i + 3]);
    sum += alpha * Eigen::Vector3d(linear(texels[i]), linear(texels[i + 1]), linear(texels[i + 2]));
    weight += alpha;
  }
  if (weight == 0) return Eigen::Vector3d::Ones();
  return sum / weight;
}

MaterialRecord dyed_material(const Asset& asset, const Eigen::Vector3d& color) {
  MaterialRecord material = thesis_material(asset);
  const Eigen::Vector3d mean = mean_base_color(asset);
  for (int channel = 0; channel < 3; ++channel) {
    const double factor = color[channel] / std::max(mean[channel], 1e-4);
    material.base_color[channel] = float(std::min(factor, kMaxColor));
  }
  return material;
}

}  // namespace coif
