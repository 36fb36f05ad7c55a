#pragma once

#include "cards/even_strands.h"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace coif::cards {

/// A card's middle line and how it lies, at the stations of even strands: what a wisp of strands is flattened onto.
struct Ribbon {
  static constexpr std::size_t kStations = EvenStrands::kStations;
  std::array<Eigen::Vector3f, kStations> middle;
  std::array<Eigen::Vector3f, kStations> along;   ///< Unit.
  std::array<Eigen::Vector3f, kStations> across;  ///< Unit, at right angles to `along`.
  std::array<float, kStations>
      half_width;  ///< Metres, > 0 where strands have a width: they lie within, but for those that stray.
  std::array<float, kStations> half_depth;  ///< The same at right angles to the card.
};

/// The ribbon of some strands, not none: middle lines run through their means; across is where they spread most, turned
/// as little as that allows from station to station; widths hold all but a share `stray` of them.
[[nodiscard]] Ribbon ribbon_of(const EvenStrands& strands, std::span<const std::uint32_t> members, float stray = 0.04f);

/// The same as a card is cut from it: from the first root to the last tip, and by its depth wider, since what is before
/// or behind a card is beside it for an eye at its side.
[[nodiscard]] Ribbon card_ribbon_of(const EvenStrands& strands, std::span<const std::uint32_t> members);

/// Of its middle line, metres.
[[nodiscard]] float length_of(const Ribbon& ribbon);

/// How far a strand lies off a ribbon, mean over the stations, metres squared: what lies beside the middle counts
/// `beside` of what lies in front of it or behind, since a card is wide and has no depth. Where it is at least `limit`,
/// that or more is returned, for less.
[[nodiscard]] float distance_to(const Ribbon& ribbon, std::span<const Eigen::Vector3f> strand,
                                float limit = std::numeric_limits<float>::max(), float beside = 0.12f);

}  // namespace coif::cards
