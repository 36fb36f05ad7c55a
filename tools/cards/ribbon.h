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
  /// Metres along strands from the first station to the last. 0: stations are at even shares of each strand's length.
  float arc = 0;
};

/// The part of a ribbon's strands that reach a station.
class StrandsAt {
 public:
  StrandsAt(const EvenStrands& strands, std::span<const std::uint32_t> members, float arc)
      : strands_(strands), members_(members), arc_(arc) {}

  /// Calls take(point, weight) for each strand that is there at a station. Weights fall towards each strand's tip, so
  /// that a mean does not leap where a strand ends.
  void for_each(std::size_t station, const auto& take) const {
    for_each_there(station, [&](std::uint32_t i, float weight) { take(point_at(i, station), weight); });
  }

  /// The same with each strand's point at an earlier station: take(before, point, weight).
  void for_each_step(std::size_t before, std::size_t station, const auto& take) const {
    for_each_there(station,
                   [&](std::uint32_t i, float weight) { take(point_at(i, before), point_at(i, station), weight); });
  }

 private:
  [[nodiscard]] float arc_at(std::size_t station) const { return arc_ * float(station) / float(Ribbon::kStations - 1); }

  [[nodiscard]] Eigen::Vector3f point_at(std::uint32_t i, std::size_t station) const {
    return arc_ > 0 ? strands_.at_arc(i, arc_at(station)) : strands_.strand(i)[station];
  }

  void for_each_there(std::size_t station, const auto& take) const {
    constexpr float kFade = 0.12f, kLeast = 1e-3f;  // share of the ribbon; weight
    const float at = arc_at(station);
    for (const std::uint32_t i : members_) {
      if (!(arc_ > 0)) {
        take(i, 1.0f);
      } else if (at <= strands_.lengths[i] * 1.0001f) {
        take(i, std::clamp((strands_.lengths[i] - at) / (kFade * arc_), kLeast, 1.0f));
      }
    }
  }

  const EvenStrands& strands_;
  std::span<const std::uint32_t> members_;
  float arc_;
};

/// The ribbon of some strands, at least one. Middle lines run through their means; `across` is where they spread most,
/// with the least turn from station to station that allows; widths hold all but a share `stray` of them. `arc`:
/// Ribbon::arc, at most the length of the longest strand.
[[nodiscard]] Ribbon ribbon_of(const EvenStrands& strands, std::span<const std::uint32_t> members, float stray = 0.04f,
                               float arc = 0);

/// The ribbon from which a card is cut: from the first root to the last tip, and wider by its depth, since hair before
/// or behind a card is beside it for an eye at its side. Its stations are at even distances along the longest strand:
/// strands of one lock wave together at the same distance from their roots, not at the same share of their lengths.
[[nodiscard]] Ribbon card_ribbon_of(const EvenStrands& strands, std::span<const std::uint32_t> members);

/// Whether the side that along x across points to looks towards `middle`, that of the hair.
[[nodiscard]] bool faces_inwards(const Ribbon& ribbon, const Eigen::Vector3f& middle);

/// Length of its middle line, metres.
[[nodiscard]] float length_of(const Ribbon& ribbon);

/// Mean squared distance of a strand from a ribbon over the stations, metres squared. Distances beside the middle have
/// the weight `beside` relative to those in front or behind, since a card is wide and has no depth. From `limit` on any
/// value of at least `limit` may be returned, which is faster.
[[nodiscard]] float distance_to(const Ribbon& ribbon, std::span<const Eigen::Vector3f> strand,
                                float limit = std::numeric_limits<float>::max(), float beside = 0.12f);

}  // namespace coif::cards
