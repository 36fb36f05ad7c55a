#pragma once

#include "cards/fit_target.h"
#include "cards/make_cards.h"
#include "platform/stop.h"

#include <vector>

namespace coif::cards {

/// How near cards came to their strands, round by round.
struct OpacityFit {
  /// Mean difference of coverage, over pixels that strands cover, before each round and after the last; seen from
  /// directions that the two rounds before it did not have.
  std::vector<double> errors;
};

/// Makes texels cover more or less until cards look like their strands from all around. A texture drawn from strands is
/// right for an eye in front of its card; from elsewhere cards are narrower than wisps, and hide each other otherwise
/// than strands do. Each round draws cards from 32 directions, a third of 96 in turn, and hands each pixel's difference
/// from the strands back to the texels that it sees, by how much they change it (simultaneous algebraic reconstruction:
/// Andersen and Kak 1984), spread along the card, where strands lie. A part of each round's change is made again in the
/// next (Polyak 1964, the heavy ball), which takes half as many rounds. Ends when a round gains too little, or after so
/// many. Repeats for equal input, whatever `threads` is.
OpacityFit fit_opacity(FitTarget& target, int rounds, Cards& cards, const platform::Threads& threads);

}  // namespace coif::cards
