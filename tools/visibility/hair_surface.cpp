#include "visibility/hair_surface.h"

#include "base/collider_shapes.h"

#include <coif/skinning.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace coif {
namespace {

/// The texel below a place and the one after it, around the edge, and how far it is to that one.
struct Neighbours {
  int first, second;
  float share;
};

/// std::floor() of what fits a whole number, which on processors without an instruction for it is a call; others stay.
float floor_of(float value) {
  if (!(std::abs(value) < 1.0e9f)) return value;
  const int below = int(value);
  return float(below - (value < float(below) ? 1 : 0));
}

Neighbours neighbours(float place, int size) {
  const float texel = (place - floor_of(place)) * float(size) - 0.5f;
  const float first = floor_of(texel);
  const int index = first < 0 ? size - 1 : int(first);
  return {index, index + 1 == size ? 0 : index + 1, texel - first};
}

/// Of stored values.
constexpr auto kAlphaOf = [] {
  std::array<float, 256> alpha{};
  for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = float(i) / 255.0f;
  return alpha;
}();

}  // namespace

AlphaTexture::AlphaTexture(const Asset& asset) {
  if (asset.material() != nullptr) factor_ = asset.material()->base_color[3];
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr) return;
  for (std::uint32_t mip = 0; mip < texture->mip_count; ++mip) {
    Level level{int(std::max(1u, texture->width >> mip)), int(std::max(1u, texture->height >> mip)), {}};
    const auto texels = asset.texels(*texture, mip);
    for (std::size_t i = 3; i < texels.size(); i += 4) level.alpha.push_back(std::uint8_t(texels[i]));
    levels_.push_back(std::move(level));
  }
}

MipChoice AlphaTexture::choose_mip(const Eigen::Vector2f& dx, const Eigen::Vector2f& dy) const {
  if (levels_.empty()) return {};
  const Eigen::Vector2f size(float(levels_[0].width), float(levels_[0].height));
  const float square = std::max(dx.cwiseProduct(size).squaredNorm(), dy.cwiseProduct(size).squaredNorm());
  float texels = std::sqrt(square);
  MipChoice mip;
  for (; texels >= 2 && mip.level + 1 < levels_.size(); ++mip.level) texels *= 0.5f;
  if (mip.level + 1 < levels_.size()) mip.next = std::clamp(texels - 1, 0.0f, 1.0f);
  return mip;
}

float AlphaTexture::at(const Eigen::Vector2f& uv, const MipChoice& mip) const {
  if (levels_.empty()) return std::min(factor_, 1.0f);
  float alpha = filtered(levels_[mip.level], uv);
  if (mip.next > 0) alpha += mip.next * (filtered(levels_[mip.level + 1], uv) - alpha);
  return std::clamp(alpha * factor_, 0.0f, 1.0f);
}

float AlphaTexture::filtered(const Level& level, const Eigen::Vector2f& uv) {
  const Neighbours column = neighbours(uv.x(), level.width), row = neighbours(uv.y(), level.height);
  const auto in_row = [&](int y) {
    const std::uint8_t* const texels = &level.alpha[std::size_t(y) * std::size_t(level.width)];
    const float first = kAlphaOf[texels[column.first]];
    return first + column.share * (kAlphaOf[texels[column.second]] - first);
  };
  const float upper = in_row(row.first);
  return upper + row.share * (in_row(row.second) - upper);
}

float solid_depth(std::span<const ColliderRecord> solids, const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  float nearest = std::numeric_limits<float>::infinity();
  for (const ColliderRecord& solid : solids) nearest = std::min(nearest, depth_along(solid, origin, along));
  return nearest;
}

HairSurface::HairSurface(const Asset& asset, std::uint32_t lod) : alpha(asset) {
  const auto patches = asset.lod_patches(lod);
  patch_count = std::uint32_t(patches.size());
  for (std::uint32_t p = 0; p < patch_count; ++p) {
    const auto indices = asset.indices().subspan(patches[p].first_index, patches[p].index_count);
    for (std::size_t i = 0; i < indices.size(); i += 3) {
      triangles.push_back({{indices[i], indices[i + 1], indices[i + 2]}, p});
    }
  }
  for (const VertexRecord& vertex : asset.vertices()) uvs.emplace_back(vertex.uv[0], vertex.uv[1]);
  if (const MaterialRecord* material = asset.material(); material != nullptr) {
    faintest = material->discard_threshold;
    double_sided = (material->flags & kMaterialDoubleSided) != 0;
  }
  // Colliders on rigid bones stay where they are in head space.
  for (const ColliderRecord& collider : asset.colliders()) {
    if (is_solid(collider)) solids.push_back(collider);
  }
}

std::vector<Eigen::Vector3f> posed_positions(const Asset& asset, std::span<const Mat34> palette) {
  const std::size_t count = asset.vertices().size();
  std::vector<SkinnedVertex> skinned(count);
  const std::vector<Mat34> rest(asset.bones().size());
  const Status status = skin_vertices(asset, palette.empty() ? rest : palette, 0, skinned);
  std::vector<Eigen::Vector3f> positions;
  if (status != Status::kOk) return positions;
  positions.reserve(count);
  for (const SkinnedVertex& v : skinned) positions.emplace_back(v.position.x, v.position.y, v.position.z);
  return positions;
}

}  // namespace coif
