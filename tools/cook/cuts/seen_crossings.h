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

/// A line of sight that meets two triangles of which no order is right all over a picture: they cross there, or lie
/// before each other in turns.
struct CrossingSample {
  std::uint32_t view = 0;
  std::uint32_t near = 0, far = 0;  ///< Triangles of the surface.
  Eigen::Vector3f near_point, far_point;
  float weight = 0;  ///< Squared error of the pixel where these two alone are swapped.
};

/// What no order of whole triangles can draw, seen from all sides at rest.
struct SeenCrossings {
  std::vector<CrossingSample> samples;  ///< By view.
  std::size_t pairs = 0;                ///< Of triangles, each counted once for all views.
  double unavoidable =
      0;            ///< What any order loses of all weights, since it draws one of two triangles first everywhere.
  double lost = 0;  ///< What the orders lose, that included.
};

/// Looks at the hair from all sides for what crosses.
class CrossingSearch {
 public:
  /// Along as many lines, from as many sides at most, and with the threads that `settings` say. `orders`: of all
  /// triangles. Keeps references to the hair and its positions.
  CrossingSearch(const visibility::HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                 const visibility::CellOrders& orders, const visibility::DrawRule& rule,
                 const visibility::SampleSettings& settings);

  /// From so many sides of each cell; those that it was looked at from before are not taken again.
  [[nodiscard]] SeenCrossings look(std::size_t views_per_cell);

  /// Votes of those of its views that orders are found from, too (pose_of_view()). They are not here afterwards.
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
  std::vector<std::vector<std::uint32_t>> places_;  ///< Of each triangle in each order.
  std::vector<View> views_;                         ///< Those of a cell follow each other.
  std::size_t looked_at_ = 0;                       ///< Of each cell.
  std::vector<std::uint32_t> own_;                  ///< Each triangle's own number.
  visibility::RestVotes votes_;
};

}  // namespace coif::cook
