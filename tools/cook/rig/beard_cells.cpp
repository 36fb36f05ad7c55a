#include "cook/rig/hair_cells.h"

#include <cmath>

namespace coif::cook {
namespace {

/// Shares of the radii from the centre: the highest and the rearmost of a beard, how far before the centre and how wide
/// its larger part lies, and how far down it lies on jaw and chin.
constexpr double kBeardTop = 0.45, kBeardBack = -0.25, kBeforeFace = 0.3, kJawWidth = 0.8, kBelowChin = 1.75;

}  // namespace

std::vector<std::uint32_t> cells_on_jaw(const HairCells& cells, const FittedHead& head) {
  const std::vector<std::uint32_t> piece = connected_pieces(cells);
  std::vector<double> area(cells.count(), 0), before_face(cells.count(), 0);  // by the piece's number
  std::vector<bool> is_beard(cells.count(), true);
  const auto on_head = [&](std::uint32_t c) {
    Eigen::Vector3d p = (cells.middle[c] - head.center).cwiseQuotient(head.radii);
    return head.faces_backwards ? Eigen::Vector3d(-p.x(), p.y(), -p.z()) : p;
  };
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    const Eigen::Vector3d p = on_head(c);
    area[piece[c]] += cells.area[c];
    if (p.z() > kBeforeFace && std::abs(p.x()) < kJawWidth) before_face[piece[c]] += cells.area[c];
    if (p.y() > kBeardTop || p.z() < kBeardBack) is_beard[piece[c]] = false;
  }
  std::vector<std::uint32_t> found;
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    const bool lies_on_face = is_beard[piece[c]] && before_face[piece[c]] > 0.5 * area[piece[c]];
    if (lies_on_face && on_head(c).y() > -kBelowChin) found.push_back(c);
  }
  return found;
}

}  // namespace coif::cook
