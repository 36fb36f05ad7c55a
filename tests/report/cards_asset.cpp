#include "report/cards_asset.h"

#include "models/card_asset.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace coif::report {
namespace {

void store(const Eigen::Vector3f& direction, std::int16_t (&snorm)[4]) {
  for (int k = 0; k < 3; ++k) snorm[k] = std::int16_t(std::lround(32767 * direction[k]));
}

void add_texels(std::span<const float> opacity, std::vector<std::byte>& texels) {
  for (const float alpha : opacity) {
    texels.insert(texels.end(), 3, std::byte{200});
    texels.push_back(std::byte(std::lround(255 * alpha)));
  }
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
  contents.material[0].opaque_threshold = std::min(surface.opaque_from, 1.0f);
  contents.material[0].discard_threshold = surface.discard_below;
  contents.texels.clear();
  add_texels(surface.opacity, contents.texels);
  for (const std::vector<float>& opacity : surface.smaller_opacity) add_texels(opacity, contents.texels);
  contents.textures = {{TextureRole::kBaseColor, TexelFormat::kSrgb8Alpha8, surface.width, surface.height,
                        std::uint32_t(1 + surface.smaller_opacity.size()), 0, 0, contents.texels.size()}};
  return contents;
}

}  // namespace coif::report
