#include "cook/texture/texture_atlas.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::cook {
namespace {

using Eigen::Vector2f;

/// Around each tile. Cells start at multiples of twice as much, so that four mips have no texel of two surfaces.
constexpr std::uint32_t kGutter = 8;
constexpr std::uint32_t kCellStep = 2 * kGutter;
constexpr std::uint32_t kPlainSide = 64;  ///< Side of a plain colour's tile: room for shift and mask to vary.
constexpr float kMaxRepeats = 2;          ///< Strips mirrored across the border of the image need two.

std::uint32_t cell_size(std::uint32_t tile) { return (tile + 2 * kGutter + kCellStep - 1) / kCellStep * kCellStep; }

std::vector<Eigen::AlignedBox2f> uv_ranges(const HairMesh& hair, std::span<const std::uint32_t> surface_of_triangle,
                                           std::size_t surfaces) {
  std::vector<Eigen::AlignedBox2f> ranges(surfaces);
  for (std::size_t i = 0; i < hair.triangles.size(); ++i) {
    ranges[surface_of_triangle[i / 3]].extend(hair.uvs[hair.triangles[i]]);
  }
  return ranges;
}

/// The whole texels around `range`, as a tile without a place.
AtlasTile tile_of_image(const Eigen::AlignedBox2f& range, const ImageSize& image) {
  const Vector2f size(float(image.width), float(image.height));
  const Vector2f low = range.min().cwiseProduct(size).array().floor();
  const Vector2f high = range.max().cwiseProduct(size).array().ceil().max(low.array() + 1.0f);
  AtlasTile tile;
  tile.width = std::uint32_t(high.x() - low.x());
  tile.height = std::uint32_t(high.y() - low.y());
  tile.uv_low = low.cwiseQuotient(size);
  tile.uv_size = (high - low).cwiseQuotient(size);
  return tile;
}

AtlasTile tile_of_plain_color(const Eigen::AlignedBox2f& range) {
  AtlasTile tile;
  tile.width = tile.height = kPlainSide;
  tile.uv_low = range.min();
  tile.uv_size = range.sizes().cwiseMax(1.0e-6f);
  return tile;
}

/// Places tiles in shelves, the highest first, about as wide as all are high.
void place_in_shelves(AtlasLayout& layout) {
  std::vector<std::size_t> order(layout.tiles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, [&](auto a, auto b) { return layout.tiles[a].height > layout.tiles[b].height; });
  double area = 0;
  for (const AtlasTile& tile : layout.tiles) {
    area += double(cell_size(tile.width)) * cell_size(tile.height);
    layout.width = std::max(layout.width, cell_size(tile.width));
  }
  const auto wanted = std::uint32_t(std::ceil(std::sqrt(area)));
  layout.width = std::max(layout.width, (wanted + kCellStep - 1) / kCellStep * kCellStep);
  std::uint32_t x = 0, y = 0, shelf = 0;
  for (const std::size_t i : order) {
    AtlasTile& tile = layout.tiles[i];
    if (x + cell_size(tile.width) > layout.width) {
      y += shelf;
      x = shelf = 0;
    }
    tile.x = x + kGutter;
    tile.y = y + kGutter;
    x += cell_size(tile.width);
    shelf = std::max(shelf, cell_size(tile.height));
  }
  layout.height = y + shelf;
}

std::size_t texel_at(float coordinate, std::uint32_t size, bool is_clamped) {
  return is_clamped ? std::size_t(std::clamp(coordinate, 0.0f, 1.0f - 0.5f / float(size)) * float(size))
                    : repeated(coordinate, size);
}

void draw_tile(const AtlasTile& tile, const Image& image, Image& atlas) {
  const std::uint32_t left = tile.x - kGutter, top = tile.y - kGutter;
  for (std::uint32_t y = top; y < top + cell_size(tile.height); ++y) {
    const float v = (float(y) + 0.5f - float(tile.y)) / float(tile.height) * tile.uv_size.y() + tile.uv_low.y();
    const std::size_t row = texel_at(v, image.height, tile.clamped[1]) * image.width;
    for (std::uint32_t x = left; x < left + cell_size(tile.width); ++x) {
      const float u = (float(x) + 0.5f - float(tile.x)) / float(tile.width) * tile.uv_size.x() + tile.uv_low.x();
      const std::size_t from = (row + texel_at(u, image.width, tile.clamped[0])) * image.channels;
      const std::size_t to = (std::size_t(y) * atlas.width + x) * atlas.channels;
      std::copy_n(&image.texels[from], image.channels, &atlas.texels[to]);
    }
  }
}

}  // namespace

