#pragma once

// Cards that tests make up.

#include "cards/hair_picture.h"
#include "cards/make_cards.h"

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace coif::cards::test {

/// A groom's cards, not fitted to pictures of it.
inline Cards unfitted_cards(const groom::Groom& groom, float width, std::size_t count, std::size_t triangles,
                            std::size_t texels) {
  const GroomShape shape = shape_of(groom, width);
  auto wisps = find_wisps(shape.strands, count, 2);
  auto strips = make_strips(wisps, triangles);
  auto cards = texture_cards(groom, shape, {std::move(wisps), std::move(strips)}, texels, 2);
  if (!cards) throw std::runtime_error(cards.error().message);
  return std::move(*cards);
}

/// How much of the pixels that strands or cards cover both cover, mean of five sides. `width`: of strands, metres.
inline double mean_overlap(const groom::Groom& groom, const Cards& cards, float width) {
  const CardSurface surface = surface_of(cards);
  double sum = 0;
  for (const Eigen::Vector3f& direction : spread_directions(5)) {
    const PictureFrame frame = frame_along(direction, ball_around(groom.points), 192);
    sum += compare_hair(draw_strands(groom, frame, width, 2), draw_cards(surface, frame, 2)).coverage_iou;
  }
  return sum / 5;
}

}  // namespace coif::cards::test
