#include "view/page/triangle_corners.h"

#include <algorithm>

namespace coif::view {

TriangleCorners::TriangleCorners(const Asset& asset) : asset_(asset), hair_(drawn_hair_of(asset)) {
  patch_colors_.resize(asset.indices().size() / 3);
  std::size_t most = 0;
  for (std::uint32_t lod = 0; lod < asset.lod_count(); ++lod) {
    most = std::max(most, asset.lod_indices(lod).size());
    std::size_t number = 0;
    for (const PatchRecord& patch : asset.lod_patches(lod)) {
      std::fill_n(patch_colors_.begin() + patch.first_index / 3, patch.index_count / 3,
                  screen_color_of_patch(number++));
    }
  }
  skinned_.resize(asset.vertices().size());
  corners_.resize(most);
}

ScreenColor TriangleCorners::color_of(HairView view, std::uint32_t triangle, double share) const {
  return view == HairView::kOrder ? order_color(share) : patch_colors_[triangle];
}

std::span<const TriangleCorner> TriangleCorners::of(HairView view, const HairInstance& head, std::uint32_t order) {
  if (skin_vertices(asset_, head.palette, 0, skinned_) != Status::kOk || head.lod >= hair_.lod_count) return {};
  const std::span<const std::uint32_t> indices = asset_.indices();
  const std::span<const VertexRecord> vertices = asset_.vertices();
  const std::uint32_t first = hair_.lods[head.lod].first / 3, count = hair_.lods[head.lod].count / 3;
  const std::size_t all = indices.size() / 3;
  std::size_t to = 0;
  for (std::uint32_t place = 0; place < count; ++place) {
    const std::size_t at = first + place;
    const auto triangle = order == 0 ? std::uint32_t(at) : asset_.orders()[(order - 1) * all + at];
    const ScreenColor color = color_of(view, triangle, count > 1 ? place / (count - 1.0) : 0);
    for (std::size_t k = 0; k < 3; ++k, ++to) {
      const std::uint32_t vertex = indices[3 * std::size_t{triangle} + k];
      const float(&uv)[2] = vertices[vertex].uv;
      corners_[to] = {skinned_[vertex].position, {uv[0], uv[1]}, {color[0], color[1], color[2], 255}};
    }
  }
  return std::span(corners_).first(to);
}

}  // namespace coif::view
