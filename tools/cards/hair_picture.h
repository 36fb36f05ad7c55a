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

/// What is seen of hair from one direction, pixel by pixel, rows top to bottom.
struct HairPicture {
  std::uint32_t size = 0;       ///< Pixels, both ways.
  std::vector<float> coverage;  ///< Share of the pixel that hair covers, 0..1.
  std::vector<float>
      depth;  ///< Of that share, metres from the frame's middle, mean of what is nearest; 0 where nothing is.
  /// What the pixel sends to an eye that holds the light: of what is covered the sine of the angle between the nearest
  /// strand and the line of sight, 0..coverage (Kajiya and Kay 1989, the diffuse term).
  std::vector<float> shade;
};

/// With nothing in it.
[[nodiscard]] inline HairPicture blank_picture(std::uint32_t size) {
  const std::size_t pixels = std::size_t(size) * size;
  return {size, std::vector<float>(pixels), std::vector<float>(pixels), std::vector<float>(pixels)};
}

/// Of a strand, in the frame's axes, unit.
[[nodiscard]] inline float shade_of(const Eigen::Vector3f& along) {
  return std::sqrt(std::max(1 - along.z() * along.z(), 0.0f));
}

/// Strands with round cross sections of `width` metres where the groom says none, each pixel by `side` x `side`
/// samples, the nearest strand in each. Which sample a strand covers is exact, so that a strand thinner than a sample
/// covers as many as its width is worth.
[[nodiscard]] HairPicture draw_strands(const groom::Groom& groom, const PictureFrame& frame, float width,
                                       const platform::Threads& threads, std::uint32_t side = 8);

/// Cards from one direction, as draw_strands() has strands. Each of 16 samples of a pixel is covered by as much as
/// all cards there cover together; the nearest ones' shade covers that of what is behind; depth is that of the nearest
/// place that hides half.
[[nodiscard]] HairPicture draw_cards(const CardSurface& surface, const PictureFrame& frame,
                                     const platform::Threads& threads);

/// How near one picture of hair comes to another of the same frame.
struct HairLikeness {
  double coverage_iou =
      1;             ///< Sum of the smaller coverages over that of the larger ones (intersection over union), 0..1.
  double error = 0;  ///< Root mean square difference of shades, over all pixels that either covers.
};

[[nodiscard]] HairLikeness compare_hair(const HairPicture& wanted, const HairPicture& seen);

/// The same error in decibels below a white pixel, at most 100.
[[nodiscard]] double psnr_db(double error);

}  // namespace coif::cards
