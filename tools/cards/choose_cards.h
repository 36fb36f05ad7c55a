#pragma once

#include "cards/card_strip.h"
#include "cards/even_strands.h"
#include "cards/wisps.h"
#include "platform/stop.h"

#include <cstddef>
#include <vector>

namespace coif::cards {

/// Cards without textures.
struct ChosenCards {
  std::vector<Wisp> wisps;
  std::vector<CardStrip> strips;
};

/// How badly strips stand for their strands: how far these lie off them, mean over strands and stations, metres squared
/// (distance_to()), where what lies off since strips are straight between their edges counts twice.
[[nodiscard]] double strands_off_strips(const EvenStrands& strands, const ChosenCards& cards,
                                        const platform::Threads& threads);

/// As many wisps, and as long strips, as triangles are best spent on: more cards lie nearer to their strands where
/// these are straight, more edges each where they bend. Repeats for equal input, whatever `threads` is.
[[nodiscard]] ChosenCards choose_cards(const EvenStrands& strands, std::size_t triangles,
                                       const platform::Threads& threads);

}  // namespace coif::cards
