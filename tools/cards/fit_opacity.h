#pragma once

#include "cards/make_cards.h"
#include "cards/picture_frame.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif::cards {

/// Strands for pictures in which single ones are not told apart: every so many-th one, as many times as wide, so that
/// there are no more than `points` where there are strands enough. `width`: of strands whose groom says none; those
/// given back have their own.
[[nodiscard]] groom::Groom fewer_strands(const groom::Groom& groom, float width, std::size_t points);

/// Strands without the points that lie within `tolerance` metres of a line through those beside them (Douglas and
/// Peucker 1973). Widths and colours are those of the points that stay.
[[nodiscard]] groom::Groom straighter_strands(const groom::Groom& groom, float tolerance);

/// The pictures of strands that cards are fitted to, whichever cards these are: from some directions all around, of
/// which a round of fitting sees a part.
class FitTarget {
 public:
  static constexpr std::size_t kViews = 32;  ///< Of a round.
  static constexpr std::size_t kTurns = 3;   ///< Of them, until a round has the same again.

  /// `strand_width`: of strands whose groom says none, metres.
  FitTarget(const groom::Groom& groom, float strand_width);

  /// Which view it is that a round sees as its own number `view`.
  [[nodiscard]] static std::size_t view_of(int round, std::size_t view) {
    return std::size_t(round) % kTurns * kViews + view;
  }

  [[nodiscard]] const PictureFrame& frame(std::size_t view) const { return frames_[view]; }
  /// What strands cover of each pixel; drawn when it is first asked for. Several threads may ask, each for another
  /// view.
  [[nodiscard]] const std::vector<float>& coverage(std::size_t view);

 private:
  groom::Groom groom_;  // no finer than pictures show
  float strand_width_;
  std::vector<PictureFrame> frames_;
  std::vector<std::vector<float>> coverage_;
};

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
