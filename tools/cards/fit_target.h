#pragma once

#include "cards/picture_frame.h"
#include "groom/groom.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace coif::cards {

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

}  // namespace coif::cards
