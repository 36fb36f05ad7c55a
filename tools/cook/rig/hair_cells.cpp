#include "cook/rig/hair_cells.h"

#include "cook/select/mesh_topology.h"
#include "payload_hash.h"
#include "platform/stop.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr double kMostCells = 40000;  ///< More would not move differently, only take longer.
constexpr double kMostSteps = 1.0e6;  ///< Samples along the longest edges: a mesh of needles has them without area.
constexpr double kSampleStep = 0.75;  ///< Share of a cell: no cube between two samples is missed.
/// Share of its triangle's area: a vertex's cell exists even where no sample is.
constexpr double kVertexShare = 0.01;
constexpr double kSmallestArea = 1e-14;  ///< Gives triangles without area a middle, too.

struct IndexHash {
  std::size_t operator()(const HairCells::Index& index) const {
    return std::size_t(xxh64(std::as_bytes(std::span(index))));
  }
};

struct Corner {
  Vector3d position;
  Vector3d strand;
  double place;
};

Corner corner_at(const HairStrips& hair, std::uint32_t v) {
  const StrandField& strands = hair.strands;
  return {hair.mesh.positions[v].cast<double>(), strands.tangent[v].cast<double>(), double(strands.place[v])};
}

/// Corners of a triangle, the longest edge first.
std::array<Corner, 3> corners(const HairStrips& hair, std::size_t t) {
  std::array<Corner, 3> c;
  for (std::size_t k = 0; k < 3; ++k) c[k] = corner_at(hair, hair.mesh.triangles[3 * t + k]);
  std::size_t longest = 0;
  double most = -1;
  for (std::size_t k = 0; k < 3; ++k) {
    const double length = (c[(k + 1) % 3].position - c[k].position).squaredNorm();
    if (length > most) longest = k;
    most = std::max(most, length);
  }
  std::ranges::rotate(c, c.begin() + std::ptrdiff_t(longest));
  return c;
}

Corner between(const Corner& a, const Corner& b, double share) {
  return {a.position + share * (b.position - a.position), a.strand + share * (b.strand - a.strand),
          a.place + share * (b.place - a.place)};
}

class CellBuilder {
 public:
  CellBuilder(const HairStrips& hair, const std::vector<bool>& movable, const Vector3d& origin, double size,
              const std::stop_token& stop)
      : hair_(hair), movable_(movable), stop_(stop) {
    cells_.origin = origin;
    cells_.size = std::max({size, std::sqrt(total_area() / kMostCells), total_length() / kMostSteps});
    cells_.of_vertex.assign(hair.mesh.positions.size(), importer::kNoIndex);
  }

  HairCells build() && {
    for (std::size_t t = 0; t < hair_.mesh.triangle_count(); ++t) {
      if (movable_[t]) add_triangle(t);
    }
    for (std::size_t c = 0; c < cells_.count(); ++c) {
      cells_.middle[c] /= cells_.area[c];
      cells_.strand[c] /= cells_.area[c];
      cells_.place[c] /= cells_.area[c];
    }
    link();
    return std::move(cells_);
  }

 private:
  [[nodiscard]] double total_area() const {
    double sum = 0;
    for (std::size_t t = 0; t < hair_.mesh.triangle_count(); ++t) {
      const auto c = corners(hair_, t);
      sum += 0.5 * (c[1].position - c[0].position).cross(c[2].position - c[0].position).norm();
    }
    return sum;
  }

  [[nodiscard]] double total_length() const {
    double sum = 0;
    for (std::size_t t = 0; t < hair_.mesh.triangle_count(); ++t) {
      const auto c = corners(hair_, t);
      sum += (c[1].position - c[0].position).norm();
    }
    return sum;
  }

  std::uint32_t add(const Corner& sample, double area) {
    // Cubes lie around multiples of the size: a mirrored model then has mirrored cubes, seam included.
    const Vector3d at = (sample.position - cells_.origin) / cells_.size;
    const HairCells::Index index{std::llround(at.x()), std::llround(at.y()), std::llround(at.z())};
    const auto [entry, is_new] = cell_at_.try_emplace(index, std::uint32_t(cells_.count()));
    if (is_new) {
      cells_.index.push_back(index);
      cells_.middle.push_back(Vector3d::Zero());
      cells_.strand.push_back(Vector3d::Zero());
      cells_.place.push_back(0);
      cells_.area.push_back(0);
    }
    const std::uint32_t cell = entry->second;
    cells_.middle[cell] += area * sample.position;
    cells_.strand[cell] += area * sample.strand;
    cells_.place[cell] += area * sample.place;
    cells_.area[cell] += area;
    return cell;
  }

