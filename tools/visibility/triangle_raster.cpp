#include "visibility/triangle_raster.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace coif::visibility {
namespace {

/// Corners are put on a grid this much finer than that of the lines, so that edges are integers: two triangles of a
/// card never both have a line, nor do both miss it.
constexpr std::uint32_t kStepBits = 8;
constexpr std::int32_t kSteps = 1 << kStepBits;
constexpr double kMostSteps = 1 << 30;

constexpr float kFar = std::numeric_limits<float>::max();

/// Rounded; places within the grid are above 0.
std::int32_t nearest_step(float value) {
  const double above = double(value) + 0.5;
  return above > 0 ? std::int32_t(above < kMostSteps ? above : kMostSteps) : 0;
}

}  // namespace

ProjectedHair::ProjectedHair(const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                             const GridFrame& axes) {
  points.resize(positions.size());
  if (hair.vertices.empty()) return;
  low.setConstant(kFar);
  high.setConstant(-kFar);
  for (const std::uint32_t v : hair.vertices) {
    const Eigen::Vector3f& p = positions[v];
    const Eigen::Array3f point(p.dot(axes.right), p.dot(axes.up), p.dot(axes.towards_eye));
    points[v] = point;
    low = low.min(point);
    high = high.max(point);
  }
}

TriangleRaster::TriangleRaster(const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
                               const ProjectedHair& projected, const ViewGrid& grid, const GridFrame& frame)
    : hair_(hair),
      positions_(positions),
      projected_(projected),
      grid_(grid),
      frame_(frame),
      solids_(hair.solids, -frame.towards_eye),
      faintest_(grid.faintest.value_or(hair.faintest)),
      depth_slack_(1.0e-5f * std::max(projected.low.abs().maxCoeff(), projected.high.abs().maxCoeff())),
      corners_(projected.points.size()) {
  const float to_steps = float(kSteps) / frame.spacing;
  for (const std::uint32_t v : hair.vertices) {
    const Eigen::Array3f& p = projected.points[v];
    corners_[v] = {nearest_step((p.x() - frame.left) * to_steps), nearest_step((p.y() - frame.bottom) * to_steps),
                   p.z()};
  }
  const std::size_t lines = frame.columns * frame.rows;
  if (grid.past_head) {
    covered_from_.assign(lines, std::numeric_limits<float>::infinity());
  } else {
    covered_from_.assign(lines, std::numeric_limits<float>::quiet_NaN());
    solid_depth_.resize(lines);
  }
}

std::vector<PlacedFragment> TriangleRaster::run() {
  const std::vector<Met> order = near_to_far(met_triangles());
  // From near to far they are scattered in memory.
  constexpr std::size_t kAhead = 16;
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i + 2 * kAhead < order.size()) __builtin_prefetch(&hair_.triangles[order[i + 2 * kAhead].triangle]);
    if (i + kAhead < order.size()) {
      for (const std::uint32_t v : hair_.triangles[order[i + kAhead].triangle].vertex) __builtin_prefetch(&corners_[v]);
    }
    draw(order[i]);
  }
  return std::move(placed_);
}

/// Twice the area of a, b and the point; positive when they wind counter-clockwise.
std::int64_t TriangleRaster::edge(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y) {
  return std::int64_t(b.x - a.x) * (y - a.y) - std::int64_t(b.y - a.y) * (x - a.x);
}

/// A line on the edge itself belongs to one of the two triangles that share it: the edge runs the other way in the
/// other.
bool TriangleRaster::owns_edge(const Corner& a, const Corner& b) { return b.y != a.y ? b.y > a.y : b.x < a.x; }

/// Triangles with lines in their boxes: in fine hair most have none.
std::vector<TriangleRaster::Met> TriangleRaster::met_triangles() const {
  std::vector<Met> met(hair_.triangles.size());
  const auto least = [](auto a, auto b, auto c) { return std::min(std::min(a, b), c); };
  const auto most = [](auto a, auto b, auto c) { return std::max(std::max(a, b), c); };
  std::size_t count = 0;
  for (std::uint32_t t = 0; t < met.size(); ++t) {
    const auto& v = hair_.triangles[t].vertex;
    const Corner &a = corners_[v[0]], &b = corners_[v[1]], &c = corners_[v[2]];
    Met& each = met[count];
    each.triangle = t;
    each.nearest = -most(a.nearness, b.nearness, c.nearness);
    each.first_column = (least(a.x, b.x, c.x) + kSteps - 1) >> kStepBits;
    each.last_column = most(a.x, b.x, c.x) >> kStepBits;
    each.first_row = (least(a.y, b.y, c.y) + kSteps - 1) >> kStepBits;
    each.last_row = most(a.y, b.y, c.y) >> kStepBits;
    count += each.first_column <= each.last_column && each.first_row <= each.last_row ? 1 : 0;
  }
  met.resize(count);
  return met;
}

