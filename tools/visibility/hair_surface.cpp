#include "visibility/hair_surface.h"

#include "base/collider_shapes.h"
#include "base/color_texels.h"

#include <coif/skinning.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace coif::visibility {
namespace {

constexpr int kFloatDigits = 23, kFloatBias = 127;

/// Alphas of the stored values.
constexpr auto kAlphaOf = [] {
  std::array<float, 256> alpha{};
  for (std::size_t i = 0; i < alpha.size(); ++i) alpha[i] = float(i) / 255.0f;
  return alpha;
}();

/// A texture coordinate within its turn: less its floor, but without std::floor(), which is a call where a processor
/// need not have an instruction for it.
float within_turn(float value) {
  constexpr float kAllWhole = 1 << kFloatDigits;
  if (!(std::abs(value) < kAllWhole)) return 0;
  const auto towards_zero = float(int(value));
  return value - (towards_zero - (value < towards_zero ? 1.0f : 0.0f));
}

}  // namespace

AlphaTexture::Level::Level(std::uint32_t width, std::uint32_t height)
    : width_(float(width)), height_(float(height)), stride_(width + 2), alpha_(stride_ * (height + 2)) {}

void AlphaTexture::Level::set_texels(std::span<const std::uint8_t> rgba) {
  const std::size_t width = stride_ - 2, height = alpha_.size() / stride_ - 2;
  for (std::size_t row = 0; row < height + 2; ++row) {
    const std::uint8_t* const from = &rgba[4 * width * ((row + height - 1) % height)];
    std::uint8_t* const to = &alpha_[row * stride_];
    for (std::size_t x = 0; x < width; ++x) to[x + 1] = from[4 * x + 3];
    to[0] = to[width];
    to[width + 1] = to[1];
  }
}

AlphaTexture::AlphaTexture(const Asset& asset) {
  if (asset.material() != nullptr) factor_ = asset.material()->base_color[3];
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr) return;
  for (std::uint32_t mip = 0; mip < texture->mip_count; ++mip) {
    const auto texels = color_texels(asset, *texture, mip);
    levels_.emplace_back(std::max(1u, texture->width >> mip), std::max(1u, texture->height >> mip));
    levels_.back().set_texels({reinterpret_cast<const std::uint8_t*>(texels.data()), texels.size()});
  }
}

void AlphaTexture::set_texels(std::size_t mip, std::span<const std::uint8_t> rgba) { levels_[mip].set_texels(rgba); }

MipChoice AlphaTexture::choose_mip(const Eigen::Vector2f& dx, const Eigen::Vector2f& dy) const {
  if (levels_.empty()) return {};
  const Eigen::Vector2f size = levels_[0].size();
  const float square = std::max(dx.cwiseProduct(size).squaredNorm(), dy.cwiseProduct(size).squaredNorm());
  const float texels = std::sqrt(square);
  const int octave = int(std::bit_cast<std::uint32_t>(texels) >> kFloatDigits) - kFloatBias;
  MipChoice mip;
  mip.level = std::uint32_t(std::clamp(octave, 0, int(levels_.size()) - 1));
  const float per_level = std::bit_cast<float>((std::uint32_t(kFloatBias) - mip.level) << kFloatDigits);
  if (mip.level + 1 < levels_.size()) mip.next = std::clamp(texels * per_level - 1, 0.0f, 1.0f);
  return mip;
}

float AlphaTexture::Level::at(float u, float v) const {
  const float x = u * width_ - 0.5f, y = v * height_ - 0.5f;
  const int column = int(x) - (x < 0 ? 1 : 0), row = int(y) - (y < 0 ? 1 : 0);
  const float right = x - float(column), down = y - float(row);
  const std::uint8_t* const upper = &alpha_[std::size_t(row + 1) * stride_ + std::size_t(column + 1)];
  const std::uint8_t* const lower = upper + stride_;
  const float above = kAlphaOf[upper[0]] + right * (kAlphaOf[upper[1]] - kAlphaOf[upper[0]]);
  const float below = kAlphaOf[lower[0]] + right * (kAlphaOf[lower[1]] - kAlphaOf[lower[0]]);
  return above + down * (below - above);
}

float AlphaTexture::at(const Eigen::Vector2f& uv, const MipChoice& mip) const {
  if (levels_.empty()) return std::min(factor_, 1.0f);
  const float u = within_turn(uv.x()), v = within_turn(uv.y());
  float alpha = levels_[mip.level].at(u, v);
  if (mip.next > 0) alpha += mip.next * (levels_[mip.level + 1].at(u, v) - alpha);
  return std::clamp(alpha * factor_, 0.0f, 1.0f);
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

}  // namespace coif::visibility
