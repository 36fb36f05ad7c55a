#pragma once

#include "cook/select/hair_mesh.h"
#include "cook/texture/image.h"

#include <span>
#include <vector>

namespace coif::cook {

/// The place of one surface's part of its own image in an atlas.
struct AtlasTile {
  std::uint32_t x = 0;  ///< Texels of the atlas, without the gutter around it.
  std::uint32_t y = 0;
  std::uint32_t width = 1;
  std::uint32_t height = 1;
  Eigen::Vector2f uv_low = Eigen::Vector2f::Zero();  ///< The surface's own coordinates at the tile's first corner.
  Eigen::Vector2f uv_size = Eigen::Vector2f::Ones();
  bool clamped[2] = {false, false};  ///< Along U and V: outside 0..1 the image's edge is repeated.
};

struct AtlasLayout {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::vector<AtlasTile> tiles;  ///< One per surface.
};

/// Texels of one surface's image at scale; {0, 0} for a plain colour, which gets a small tile.
struct ImageSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  bool clamped[2] = {false, false};  ///< AtlasTile::clamped.
};

/// Lays out the parts of the images that the triangles of each surface show, in shelves, with gutters that keep mips of
/// the first levels apart. `surface_of_triangle` has the index in `images` for each triangle. The error is a sentence:
/// a surface repeats its image more than twice, or the atlas would be too large.
tl::expected<AtlasLayout, std::string> lay_out_atlas(const HairMesh& hair,
                                                     std::span<const std::uint32_t> surface_of_triangle,
                                                     std::span<const ImageSize> images);

/// Draws the atlas's texels from one RGBA or other image per tile, all with the same number of channels. Images repeat
/// at their borders, in gutters too, except for clamped ones. An image whose size differs from that of the layout is
/// sampled at the nearest texel.
[[nodiscard]] Image draw_atlas(const AtlasLayout& layout, std::span<const Image* const> images);

/// Moves the hair's texture coordinates into the atlas. A vertex that two surfaces share becomes two.
void move_uvs_to_atlas(const AtlasLayout& layout, std::span<const std::uint32_t> surface_of_triangle, HairMesh& hair);

/// Two adjacent rows or columns of texels along an edge of a triangle.
struct TexelBorder {
  int axis = 0;       ///< Across it: 0 for U.
  double inside = 0;  ///< The texel before it, along that axis.
  double step = 1;    ///< Step from there to the texel beyond.
  double low = 0;     ///< Along the other axis, texels.
  double high = 0;
};

/// Those borders along edges of the hair's triangles at which the picture of an RGBA image breaks off: cards that fill
/// a part of an artist's atlas exactly end there, and beyond it lies another part. Those across U first.
[[nodiscard]] std::vector<TexelBorder> borders_where_pictures_end(const HairMesh& hair, const Image& painted);

/// Continues a part of an atlas for some texels beyond its borders, up to a texel that the hair uses: linear filtering
/// mixes in half of a texel at the very edge, and mips more. Runs after fill_gaps(), with the borders of the image as
/// painted.
void repeat_edges(std::span<const TexelBorder> borders, const Image& used, Image& image);

/// Fills texels that nothing shows from the texels around that hair shows, so that no filter mixes in a foreign colour:
///
/// - Texels that the hair does not use (0 in `used`, one channel, the image's size), from the second one away on,
///   take alpha and colour of the used ones near them. Otherwise smaller mips would mix in the background, or a face
///   on the same image.
/// - Used texels that are nearly clear keep their alpha and take the colour of the opaque ones near them: exporters
///   and paint programs leave black or white under alpha 0, which filtering would show as a seam.
///
/// Goes from near to far by pyramids of averages in linear light, weighted by alpha (Gortler et al. 1996, "The
/// lumigraph", push-pull). An image without a used texel is unchanged.
void fill_gaps(Image& image, const Image& used);

}  // namespace coif::cook
