#pragma once

#include "visibility/order_clusters.h"
#include "visibility/order_error.h"
#include "visibility/view_samples.h"

#include <vector>

namespace coif {

/// Errors of pictures drawn in some order, expected as squared_error() says; PSNR over the pixels that hair covers, dB.
struct OrderQuality {
  double psnr = 0;    ///< Of all views' pixels.
  double median = 0;  ///< Over the views at rest.
  double worst = 0;   ///< Of the views at rest.
  double moving = 0;  ///< Median over the views in motion; that of those at rest where there are none.
};

/// A few orders of all triangles, and the one that each cell of directions draws with.
struct TriangleOrders {
  std::vector<UnitOrder> orders;
  std::array<std::uint8_t, kViewCells> order_of{};
};

/// All triangles of each unit after those of the unit before it; stored order within.
[[nodiscard]] UnitOrder triangles_in_order(std::span<const std::uint32_t> unit_order,
                                           std::span<const std::uint32_t> unit_of_triangle);

/// Judges orders by views that none of them was found from.
class OrderJudge {
 public:
  explicit OrderJudge(ViewSamples samples, unsigned threads) : samples_(std::move(samples)), threads_(threads) {}

  [[nodiscard]] OrderQuality judge(const TriangleOrders& orders, const DrawRule& rule) const;
  /// The best that any order could do.
  [[nodiscard]] double best_psnr(float opaque_threshold) const;

 private:
  ViewSamples samples_;
  unsigned threads_;
};

}  // namespace coif