/// Sorts solid triangles from near to far in slices, so that most hidden triangles come after those that hide them.
/// Each slice keeps the stored order, in which neighbours share memory.
std::vector<TriangleRaster::Met> TriangleRaster::near_to_far(const std::vector<Met>& met) const {
  constexpr std::uint32_t kSlices = 64;
  const float low = projected_.low.z(), high = projected_.high.z();
  const float to_slices = high <= low ? 0 : float(kSlices) / (high - low);
  const auto slice_of = [&](const Met& each) {
    return std::min(kSlices - 1, std::uint32_t((high + each.nearest) * to_slices));
  };
  std::array<std::uint32_t, kSlices + 1> begin{};
  for (const Met& each : met) ++begin[slice_of(each) + 1];
  for (std::size_t s = 1; s < begin.size(); ++s) begin[s] += begin[s - 1];
  std::vector<Met> sorted(met.size());
  for (const Met& each : met) sorted[begin[slice_of(each)]++] = each;
  return sorted;
}

/// The value of a line, computed at the first use: many lines meet nothing.
float& TriangleRaster::covered_from(std::size_t line) {
  float& covered = covered_from_[line];
  if (std::isnan(covered)) {
    covered = solid_depth_[line] = solids_.depth(frame_.place(line, 0));
  }
  return covered;
}

/// Whether all lines of the box end before the triangle begins: most of thick hair is under other hair.
bool TriangleRaster::is_covered(const Met& box, float nearest) {
  constexpr std::int64_t kMostLines = 16;
  if (std::int64_t(box.last_column - box.first_column + 1) * (box.last_row - box.first_row + 1) > kMostLines) {
    return false;
  }
  for (std::int32_t row = box.first_row; row <= box.last_row; ++row) {
    for (std::int32_t column = box.first_column; column <= box.last_column; ++column) {
      if (nearest <= covered_from(std::size_t(row) * frame_.columns + std::size_t(column))) return false;
    }
  }
  return true;
}

void TriangleRaster::draw(const Met& met) {
  const HairSurface::Triangle& triangle = hair_.triangles[met.triangle];
  const Met& box = met;
  nearest_ = met.nearest - depth_slack_;
  if (is_covered(box, nearest_)) return;
  for (int k = 0; k < 3; ++k) corner_[k] = corners_[triangle.vertex[k]];
  const std::int64_t area = edge(corner_[0], corner_[1], corner_[2].x, corner_[2].y);
  if (area == 0 || (area < 0 && !hair_.double_sided)) return;
  base_ = {0, 0, met.triangle, triangle.patch, area > 0};
  std::ranges::copy(triangle.vertex, vertex_.begin());
  if (area < 0) {
    std::swap(corner_[1], corner_[2]);
    std::swap(vertex_[1], vertex_[2]);
  }
  area_ = std::abs(area);
  per_area_ = 1 / float(area_);
  is_met_ = false;
  visit_lines(box);
}

/// Sets up the data of a triangle when a line inside its box first meets the triangle itself.
void TriangleRaster::meet() {
  is_met_ = true;
  for (int k = 0; k < 3; ++k) {
    point_[k] = positions_[vertex_[k]];
    uv_[k] = hair_.uvs[vertex_[k]];
  }
  mip_ = mip();
}

