#pragma once

#include "cards/wisps.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

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

}  // namespace coif::cards
