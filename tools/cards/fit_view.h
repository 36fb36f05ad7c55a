#pragma once

#include "cards/card_surface.h"
#include "cards/picture_frame.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// A card's value at a sample, and the texels between which it lies.
struct SeenTexel {
  std::uint32_t sample = 0;
  std::uint32_t texel = 0;    ///< Index in the atlas: the first of the four.
  float right = 0, down = 0;  ///< 0..1, from this one to its neighbours.
  float opacity = 0;
};

/// Cards from one direction by 2 x 2 samples per pixel: the value of each, the transmittance of everything before and
/// behind it, and the missing or surplus coverage of the picture. Keeps its memory from look to look.
class FitView {
 public:
  /// `first_triangle`: of each card; one more for the end.
  void look(const CardSurface& surface, std::span<const std::uint32_t> first_triangle, const PictureFrame& frame);

  /// Compares with the strands' coverage of each pixel.
  void compare(std::span<const float> wanted);

  [[nodiscard]] std::span<const SeenTexel> of_card(std::size_t card) const {
    return std::span(seen_).subspan(begin_[card], begin_[card + 1] - begin_[card]);
  }

  /// Transmittance of a sample without this texel.
  [[nodiscard]] float through(const SeenTexel& seen) const {
    return clear_[seen.sample] / std::max(1 - seen.opacity, kClearest);
  }

  /// Coverage that its pixel lacks, times its weight.
  [[nodiscard]] float lacking(const SeenTexel& seen) const { return lacking_[pixel_of(seen)]; }
  [[nodiscard]] float weight(const SeenTexel& seen) const { return weight_[pixel_of(seen)]; }

  /// Sums over the pixels: the cards' coverage error, and the strands' coverage.
  [[nodiscard]] double error() const { return error_; }
  [[nodiscard]] double covered() const { return covered_; }

 private:
  static constexpr std::uint32_t kSide = 2;  // samples of a pixel, both ways
  static constexpr float kClearest = 1e-4f;  // So that a texel behind an opaque one still has some influence.

  [[nodiscard]] std::size_t pixel_of(const SeenTexel& seen) const {
    const std::uint32_t row = kSide * size_;
    return std::size_t(seen.sample / row / kSide) * size_ + seen.sample % row / kSide;
  }

  std::uint32_t size_ = 0;               // pixels, both ways
  std::vector<SeenTexel> seen_;          // card by card
  std::vector<std::uint32_t> begin_;     // Beginning of each card's; one more for the end.
  std::vector<float> clear_;             // Per sample.
  std::vector<float> lacking_, weight_;  // Per pixel.
  double error_ = 0, covered_ = 0;
};

}  // namespace coif::cards
