#pragma once

#include "cards/fit_opacity.h"
#include "cards/hair_picture.h"
#include "cards/make_cards.h"
#include "groom/groom.h"
#include "platform/stop.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// What a set of cards is worth.
struct CardsMerit {
  double close_error = 0;  ///< Root mean square error of the picture (HairLikeness::error), mean over directions.
  double far_error = 0;    ///< The same for pictures whose pixels are four times as wide.
  double layers = 0;       ///< SurfaceCost::layers, mean over directions.

  /// The smaller the better: the mean of both errors. Twice as many layers count as much as an error larger by 7 %, so
  /// that of two sets that look alike the cheaper one is taken.
  [[nodiscard]] double price() const;
};

/// Compares cards with strands as `coif report cards` does, from a few directions that the fit of opacity does not
/// have.
class CardsJudge {
 public:
  static constexpr std::size_t kViews = 8;

  /// `strand_width` is for strands whose groom has none, metres; `size`: pixels of a close picture, both ways.
  CardsJudge(const groom::Groom& groom, float strand_width, std::uint32_t size, const platform::Threads& threads);

  [[nodiscard]] CardsMerit judge(const CardSurface& surface, const platform::Threads& threads) const;
  /// The merit's layers only, which is faster.
  [[nodiscard]] double layers(const CardSurface& surface, const platform::Threads& threads) const;

 private:
  std::vector<PictureFrame> frames_;
  std::vector<HairPicture> strands_;
};

inline constexpr Construction kConstructions[] = {Construction::kBent, Construction::kEven, Construction::kFlat};

/// For which cards a plan is chosen.
struct PlanBudget {
  std::size_t triangles = 0;
  std::size_t texels = 0;
  int rounds = 6;   ///< CardsBudget::rounds.
  float scale = 1;  ///< Size of the hair in pictures of these cards, against those of the finest level.
};

/// The plan whose cards have the lowest price(): cards of several numbers of quads are made by each construction, with
/// fewer texels and fewer rounds of fitting than in the end, and looked at with mips and thresholds, as they are drawn.
/// The search goes on towards fewer or more quads as long as the price falls. Of cards in many more layers than others
/// nothing is expected. Repeats for equal input, with any `threads`.
[[nodiscard]] CardsPlan choose_plan(const groom::Groom& groom, const GroomShape& shape,
                                    std::span<const Construction> constructions, const PlanBudget& budget,
                                    const platform::Threads& threads);

}  // namespace coif::cards
