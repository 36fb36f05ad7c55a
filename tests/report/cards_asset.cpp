#include "report/cards_asset.h"

#include "models/card_asset.h"

#include <cmath>

namespace coif::report {
namespace {

void store(const Eigen::Vector3f& direction, std::int16_t (&snorm)[4]) {
  for (int k = 0; k < 3; ++k) snorm[k] = std::int16_t(std::lround(32767 * direction[k]));
}

}  // namespace

AssetContents asset_of_surface(const cards::CardSurface& surface, const MadeUpPlace& place) {
  AssetContents contents = card_contents({});
  for (int k = 0; k < 3; ++k) contents.skeleton.head_joint[k] = place.head_joint[k];
  for (std::size_t v = 0; v < surface.positions.size(); ++v) {
    VertexRecord record{};
    const Eigen::Vector3f there = place.factor * (place.turn * surface.positions[v]) - place.head_joint;
    for (int k = 0; k < 3; ++k) record.position[k] = there[k];
    store(place.turn * surface.along[v].cross(surface.across[v]).normalized(), record.normal);
    store(place.turn * surface.along[v], record.tangent);
    for (int k = 0; k < 2; ++k) record.uv[k] = surface.uvs[v][k];
    contents.vertices.push_back(record);
  }
  contents.indices = surface.triangles;
  contents.patches = {{0, std::uint32_t(surface.triangles.size()), 1, 0, 0}};
  contents.textures = {{TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, surface.width, surface.height, 1, 0, 0,
                        std::uint64_t{4} * surface.opacity.size()}};
  contents.texels.clear();
  for (const float opacity : surface.opacity) {
    contents.texels.insert(contents.texels.end(), 3, std::byte{200});
    contents.texels.push_back(std::byte(std::lround(255 * opacity)));
  }
  return contents;
}

}  // namespace coif::report
