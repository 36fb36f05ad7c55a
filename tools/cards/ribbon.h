#pragma once

#include "cards/even_strands.h"

#include <Eigen/Core>

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace coif::cards {

/// A card's middle line and its orientation, at the stations of even strands; a wisp of strands is flattened onto it.
struct Ribbon {
  static constexpr std::size_t kStations = EvenStrands::kStations;
  std::array<Eigen::Vector3f, kStations> middle;
  std::array<Eigen::Vector3f, kStations> along;   ///< Unit.
  std::array<Eigen::Vector3f, kStations> across;  ///< Unit, at right angles to `along`.
  /// Metres, > 0 where strands have a width. Strands lie within it, except for those that stray.
  std::array<float, kStations> half_width;
  std::array<float, kStations> half_depth;  ///< The same perpendicular to the card.
};

/// The ribbon of some strands, at least one. Middle lines run through their means; `across` is where they spread most,
/// with the least turn from station to station that allows; widths hold all but a share `stray` of them.
[[nodiscard]] Ribbon ribbon_of(const EvenStrands& strands, std::span<const std::uint32_t> members, float stray = 0.04f);

/// The ribbon from which a card is cut: from the first root to the last tip, and wider by its depth, since hair before
/// or behind a card is beside it for an eye at its side.
[[nodiscard]] Ribbon card_ribbon_of(const EvenStrands& strands, std::span<const std::uint32_t> members);

/// Length of its middle line, metres.
[[nodiscard]] float length_of(const Ribbon& ribbon);

/// Mean squared distance of a strand from a ribbon over the stations, metres squared. Distances beside the middle have
/// the weight `beside` relative to those in front or behind, since a card is wide and has no depth. From `limit` on any
/// value of at least `limit` may be returned, which is faster.
[[nodiscard]] float distance_to(const Ribbon& ribbon, std::span<const Eigen::Vector3f> strand,
                                float limit = std::numeric_limits<float>::max(), float beside = 0.12f);

}  // namespace coif::cards
