#include "visibility/hair_surface.h"

#include <coif/skinning.h>

namespace coif {
namespace {

/// Colliders on rigid bones stay where they are in head space. A plane has no outline, and what hair is kept inside of hides
/// nothing.
bool is_solid(const ColliderRecord& collider) {
  return collider.shape != ColliderShape::kPlane && (collider.flags & kColliderKeepsInside) == 0;
}

}  // namespace

HairSurface::HairSurface(const Asset& asset) : alpha(asset) {
  const auto patches = asset.lod_patches(0);
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