tl::expected<AtlasLayout, std::string> lay_out_atlas(const HairMesh& hair,
                                                     std::span<const std::uint32_t> surface_of_triangle,
                                                     std::span<const ImageSize> images) {
  const auto ranges = uv_ranges(hair, surface_of_triangle, images.size());
  AtlasLayout layout;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const bool plain = images[i].width == 0;
    // Written so that a coordinate which is no number fails too.
    if (!(ranges[i].sizes().maxCoeff() <= (plain ? 1.0e6f : kMaxRepeats)) || !(ranges[i].min().norm() < 1.0e4f)) {
      return tl::unexpected(fmt::format("texture coordinates that repeat an image more than {} times", kMaxRepeats));
    }
    layout.tiles.push_back(plain ? tile_of_plain_color(ranges[i]) : tile_of_image(ranges[i], images[i]));
    std::copy_n(images[i].clamped, 2, layout.tiles.back().clamped);
  }
  place_in_shelves(layout);
  const bool fits = std::max(layout.width, layout.height) <= kMaxImageSide &&
                    std::uint64_t(layout.width) * layout.height <= kMaxImageTexels;
  if (!fits) return tl::unexpected(fmt::format("an atlas of {} x {} texels", layout.width, layout.height));
  return layout;
}

Image draw_atlas(const AtlasLayout& layout, std::span<const Image* const> images) {
  Image atlas{layout.width, layout.height, images[0]->channels, {}};
  atlas.texels.resize(atlas.texel_count() * atlas.channels);
  for (std::size_t i = 0; i < images.size(); ++i) draw_tile(layout.tiles[i], *images[i], atlas);
  return atlas;
}

void move_uvs_to_atlas(const AtlasLayout& layout, std::span<const std::uint32_t> surface_of_triangle, HairMesh& hair) {
  const std::size_t originals = hair.positions.size();
  std::vector<std::uint32_t> surface_of_vertex(originals, importer::kNoIndex);
  // For each further surface of a shared vertex its copy.
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> copies(originals);
  for (std::size_t i = 0; i < hair.triangles.size(); ++i) {
    const std::uint32_t surface = surface_of_triangle[i / 3], vertex = hair.triangles[i];
    if (surface_of_vertex[vertex] == importer::kNoIndex) surface_of_vertex[vertex] = surface;
    if (surface_of_vertex[vertex] == surface) continue;
    auto& known = copies[vertex];
    auto copy = std::ranges::find(known, surface, [](const auto& entry) { return entry.first; });
    if (copy == known.end()) {
      surface_of_vertex.push_back(surface);
      copy = known.insert(known.end(), {surface, hair.append_vertex(hair, vertex)});
    }
    hair.triangles[i] = copy->second;
  }
  const Vector2f atlas_size(float(layout.width), float(layout.height));
  for (std::size_t v = 0; v < hair.uvs.size(); ++v) {
    if (surface_of_vertex[v] == importer::kNoIndex) continue;
    const AtlasTile& tile = layout.tiles[surface_of_vertex[v]];
    const Vector2f inside = (hair.uvs[v] - tile.uv_low).cwiseQuotient(tile.uv_size);
    const Vector2f texels =
        Vector2f(float(tile.x), float(tile.y)) + inside.cwiseProduct(Vector2f(float(tile.width), float(tile.height)));
    hair.uvs[v] = texels.cwiseQuotient(atlas_size);
  }
}

}  // namespace coif::cook
