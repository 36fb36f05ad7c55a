#pragma once

#include "cards/even_strands.h"
#include "cards/ribbon.h"
#include "groom/groom.h"
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
  /// The two ends of each edge, metres. Empty before lay_strips(): edges_of() has them.
  std::vector<std::array<Eigen::Vector3f, 2>> edges{};

  [[nodiscard]] std::size_t triangles() const { return 2 * (stations.size() - 1); }
};

/// The two ends of a ribbon's edge at a station, left and right of its middle as `across` points.
[[nodiscard]] std::array<Eigen::Vector3f, 2> edge_at(const Ribbon& ribbon, std::size_t station);

/// The places of the strip's edges: as near to the ribbon as straight pieces between them can be, by least squares over
/// its stations, so that chords do not cut a bend short.
[[nodiscard]] std::vector<std::array<Eigen::Vector3f, 2>> edges_of(const Ribbon& ribbon, const CardStrip& strip);

/// The strip's own edges where it is laid, else those of edges_of().
[[nodiscard]] inline std::vector<std::array<Eigen::Vector3f, 2>> ends_of_edges(const Ribbon& ribbon,
                                                                               const CardStrip& strip) {
  return strip.edges.empty() ? edges_of(ribbon, strip) : strip.edges;
}

/// A strip for each wisp, with as many quads as `triangles` allow in all, at least one each. Each new edge goes to the
/// place where a straight strip is farthest from its ribbon, over all strips, weighted by their strands.
[[nodiscard]] std::vector<CardStrip> make_strips(std::span<const Wisp> wisps, std::size_t triangles);

/// Cards without textures.
struct ChosenCards {
  std::vector<Wisp> wisps;
  std::vector<CardStrip> strips;
};

/// Sets the edges of strips. A strip is straight between its edges and its strands are not: it is made so wide that it
/// holds them where they lie beside it, and their textures are drawn there. Sets the ribbons' half_depth to what is
/// left in front and behind.
void lay_strips(const EvenStrands& strands, ChosenCards& cards, const platform::Threads& threads);

/// A way to make cards.
enum class Construction : std::uint8_t {
  kBent,  ///< find_wisps(), and quads where strips bend: make_strips().
  kEven,  ///< find_wisps(), and strips cut into equal segments.
  kFlat,  ///< Groups of strands by k-means, each on one flat quad: the rectangle of the plane that fits it best.
};

/// A way to make cards, and how many triangles it spends on each.
struct CardsPlan {
  Construction construction = Construction::kBent;
  double quads = 4;  ///< Mean per card, >= 1; whole for kEven, 1 for kFlat.

  bool operator==(const CardsPlan&) const = default;
};

/// Cards by a plan, with at most that many triangles (at least 2), laid. Repeats for equal input, with any `threads`.
[[nodiscard]] ChosenCards construct_cards(const groom::Groom& groom, const EvenStrands& strands, const CardsPlan& plan,
                                          std::size_t triangles, const platform::Threads& threads);

// The parts of kEven and kFlat.

/// From root to tip, as even as a ribbon's stations allow.
[[nodiscard]] CardStrip even_strip(std::uint32_t wisp, std::size_t segments);

/// Groups strands by their whole shape, into `count` clusters or as many as there are different strands, each ascending
/// and not empty: k-means (Lloyd 1982) from seeds by k-means++ (Arthur and Vassilvitskii 2007) on the points of even
/// strands. With very many strands a sample finds the middles. Repeats for equal input, with any `threads`.
[[nodiscard]] std::vector<std::vector<std::uint32_t>> cluster_strands(const EvenStrands& strands, std::size_t count,
                                                                      const platform::Threads& threads);

/// A straight ribbon in the plane that fits the strands best (their first two principal axes), along the first of
/// these: the rectangle that holds their points. Its first end is the one nearer to most roots.
[[nodiscard]] Ribbon flat_ribbon_of(const groom::Groom& groom, const EvenStrands& strands,
                                    std::span<const std::uint32_t> members);

}  // namespace coif::cards
