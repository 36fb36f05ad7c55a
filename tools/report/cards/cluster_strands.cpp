#include "cards/cluster_points.h"
#include "report/cards/baseline_cards.h"

#include <algorithm>

namespace coif::report {
namespace {

/// Strands as places among all strands.
using StrandShapes = cards::PointClusters<3 * cards::EvenStrands::kStations>;

StrandShapes::Point shape_at(const cards::EvenStrands& strands, std::uint32_t i) {
  StrandShapes::Point shape;
  const auto points = strands.strand(i);
  for (std::size_t k = 0; k < points.size(); ++k)
    std::copy_n(points[k].data(), 3, shape.begin() + std::ptrdiff_t(3 * k));
  return shape;
}

}  // namespace

std::vector<std::vector<std::uint32_t>> cluster_strands(const cards::EvenStrands& strands, std::size_t count,
                                                        const platform::Threads& threads) {
  std::vector<StrandShapes::Point> shapes(strands.count());
  for (std::uint32_t i = 0; i < shapes.size(); ++i) shapes[i] = shape_at(strands, i);
  return StrandShapes::find(shapes, count, threads);
}

}  // namespace coif::report