  void add_triangle(std::size_t t) {
    const auto [a, b, c] = corners(hair_, t);
    const Vector3d edge = b.position - a.position;
    const double doubled = edge.cross(c.position - a.position).norm(), base = edge.norm();
    const double step = kSampleStep * cells_.size;
    const auto columns = std::max(1, int(std::ceil(base / step)));
    const auto rows = base > 0 ? std::max(1, int(std::ceil(doubled / base / step))) : 1;
    for (int row = 0; row < rows; ++row) {
      platform::throw_if_stopped(stop_);
      const double up = (row + 0.5) / rows;
      for (int column = 0; column < columns; ++column) {
        const Corner sample = between(between(a, b, (column + 0.5) / columns), c, up);
        add(sample, (1 - up) * doubled / (rows * columns) + kSmallestArea);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t v = hair_.mesh.triangles[3 * t + k];
      cells_.of_vertex[v] = add(corner_at(hair_, v), kVertexShare * doubled + kSmallestArea);
    }
  }

  void link() {
    cells_.link_begin.push_back(0);
    for (std::uint32_t c = 0; c < cells_.count(); ++c) {
      for (int n = 0; n < 27; ++n) {
        const HairCells::Index& home = cells_.index[c];
        const auto found = cell_at_.find({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1});
        if (found == cell_at_.end() || found->second == c) continue;
        cells_.links.push_back({found->second, (cells_.middle[found->second] - cells_.middle[c]).norm()});
      }
      cells_.link_begin.push_back(std::uint32_t(cells_.links.size()));
    }
  }

  const HairStrips& hair_;
  const std::vector<bool>& movable_;
  const std::stop_token& stop_;
  std::unordered_map<HairCells::Index, std::uint32_t, IndexHash> cell_at_;
  HairCells cells_;
};

/// The quadratic B-spline: 0.75 in the middle, 0 from 1.5 on.
double spline(double x) {
  x = std::abs(x);
  if (x >= 1.5) return 0;
  return x <= 0.5 ? 0.75 - x * x : 0.5 * (1.5 - x) * (1.5 - x);
}

}  // namespace

double HairCells::share_at(std::uint32_t cell, const Vector3d& point) const {
  const Vector3d at = (point - origin) / size;
  double share = 1;
  for (int k = 0; k < 3; ++k) share *= spline(at[k] - double(index[cell][std::size_t(k)]));
  return share;
}

HairCells make_hair_cells(const HairStrips& hair, const std::vector<bool>& movable, const Vector3d& origin, double size,
                          const std::stop_token& stop) {
  return CellBuilder(hair, movable, origin, size, stop).build();
}

namespace {

using Cube = std::array<std::int64_t, 3>;

/// Cells by cubes of the reach: whatever is within it is in the 27 cubes around.
class ReachGrid {
 public:
  ReachGrid(const HairCells& cells, double reach) : cells_(cells), reach_(reach) {
    for (std::uint32_t c = 0; c < cells.count(); ++c) members_[cube_of(c)].push_back(c);
  }

  /// The nearest cell of another piece within reach; length 0 and kNoIndex without any.
  [[nodiscard]] CellLink nearest_of_others(std::uint32_t cell, const std::vector<std::uint32_t>& piece) const {
    CellLink best{importer::kNoIndex, reach_};
    const Cube home = cube_of(cell);
    for (int n = 0; n < 27; ++n) {
      const auto cube = members_.find({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1});
      if (cube == members_.end()) continue;
      for (std::uint32_t other : cube->second) {
        if (piece[other] == piece[cell]) continue;
        const double distance = (cells_.middle[other] - cells_.middle[cell]).norm();
        if (distance < best.length) best = {other, distance};
      }
    }
    return best;
  }

 private:
  [[nodiscard]] Cube cube_of(std::uint32_t cell) const {
    const Eigen::Vector3d at = (cells_.middle[cell] - cells_.origin) / reach_;
    return {std::llround(at.x()), std::llround(at.y()), std::llround(at.z())};
  }

  const HairCells& cells_;
  double reach_;
  std::map<Cube, std::vector<std::uint32_t>> members_;
};

void add_links(HairCells& cells, const std::vector<std::pair<std::uint32_t, CellLink>>& added) {
  std::vector<std::vector<CellLink>> of_cell(cells.count());
  for (const auto& [from, link] : added) {
    of_cell[from].push_back(link);
    of_cell[link.to].push_back({from, link.length});
  }
  std::vector<CellLink> links;
  std::vector<std::uint32_t> begin{0};
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    const auto before = cells.links_of(c);
    links.insert(links.end(), before.begin(), before.end());
    links.insert(links.end(), of_cell[c].begin(), of_cell[c].end());
    begin.push_back(std::uint32_t(links.size()));
  }
  cells.links = std::move(links);
  cells.link_begin = std::move(begin);
}

}  // namespace

std::vector<std::uint32_t> connected_pieces(const HairCells& cells) {
  DisjointSets sets(cells.count());
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    for (const CellLink& link : cells.links_of(c)) sets.unite(c, link.to);
  }
  std::vector<std::uint32_t> piece(cells.count());
  for (std::uint32_t c = 0; c < cells.count(); ++c) piece[c] = sets.find(c);
  return piece;
}

void bridge_pieces(HairCells& cells, const std::vector<bool>& is_root, double reach) {
  const std::vector<std::uint32_t> piece = connected_pieces(cells);
  const ReachGrid grid(cells, reach);
  std::vector<std::pair<std::uint32_t, CellLink>> bridges;
  for (std::uint32_t c = 0; c < cells.count(); ++c) {
    if (!is_root[c]) continue;
    const CellLink link = grid.nearest_of_others(c, piece);
    if (link.to != importer::kNoIndex) bridges.emplace_back(c, link);
  }
  if (!bridges.empty()) add_links(cells, bridges);
}

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
