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

/// The strands of one card.
struct Wisp {
  std::vector<std::uint32_t> members;  ///< Ascending, not empty.
  Ribbon ribbon;
};

/// Groups all strands into `count` wisps, or as many as there are strands, by their whole shape: each strand is in the
/// wisp whose card it fits best, and cards fit their strands best (Lloyd 1982, with ribbons in place of points; the
/// first ones by Arthur and Vassilvitskii 2007, "k-means++"). With very many strands a sample finds the cards. Repeats
/// for equal input, with any `threads`.
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

/// The places of the strip's edges: as near to the ribbon as straight pieces between them can be, by least squares over
/// its stations, so that chords do not cut a bend short.
[[nodiscard]] std::vector<std::array<Eigen::Vector3f, 2>> edges_of(const Ribbon& ribbon, const CardStrip& strip);

/// A strip for each wisp, with as many quads as `triangles` allow in all, at least one each. Each new edge goes to the
/// place where a straight strip is farthest from its ribbon, over all strips, weighted by their strands.
[[nodiscard]] std::vector<CardStrip> make_strips(std::span<const Wisp> wisps, std::size_t triangles);

/// Cards without textures.
struct ChosenCards {
  std::vector<Wisp> wisps;
  std::vector<CardStrip> strips;
};

/// How badly strips represent their strands: mean squared distance of the strands over strands and stations, metres
/// squared (distance_to()). Distances because strips are straight between their edges count twice.
[[nodiscard]] double strands_off_strips(const EvenStrands& strands, const ChosenCards& cards,
                                        const platform::Threads& threads);

/// Chooses the number of wisps and the lengths of strips that use the triangles best: more cards are nearer to their
/// strands where these are straight, more edges each where they bend. Repeats for equal input, with any `threads`.
[[nodiscard]] ChosenCards choose_cards(const EvenStrands& strands, std::size_t triangles,
                                       const platform::Threads& threads);

}  // namespace coif::cards
