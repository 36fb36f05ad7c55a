#pragma once

#include "cards/card_surface.h"
#include "cards/picture_frame.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

namespace coif::cards {

/// A picture of hair from one direction, rows top to bottom.
struct HairPicture {
  std::uint32_t size = 0;       ///< Pixels, both ways.
  std::vector<float> coverage;  ///< Share of the pixel that hair covers, 0..1.
  /// Depth of the covered share, metres from the frame's middle, mean of the nearest; 0 where nothing is covered.
  std::vector<float> depth;
  /// The light that the pixel sends to an eye that carries the light: over the covered share the sine of the angle
  /// between the nearest strand and the line of sight, 0..coverage (Kajiya and Kay 1989, the diffuse term).
  std::vector<float> shade;
};

/// An empty picture.
[[nodiscard]] inline HairPicture blank_picture(std::uint32_t size) {
  const std::size_t pixels = std::size_t(size) * size;
  return {size, std::vector<float>(pixels), std::vector<float>(pixels), std::vector<float>(pixels)};
}

/// The shade of a strand with this direction, in the frame's axes, unit.
[[nodiscard]] inline float shade_of(const Eigen::Vector3f& along) {
  return std::sqrt(std::max(1 - along.z() * along.z(), 0.0f));
}

/// Draws strands with round cross sections, `width` metres where the groom has none, with `side` x `side` samples per
/// pixel and the nearest strand in each. The covered samples are chosen exactly, so that a strand thinner than a sample
/// covers as many as its width is worth.
[[nodiscard]] HairPicture draw_strands(const groom::Groom& groom, const PictureFrame& frame, float width,
                                       const platform::Threads& threads, std::uint32_t side = 8);

/// Cards from one direction, as draw_strands() has strands. Each of `side` x `side` samples of a pixel is covered by as
/// much as all cards there cover together; the nearest ones' shade covers that of what is behind; depth is that of the
/// nearest place that hides half. Mips are chosen by pixels, not by samples.
[[nodiscard]] HairPicture draw_cards(const CardSurface& surface, const PictureFrame& frame,
                                     const platform::Threads& threads, std::uint32_t side = 4);

/// The similarity of two pictures of hair in the same frame.
struct HairLikeness {
  /// Sum of the smaller coverages divided by that of the larger ones (intersection over union), 0..1.
  double coverage_iou = 1;
  double error = 0;  ///< Root mean square difference of shades, over all pixels that either covers.
};

[[nodiscard]] HairLikeness compare_hair(const HairPicture& wanted, const HairPicture& seen);

/// The cost of drawing a surface from a direction.
struct SurfaceCost {
  double fragments = 0;  ///< Pixels of all its triangles, whatever their texels: a graphics card shades them all.
  double layers = 0;     ///< Overlapping fragments per pixel, mean over the pixels with any.
};

/// With one sample per pixel.
[[nodiscard]] SurfaceCost cost_of(const CardSurface& surface, const PictureFrame& frame);

/// The error in decibels below a white pixel, at most 100.
[[nodiscard]] double psnr_db(double error);

}  // namespace coif::cards
