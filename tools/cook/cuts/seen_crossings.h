#pragma once

#include "visibility/fragment_view.h"
#include "visibility/linear_order.h"
#include "visibility/order_error.h"
#include "visibility/rest_votes.h"

#include <coif/view_cells.h>

#include <Eigen/Core>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace coif::cook {

/// A line of sight through two triangles for which no order is right in a whole picture: they cross, or each is in
/// front of the other somewhere.
struct CrossingSample {
  std::uint32_t view = 0;
  std::uint32_t near = 0, far = 0;  ///< Triangles of the surface.
  Eigen::Vector3f near_point, far_point;
  float weight = 0;  ///< Squared error of the pixel where these two alone are swapped.
};

/// The crossings that no order of whole triangles can draw, seen from all sides at rest.
struct SeenCrossings {
  std::vector<CrossingSample> samples;  ///< By view.
  std::size_t pairs = 0;                ///< Pairs of triangles, each counted once for all views.
  /// Loss of any order over all weights, since it draws one of two triangles first everywhere.
  double unavoidable = 0;
  double lost = 0;  ///< Loss of the given orders, which includes `unavoidable`.
};

/// Looks for crossings from all sides.
class CrossingSearch {
 public:
  /// Uses the lines, views and threads of `settings`. `orders`: of all triangles. Keeps references to the hair and its
  /// positions.
  CrossingSearch(const visibility::HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                 const visibility::CellOrders& orders, const visibility::DrawRule& rule,
                 const visibility::SampleSettings& settings);

  /// Looks from this many sides of each cell, without those looked at before.
  [[nodiscard]] SeenCrossings look(std::size_t views_per_cell);

  /// Moves out the votes of those of its views that are also used to find orders (pose_of_view()).
  [[nodiscard]] visibility::RestVotes take_votes() { return std::move(votes_); }

 private:
  struct View {
    std::vector<CrossingSample> samples;
    std::vector<std::uint64_t> crossing;  ///< Pairs of triangles.
    double unavoidable = 0, lost = 0;
  };
  [[nodiscard]] View view_of(std::size_t number);
  [[nodiscard]] View crossings_in(const visibility::FragmentView& view, std::size_t number) const;

  const visibility::HairSurface& hair_;
  std::span<const Eigen::Vector3f> positions_;
  visibility::DrawRule rule_;
  visibility::SampleSettings settings_;
  std::array<std::uint8_t, kViewCells> order_of_;
  std::vector<std::vector<std::uint32_t>> places_;  ///< For each order, the place of each triangle.
  std::vector<View> views_;                         ///< The views of a cell follow each other.
  std::size_t looked_at_ = 0;                       ///< Number of views of each cell that were looked at.
  std::vector<std::uint32_t> own_;                  ///< Each triangle's own number.
  visibility::RestVotes votes_;
};

}  // namespace coif::cook
