#pragma once

#include "cards/even_strands.h"
#include "cards/ribbon.h"
#include "platform/stop.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// Strands that go onto one card.
struct Wisp {
  std::vector<std::uint32_t> members;  ///< Ascending, not empty.
  Ribbon ribbon;
};

/// All strands in `count` wisps, or as many as there are strands, by their whole shape: each strand is in the wisp on
/// whose card it loses least, and cards are the best of their strands (Lloyd 1982, with ribbons in place of points; the
/// first ones by Arthur and Vassilvitskii 2007, "k-means++"). Of very many strands a sample finds the cards. Repeats
/// for equal input, whatever `threads` is.
[[nodiscard]] std::vector<Wisp> find_wisps(const EvenStrands& strands, std::size_t count,
                                           const platform::Threads& threads);

/// A strip of quads along a ribbon: which of its stations have an edge across it.
struct CardStrip {
  std::uint32_t wisp = 0;
  std::vector<std::uint8_t> stations;  ///< Ascending, the first 0, the last Ribbon::kStations - 1.

  [[nodiscard]] std::size_t triangles() const { return 2 * (stations.size() - 1); }
};

/// The two ends of a ribbon's edge at a station, left and right of its middle as `across` points.
[[nodiscard]] std::array<Eigen::Vector3f, 2> edge_at(const Ribbon& ribbon, std::size_t station);

/// Where the strip's edges lie: as near to the ribbon as straight pieces between them can be, least squares over its
/// stations, so that a bend is not cut short by its chords.
[[nodiscard]] std::vector<std::array<Eigen::Vector3f, 2>> edges_of(const Ribbon& ribbon, const CardStrip& strip);

/// A strip for each wisp, with as many quads as `triangles` allow in all, at least one each: an edge goes wherever the
/// straight strip is farthest from the ribbon, of all strips, each counted by its strands.
[[nodiscard]] std::vector<CardStrip> make_strips(std::span<const Wisp> wisps, std::size_t triangles);

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
