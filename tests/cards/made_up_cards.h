#pragma once

// Cards that tests make up.

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

}  // namespace coif::cards::test
