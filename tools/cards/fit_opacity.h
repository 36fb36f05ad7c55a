#pragma once

#include "cards/make_cards.h"
#include "cards/picture_frame.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif::cards {

/// Strands for pictures in which single strands cannot be seen: every n-th one, n times as wide, so that there are at
/// most `points` points if there are enough strands. `width` is for strands whose groom has none; the result has its
/// own.
[[nodiscard]] groom::Groom fewer_strands(const groom::Groom& groom, float width, std::size_t points);

/// Strands without the points that lie within `tolerance` metres of a line through their neighbours (Douglas and
/// Peucker 1973). Widths and colours are those of the points that stay.
[[nodiscard]] groom::Groom straighter_strands(const groom::Groom& groom, float tolerance);

/// The pictures of strands that cards are fitted to, whichever cards these are: from some directions all around, of
/// which a round of fitting sees a part.
class FitTarget {
 public:
  static constexpr std::size_t kViews = 32;  ///< Per round.
  static constexpr std::size_t kTurns = 3;   ///< Rounds after which the views repeat.

  /// `strand_width` is for strands whose groom has none, metres; `size`: pixels of a picture, both ways.
  FitTarget(const groom::Groom& groom, float strand_width, std::uint32_t size = 256);

  /// Index of the view that has the number `view` in this round.
  [[nodiscard]] static std::size_t view_of(int round, std::size_t view) {
    return std::size_t(round) % kTurns * kViews + view;
  }

  [[nodiscard]] const PictureFrame& frame(std::size_t view) const { return frames_[view]; }
  /// The strands' coverage of each pixel; drawn at the first call. Several threads may call it, each for another view.
  [[nodiscard]] const std::vector<float>& coverage(std::size_t view);

 private:
  groom::Groom groom_;  // no finer than pictures show
  float strand_width_;
  std::vector<PictureFrame> frames_;
  std::vector<std::vector<float>> coverage_;
};

/// The error of cards relative to their strands, round by round.
struct OpacityFit {
  /// Mean difference of coverage, over pixels that strands cover, before the first round and after each that made it
  /// smaller; seen from directions that the two rounds before it did not have.
  std::vector<double> errors;
};

/// Changes the texels' coverage until cards look like their strands from all around. A texture drawn from strands is
/// right for an eye in front of its card; from elsewhere cards are narrower than wisps, and hide each other differently
/// than strands do. Each round draws cards from 32 directions, a third of 96 in turn, and returns each pixel's
/// difference from the strands to the texels that it sees, weighted by their effect (simultaneous algebraic
/// reconstruction: Andersen and Kak 1984), spread along the card, where strands lie. A part of each round's change is
/// repeated in the next (Polyak 1964, the heavy ball), which halves the number of rounds. Half of a round that makes
/// it worse is taken back, and later ones change less. Textures that are finer than pictures are seen and changed by
/// their means. Ends when a round gains too little, or after `rounds`. Repeats for equal input, with any `threads`.
OpacityFit fit_opacity(FitTarget& target, int rounds, Cards& cards, const platform::Threads& threads);

}  // namespace coif::cards
