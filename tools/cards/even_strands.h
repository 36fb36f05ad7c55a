#pragma once

#include "groom/groom.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace coif::cards {

/// Strands as points at even shares of their length, root first, the same number for each, so that shapes can be
/// compared.
struct EvenStrands {
  static constexpr std::size_t kStations = 32;

  std::vector<Eigen::Vector3f> points;  ///< kStations points per strand.
  std::vector<float> lengths;           ///< Metres, > 0.
  float width = 0;                      ///< Mean width of a strand, metres.

  [[nodiscard]] std::size_t count() const { return lengths.size(); }
  [[nodiscard]] std::span<const Eigen::Vector3f> strand(std::size_t i) const {
    return std::span(points).subspan(i * kStations, kStations);
  }

  /// A strand's point at so many metres along it from its root; from its length on its tip.
  [[nodiscard]] Eigen::Vector3f at_arc(std::size_t i, float arc) const {
    const auto line = strand(i);
    const float at = std::min(arc / lengths[i], 1.0f) * float(kStations - 1);
    const auto k = std::min(std::size_t(at), kStations - 2);
    return line[k] + (at - float(k)) * (line[k + 1] - line[k]);
  }
};

/// Around all roots.
[[nodiscard]] Eigen::AlignedBox3f box_of_roots(const EvenStrands& strands);

/// Radius of the sphere that most roots lie on, metres; 0 where they lie on none, or on too little of one.
[[nodiscard]] double scalp_radius_of(const EvenStrands& strands);

/// The end of a strand that grows from the skin, as find_reversed_strands() has it.
[[nodiscard]] inline const Eigen::Vector3f& root_of(const groom::Groom& groom,
                                                    std::span<const std::uint8_t> is_reversed, std::size_t i) {
  return is_reversed[i] != 0 ? groom.strand(i).back() : groom.strand(i).front();
}

/// `width` is for strands whose groom has none. `is_reversed`, empty or one for each strand: it begins with its tip.
[[nodiscard]] EvenStrands even_strands(const groom::Groom& groom, float width,
                                       std::span<const std::uint8_t> is_reversed = {});

/// Which strands begin with their tip, one value for each. Formats that begin with roots need no test. Otherwise: roots
/// lie on a scalp, which is round, tips do not. If the file's order does not separate them as a whole, each strand is
/// judged by the distances of its ends from the sphere that most roots lie on.
[[nodiscard]] std::vector<std::uint8_t> find_reversed_strands(const groom::Groom& groom);

// What shapes of strands are measured by.

/// The value that so much of them stay below, 0..1; 0.5: the median, of an even number the larger of the middle two.
/// There must be some; they change places.
template <typename Value>
[[nodiscard]] Value quantile(std::vector<Value>& values, float share) {
  const auto at = values.begin() + std::ptrdiff_t(share * float(values.size() - 1) + 0.5f);
  std::ranges::nth_element(values, at);
  return *at;
}

}  // namespace coif::cards
