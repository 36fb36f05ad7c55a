#include "validate/asset_checks.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace coif {
namespace {

constexpr float kOneTexel = 1e-6f;  // of the texture's side
constexpr float kDenseTexels = 40;  // to a millimetre
constexpr float kMillimetresPerMetre = 1000;

/// Of the finest level of detail.
bool is_unwrapped(const Asset& asset, const PatchRecord& patch) {
  float low[2] = {INFINITY, INFINITY}, high[2] = {-INFINITY, -INFINITY};
  for (const std::uint32_t corner : asset.indices().subspan(patch.first_index, patch.index_count)) {
    for (int k = 0; k < 2; ++k) {
      low[k] = std::min(low[k], asset.vertices()[corner].uv[k]);
      high[k] = std::max(high[k], asset.vertices()[corner].uv[k]);
    }
  }
  return high[0] - low[0] > kOneTexel || high[1] - low[1] > kOneTexel;
}

struct Areas {
  double surface = 0;  ///< Square metres.
  double texture = 0;  ///< Share of the texture, counted again where strips share texels.
};

Areas areas_of(const Asset& asset) {
  Areas areas;
  const auto corners = asset.lod_indices(0);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const VertexRecord& a = asset.vertices()[corners[i]];
    const VertexRecord& b = asset.vertices()[corners[i + 1]];
    const VertexRecord& c = asset.vertices()[corners[i + 2]];
    const auto side = [&a](const VertexRecord& to) {
      return Eigen::Vector3f(Eigen::Vector3f(to.position) - Eigen::Vector3f(a.position));
    };
    areas.surface += side(b).cross(side(c)).norm() / 2;
    areas.texture +=
        std::abs((b.uv[0] - a.uv[0]) * (c.uv[1] - a.uv[1]) - (c.uv[0] - a.uv[0]) * (b.uv[1] - a.uv[1])) / 2;
  }
  return areas;
}

}  // namespace

void check_unwrapping(const Asset& asset, Issues& issues) {
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr || asset.vertices().empty()) return;
  for (std::size_t i = 0; i < asset.lod_patches(0).size(); ++i) {
    if (is_unwrapped(asset, asset.lod_patches(0)[i])) continue;
    issues.push_back(patch_issue("A276", "all of it shows one texel: it is not unwrapped", i));
  }
  const Areas areas = areas_of(asset);
  if (!(areas.surface > 0)) return;
  const double texels = areas.texture * texture->width * texture->height;
  const double density = std::sqrt(texels / areas.surface) / kMillimetresPerMetre;
  if (density <= kDenseTexels) return;
  issues.push_back(
      make_issue("A275", fmt::format("{:.0f} texels to a millimetre of hair", density), "base colour texture"));
}

}  // namespace coif
