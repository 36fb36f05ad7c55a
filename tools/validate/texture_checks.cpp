#include "base/color_texels.h"
#include "cook/texture/alpha.h"
#include "validate/asset_checks.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

namespace coif::validate {
namespace {

constexpr double kAll = 0.9995;
constexpr double kThin = 0.75;            // Share of the largest mip's coverage.
constexpr std::uint32_t kFewTexels = 16;  // a side: hair so far away is hardly seen

const char* place(TextureRole role) {
  switch (role) {
    case TextureRole::kBaseColor: return "base colour texture";
    case TextureRole::kShiftMask: return "shift and mask texture";
    case TextureRole::kNormal: return "map of normals";
    case TextureRole::kStrandAxis: return "map of strands";
  }
  return "texture";
}

/// Some used texel has an alpha that neither passes as solid nor as nothing.
bool has_soft_texels(const Asset& asset, const TextureRecord& texture) {
  const auto texels = color_texels(asset, texture, 0);
  for (std::size_t i = 3; i < texels.size(); i += 4) {
    const auto alpha = std::to_integer<int>(texels[i]);
    if (alpha > 16 && alpha < 239) return true;
  }
  return false;
}

void find_thin_mips(const TextureRecord& texture, std::span<const cook::AlphaCoverage> coverage, Diagnostics& issues) {
  for (std::uint32_t mip = 1; mip < coverage.size(); ++mip) {
    if (std::min(texture.width, texture.height) >> mip < kFewTexels) return;
    const double share = coverage[mip].opacity / coverage[0].opacity;
    if (share >= kThin) continue;
    add_issue(issues, "A277", place(texture.role), "mip {} covers {:.0f} % of what the texture does", mip, 100 * share);
  }
}

void check_size(const TextureRecord& texture, Diagnostics& issues) {
  const std::string size = fmt::format("{} x {} texels", texture.width, texture.height);
  if (!std::has_single_bit(texture.width) || !std::has_single_bit(texture.height)) {
    add_issue(issues, "A271", place(texture.role), "{} are no powers of two", size);
  }
  const auto all = std::uint32_t(std::bit_width(std::max(texture.width, texture.height)));
  if (texture.mip_count >= all) return;
  add_issue(issues, "A272", place(texture.role), "{} of the {} mips of {}", texture.mip_count, all, size);
}

}  // namespace

void check_textures(const Asset& asset, Diagnostics& issues) {
  if (!asset.vertices().empty() && asset.texture(TextureRole::kBaseColor) == nullptr) {
    add_issue(issues, "A204", "", "no base colour texture: strips are drawn as solid cards");
  }
  for (const auto& textures : {asset.textures(), asset.reliefs()}) {
    for (const TextureRecord& texture : textures) check_size(texture, issues);
  }
}

void check_alpha(const Asset& asset, Diagnostics& issues) {
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  const std::vector<cook::AlphaCoverage> coverage = cook::mip_coverage(asset);
  if (texture == nullptr || coverage.empty()) return;
  const char* where = place(texture->role);
  if (coverage.front().opacity <= 0) {
    add_issue(issues, "A274", where,
              "no texel that the hair uses is above the threshold that discards: nothing is drawn");
  } else if (coverage.front().opaque >= kAll) {
    add_issue(issues, "A273", where, "every texel that the hair uses is opaque: strips are drawn as solid cards");
  }
  if (coverage.front().opacity > 0) find_thin_mips(*texture, coverage, issues);
  if (blends(*asset.material()) || !has_soft_texels(asset, *texture)) return;
  add_issue(issues, "A252", where, "soft edges, of which the thresholds leave nothing");
}

namespace {

constexpr float kOneTexel = 1e-6f;  // Share of the texture's side.
constexpr float kDenseTexels = 40;  // Per millimetre.
constexpr float kMillimetresPerMetre = 1000;

/// On the finest level of detail.
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

void check_unwrapping(const Asset& asset, Diagnostics& issues) {
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr || asset.vertices().empty()) return;
  for (std::size_t i = 0; i < asset.lod_patches(0).size(); ++i) {
    if (is_unwrapped(asset, asset.lod_patches(0)[i])) continue;
    add_patch_issue(issues, "A276", i, "all of it shows one texel: it is not unwrapped");
  }
  const Areas areas = areas_of(asset);
  if (!(areas.surface > 0)) return;
  const double texels = areas.texture * texture->width * texture->height;
  const double density = std::sqrt(texels / areas.surface) / kMillimetresPerMetre;
  if (density <= kDenseTexels) return;
  add_issue(issues, "A275", "base colour texture", "{:.0f} texels to a millimetre of hair", density);
}

}  // namespace coif::validate