/// Texture coordinates are linear in the picture, so their change from pixel to pixel is the same all over a triangle.
MipChoice TriangleRaster::mip() const {
  const Eigen::Vector2f du = uv_[1] - uv_[0], dv = uv_[2] - uv_[0];
  const auto along = [](const Corner& a, const Corner& b) {
    return Eigen::Vector2f(float(b.x - a.x), float(b.y - a.y));
  };
  const Eigen::Vector2f e1 = along(corner_[0], corner_[1]), e2 = along(corner_[0], corner_[2]);
  const float scale = grid_.pixel / frame_.spacing * float(kSteps) / float(area_);
  return hair_.alpha.choose_mip((du * e2.y() - dv * e1.y()) * scale, (dv * e1.x() - du * e2.x()) * scale);
}

void TriangleRaster::visit_lines(const Met& box) {
  // A line is inside where none of the three areas is negative; from column to column and row to row they grow evenly.
  Areas inside, by_column, by_row;
  for (std::size_t k = 0; k < 3; ++k) {
    const Corner &a = corner_[(k + 1) % 3], &b = corner_[(k + 2) % 3];
    inside[k] = edge(a, b, std::int64_t(box.first_column) * kSteps, std::int64_t(box.first_row) * kSteps);
    owns_[k] = owns_edge(a, b);
    if (!owns_[k]) --inside[k];  // Then a line on the edge is outside.
    by_column[k] = -std::int64_t(b.y - a.y) * kSteps;
    by_row[k] = std::int64_t(b.x - a.x) * kSteps;
  }
  const auto columns = std::size_t(box.last_column - box.first_column + 1);
  const bool is_small = columns * std::size_t(box.last_row - box.first_row + 1) <= kFewLines;
  std::size_t line = std::size_t(box.first_row) * frame_.columns + std::size_t(box.first_column);
  inside_count_ = 0;
  for (std::int32_t row = box.first_row; row <= box.last_row; ++row) {
    if (is_small) {
      note_row(line, columns, inside, by_column);
    } else {
      visit_row(line, columns, inside, by_column);
    }
    line += frame_.columns;
    for (std::size_t k = 0; k < 3; ++k) inside[k] += by_row[k];
  }
  for (std::size_t i = 0; i < inside_count_; ++i) visit(inside_[i].line, inside_[i].areas);
}

/// Most triangles have some lines in their boxes and fewer inside, and no branch predicts where they begin. So all are
/// written, and those inside are kept.
void TriangleRaster::note_row(std::size_t line, std::size_t columns, Areas at, const Areas& by_column) {
  std::size_t count = inside_count_;
  for (std::size_t column = 0; column < columns; ++column) {
    inside_[count] = {line + column, at};
    count += (at[0] | at[1] | at[2]) >= 0 ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k) at[k] += by_column[k];
  }
  inside_count_ = count;
}

void TriangleRaster::visit_row(std::size_t line, std::size_t columns, Areas at, const Areas& by_column) {
  std::size_t column = 0;
  const auto go_on = [&] {
    for (std::size_t k = 0; k < 3; ++k) at[k] += by_column[k];
    ++column;
  };
  while (column < columns && (at[0] | at[1] | at[2]) < 0) go_on();
  for (; column < columns && (at[0] | at[1] | at[2]) >= 0; go_on()) visit(line + column, at);
}

/// Adds a line that meets the triangle. `inside`: twice the areas between it and the edges, minus 1 for edges that are
/// not owned.
void TriangleRaster::visit(std::size_t line, const Areas& inside) {
  float& covered = covered_from(line);
  if (nearest_ > covered) return;
  if (!is_met_) meet();
  Eigen::Vector3f share;
  for (std::size_t k = 0; k < 3; ++k) share[Eigen::Index(k)] = float(inside[k] + (owns_[k] ? 0 : 1)) * per_area_;
  PlacedFragment placed{std::uint32_t(line), base_};
  const Eigen::Vector3f point = share[0] * point_[0] + share[1] * point_[1] + share[2] * point_[2];
  placed.fragment.depth = -point.dot(frame_.towards_eye);
  if (placed.fragment.depth > covered) return;
  const Eigen::Vector2f uv = share[0] * uv_[0] + share[1] * uv_[1] + share[2] * uv_[2];
  placed.fragment.alpha = hair_.alpha.at(uv, mip_);
  if (placed.fragment.alpha < faintest_ || placed.fragment.alpha <= 0) return;
  if (placed.fragment.alpha >= grid_.solid_alpha) covered = placed.fragment.depth;
  placed_.push_back(placed);
}

}  // namespace coif::visibility
