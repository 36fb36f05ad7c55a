#include "visibility/hair_surface.h"

#include "base/collider_shapes.h"

#include <coif/skinning.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace coif {
namespace {

constexpr int kFloatDigits = 23, kFloatBias = 127;

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

void AlphaTexture::set_texels(std::size_t mip, std::span<const std::uint8_t> rgba) {
  std::vector<std::uint8_t>& alpha = levels_[mip].alpha;
  for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = rgba[4 * i + 3];
}

MipChoice AlphaTexture::choose_mip(const Eigen::Vector2f& dx, const Eigen::Vector2f& dy) const {
  if (levels_.empty()) return {};
  const Eigen::Vector2f size(float(levels_[0].width), float(levels_[0].height));
  const float square = std::max(dx.cwiseProduct(size).squaredNorm(), dy.cwiseProduct(size).squaredNorm());
  const float texels = std::sqrt(square);
  const int octave = int(std::bit_cast<std::uint32_t>(texels) >> kFloatDigits) - kFloatBias;
  MipChoice mip;
  mip.level = std::uint32_t(std::clamp(octave, 0, int(levels_.size()) - 1));
  const float per_level = std::bit_cast<float>((std::uint32_t(kFloatBias) - mip.level) << kFloatDigits);
  if (mip.level + 1 < levels_.size()) mip.next = std::clamp(texels * per_level - 1, 0.0f, 1.0f);
  return mip;
}

float AlphaTexture::at(const Eigen::Vector2f& uv, const MipChoice& mip) const {
  using Eigen::Array4f, Eigen::Array4i;
  if (levels_.empty()) return std::min(factor_, 1.0f);
  const Level& near = levels_[mip.level];
  const Level& next = mip.next > 0 ? levels_[mip.level + 1] : near;
  // Column and row in the one mip, column and row in the other.
  const Array4i size(near.width, near.height, next.width, next.height);
  const Array4f turns(uv.x(), uv.y(), uv.x(), uv.y());
  const Array4f texel = (turns - turns.floor()) * size.cast<float>() - 0.5f;
  const Array4f below = texel.floor(), share = texel - below;
  const Array4i whole = below.cast<int>(), after = whole + 1;
  const Array4i first = (whole < 0).select(size - 1, whole), second = (after >= size).select(0, after);
  const auto alpha = [](const Level& level, int x, int y) {
    return kAlphaOf[level.alpha[std::size_t(y) * std::size_t(level.width) + std::size_t(x)]];
  };
  const Array4f left(alpha(near, first[0], first[1]), alpha(near, first[0], second[1]), alpha(next, first[2], first[3]),
                     alpha(next, first[2], second[3]));
  const Array4f right(alpha(near, second[0], first[1]), alpha(near, second[0], second[1]),
                      alpha(next, second[2], first[3]), alpha(next, second[2], second[3]));
  const Array4f in_row = left + Array4f(share[0], share[0], share[2], share[2]) * (right - left);
  const float of_near = in_row[0] + share[1] * (in_row[1] - in_row[0]);
  const float of_next = in_row[2] + share[3] * (in_row[3] - in_row[2]);
  return std::clamp((of_near + mip.next * (of_next - of_near)) * factor_, 0.0f, 1.0f);
}

float solid_depth(std::span<const ColliderRecord> solids, const Eigen::Vector3f& origin, const Eigen::Vector3f& along) {
  float nearest = std::numeric_limits<float>::infinity();
  for (const ColliderRecord& solid : solids) nearest = std::min(nearest, depth_along(solid, origin, along));
  return nearest;
}

SolidsAlong::SolidsAlong(std::span<const ColliderRecord> solids, const Eigen::Vector3f& along) : along_(along) {
  for (const ColliderRecord& solid : solids) {
    if (solid.shape != ColliderShape::kSphere && solid.shape != ColliderShape::kEllipsoid) {
      others_.push_back(solid);
      continue;
    }
    const Eigen::Quaternionf turn(solid.rotation[3], solid.rotation[0], solid.rotation[1], solid.rotation[2]);
    const Eigen::Map<const Eigen::Vector3f> center(solid.center), radii(solid.radii);
    const Eigen::Matrix3f to_unit = radii.cwiseInverse().asDiagonal() * turn.conjugate().toRotationMatrix();
    const Eigen::Vector3f way = to_unit * along;
    balls_.push_back({to_unit, center, way, way.squaredNorm()});
  }
}

float SolidsAlong::depth(const Eigen::Vector3f& origin) const {
  float nearest = solid_depth(others_, origin, along_);
  for (const Ball& ball : balls_) {
    const Eigen::Vector3f from = ball.to_unit * (origin - ball.center);
    const float half = from.dot(ball.along), root = half * half - ball.square * (from.squaredNorm() - 1);
    if (root >= 0) nearest = std::min(nearest, (-half - std::sqrt(root)) / ball.square);
  }
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
  std::vector<bool> is_used(asset.vertices().size(), false);
  for (const Triangle& triangle : triangles) {
    for (const std::uint32_t v : triangle.vertex) is_used[v] = true;
  }
  for (std::uint32_t v = 0; v < is_used.size(); ++v) {
    if (is_used[v]) vertices.push_back(v);
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
