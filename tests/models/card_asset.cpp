#include "models/card_asset.h"

#include <Eigen/Geometry>

#include <cmath>

namespace coif {
namespace {

constexpr std::uint32_t kAlphas = 256;

VertexRecord vertex(const Eigen::Vector3f& position, const Eigen::Vector3f& normal, int alpha) {
  VertexRecord v{};
  for (int k = 0; k < 3; ++k) {
    v.position[k] = position[k];
    v.normal[k] = std::int16_t(std::lround(32767 * normal[k]));
  }
  v.normal[3] = 32767;
  v.tangent[1] = -32767;
  v.uv[0] = (float(alpha) + 0.5f) / float(kAlphas);
  v.uv[1] = 0.5f;
  return v;
}

/// One texel of each alpha: a card whose corners all have the same coordinates has one alpha everywhere.
void add_alphas(AssetContents& contents) {
  contents.textures = {
      {TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, kAlphas, 1, 1, 0, 0, std::uint64_t{4} * kAlphas}};
  for (std::uint32_t a = 0; a < kAlphas; ++a) {
    for (int k = 0; k < 3; ++k) contents.texels.push_back(std::byte{200});
    contents.texels.push_back(std::byte(a));
  }
}

void add_card(const Card& card, std::uint32_t place, AssetContents& contents) {
  const Eigen::Vector3f normal = card.right.cross(card.up).normalized();
  const auto first = std::uint32_t(contents.vertices.size());
  for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
    const Eigen::Vector3f corner = card.center + float(x) * card.right + float(y) * card.up;
    contents.vertices.push_back(vertex(corner, normal, card.alpha));
  }
  contents.patches.push_back({std::uint32_t(contents.indices.size()), 6, card.center.norm(), 0, place});
  for (const std::uint32_t corner : {0u, 1u, 2u, 0u, 2u, 3u}) contents.indices.push_back(first + corner);
}

}  // namespace

AssetContents card_contents(std::span<const Card> cards) {
  AssetContents contents;
  contents.skeleton.head_rotation[3] = 1;
  BoneRecord head{};
  head.parent = head.chain = head.name = kNone;
  contents.bones = {head};
  for (std::size_t i = 0; i < cards.size(); ++i) add_card(cards[i], std::uint32_t(i), contents);
  MaterialRecord material{};
  for (float& c : material.base_color) c = 1;
  material.opaque_threshold = 0.95f;
  material.discard_threshold = 0.02f;
  material.flags = kMaterialDoubleSided;
  material.primary_exponent = material.secondary_exponent = 100;
  contents.material = {material};
  add_alphas(contents);
  return contents;
}

void add_ball(AssetContents& contents, const Eigen::Vector3f& center, float radius) {
  ColliderRecord ball{};
  ball.shape = ColliderShape::kSphere;
  for (int k = 0; k < 3; ++k) {
    ball.center[k] = center[k];
    ball.radii[k] = radius;
  }
  ball.rotation[3] = 1;
  contents.colliders.push_back(ball);
}

}  // namespace coif
