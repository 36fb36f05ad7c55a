#include "cook/mip_coverage.h"

#include "cook/used_texels.h"

#include <algorithm>

namespace coif {
namespace {

Image used_by_finest(const Asset& asset, const TextureRecord& texture) {
  HairMesh hair;
  for (const VertexRecord& vertex : asset.vertices()) hair.uvs.emplace_back(vertex.uv[0], vertex.uv[1]);
  const auto indices = asset.lod_indices(0);
  hair.triangles.assign(indices.begin(), indices.end());
  return used_texels(hair, texture.width, texture.height);
}

}  // namespace

AlphaThresholds thresholds_in_texture(const MaterialRecord& material) {
  const double factor = double(material.base_color[3]);
  if (!(factor > 0)) return {2, 2};
  return {double(material.opaque_threshold) / factor, double(material.discard_threshold) / factor};
}

std::vector<AlphaCoverage> mip_coverage(const Asset& asset) {
  const TextureRecord* texture = asset.texture(TextureRole::kBaseColor);
  if (texture == nullptr || asset.material() == nullptr || asset.vertices().empty()) return {};
  const auto used = make_mips(used_by_finest(asset, *texture), kMaxImageSide, TexelMeaning::kNumbers);
  const AlphaThresholds thresholds = thresholds_in_texture(*asset.material());
  std::vector<AlphaCoverage> result;
  for (std::uint32_t level = 0; level < texture->mip_count; ++level) {
    Image mip{used[level].width, used[level].height, 4, {}};
    const auto texels = asset.texels(*texture, level);
    for (const auto texel : texels) mip.texels.push_back(std::uint8_t(texel));
    result.push_back(alpha_coverage(mip, used[level], thresholds));
  }
  return result;
}

}  // namespace coif
