#include "visibility/fragment_view.h"

#include "visibility/hair_surface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

/// Corners are put on a grid this much finer than that of the lines, so that edges are whole numbers: two triangles of a card
/// never both have a line, nor do both miss it.
constexpr int kSteps = 256;

/// First and last multiple of kSteps within low..high, divided by it.
std::int64_t first_line(std::int64_t low) { return (low + kSteps - 1) / kSteps; }
std::int64_t last_line(std::int64_t high) { return high / kSteps; }

/// Rounded, which std::llround() does by a call.
std::int64_t nearest_step(float value) {
  const double above = double(value) + 0.5;
  const auto whole = std::int64_t(above);
  return whole - (above < double(whole) ? 1 : 0);
}

}  // namespace

struct FragmentView::Placed {
  std::uint32_t line;
  Fragment fragment;
};

/// Finds the fragments of one triangle after the other.
class FragmentView::Rasteriser {
 public:
  Rasteriser(const FragmentView& view, const HairSurface& hair, std::span<const Eigen::Vector3f> positions,
             const Projected& projected, const ViewGrid& grid)
      : view_(view),
        hair_(hair),
        positions_(positions),
        grid_(grid),
        covered_from_(view.columns_ * view.rows_, std::numeric_limits<float>::infinity()) {
    corners_.reserve(projected.size());
    for (const Eigen::Array3f& p : projected) corners_.push_back(corner_of(p));
  }

  void draw(std::uint32_t index, std::vector<Placed>& out) {
    const HairSurface::Triangle& triangle = hair_.triangles[index];
    for (int k = 0; k < 3; ++k) corner_[k] = corners_[triangle.vertex[k]];
    if (!find_box()) return;
    const std::int64_t area = edge(corner_[0], corner_[1], corner_[2]);
    if (area == 0 || (area < 0 && !hair_.double_sided)) return;
    base_ = {0, 0, index, triangle.patch, area > 0};
    std::ranges::copy(triangle.vertex, vertex_.begin());
    if (area < 0) {
      std::swap(corner_[1], corner_[2]);
      std::swap(vertex_[1], vertex_[2]);
    }
    area_ = std::abs(area);
    per_area_ = 1 / float(area_);
    is_met_ = false;
    visit_lines(out);
  }

 private:
  struct Corner {
    std::int64_t x = 0, y = 0;
  };

  /// Twice the area of a, b, p; positive when they wind counter-clockwise.
  static std::int64_t edge(const Corner& a, const Corner& b, const Corner& p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }

  /// A line on the edge itself belongs to one of the two triangles that share it: the edge runs the other way in the other.
  static bool owns_edge(const Corner& a, const Corner& b) { return b.y != a.y ? b.y > a.y : b.x < a.x; }

  /// Of the lines that the triangle may meet; false where there is none, as for most of fine hair.
  bool find_box() {
    const Corner &a = corner_[0], &b = corner_[1], &c = corner_[2];
    first_column_ = first_line(std::min(std::min(a.x, b.x), c.x));
    last_column_ = last_line(std::max(std::max(a.x, b.x), c.x));
    if (first_column_ > last_column_) return false;
    first_row_ = first_line(std::min(std::min(a.y, b.y), c.y));
    last_row_ = last_line(std::max(std::max(a.y, b.y), c.y));
    return first_row_ <= last_row_;
  }

  /// What only triangles need that a line meets: of fine hair most are met by none.
  void meet() {
    if (is_met_) return;
    is_met_ = true;
    for (int k = 0; k < 3; ++k) {
      point_[k] = positions_[vertex_[k]];
      uv_[k] = hair_.uvs[vertex_[k]];
    }
    mip_ = mip();
  }

  [[nodiscard]] Corner corner_of(const Eigen::Array3f& p) const {
    const float to_steps = kSteps / view_.spacing_;
    return {nearest_step((p.x() - view_.left_) * to_steps), nearest_step((p.y() - view_.bottom_) * to_steps)};
  }

  /// Texture coordinates are linear in the picture, so their change from pixel to pixel is the same all over a triangle.
  [[nodiscard]] MipChoice mip() const {
    const Eigen::Vector2f du = uv_[1] - uv_[0], dv = uv_[2] - uv_[0];
    const auto along = [&](const Corner& a, const Corner& b) {
      return Eigen::Vector2f(float(b.x - a.x), float(b.y - a.y));
    };
    const Eigen::Vector2f e1 = along(corner_[0], corner_[1]), e2 = along(corner_[0], corner_[2]);
    const float scale = grid_.pixel / view_.spacing_ * kSteps / float(area_);
    return hair_.alpha.choose_mip((du * e2.y() - dv * e1.y()) * scale, (dv * e1.x() - du * e2.x()) * scale);
  }

  void visit_lines(std::vector<Placed>& out) {
    // A line is inside where all three are at least so large; from column to column and row to row they grow evenly.
    std::int64_t inside[3], by_column[3], by_row[3], least[3];
    const Corner start{first_column_ * kSteps, first_row_ * kSteps};
    for (int k = 0; k < 3; ++k) {
      const Corner &a = corner_[(k + 1) % 3], &b = corner_[(k + 2) % 3];
      inside[k] = edge(a, b, start);
      by_column[k] = -(b.y - a.y) * kSteps;
      by_row[k] = (b.x - a.x) * kSteps;
      least[k] = owns_edge(a, b) ? 0 : 1;
    }
    for (std::int64_t row = first_row_; row <= last_row_; ++row) {
      std::int64_t at[3] = {inside[0], inside[1], inside[2]};
      for (std::int64_t column = first_column_; column <= last_column_; ++column) {
        if (at[0] >= least[0] && at[1] >= least[1] && at[2] >= least[2]) visit(column, row, at, out);
        for (int k = 0; k < 3; ++k) at[k] += by_column[k];
      }
      for (int k = 0; k < 3; ++k) inside[k] += by_row[k];
    }
  }

  /// A line that meets the triangle. `inside`: twice the areas that it makes with the edges.
  void visit(std::int64_t column, std::int64_t row, const std::int64_t (&inside)[3], std::vector<Placed>& out) {
    Eigen::Vector3f share;
    for (int k = 0; k < 3; ++k) share[k] = float(inside[k]) * per_area_;
    meet();
    Placed placed{std::uint32_t(row) * std::uint32_t(view_.columns_) + std::uint32_t(column), base_};
    const Eigen::Vector3f point = share[0] * point_[0] + share[1] * point_[1] + share[2] * point_[2];
    placed.fragment.depth = -point.dot(view_.towards_eye_);
    if (placed.fragment.depth > covered_from_[placed.line]) return;
    const Eigen::Vector2f uv = share[0] * uv_[0] + share[1] * uv_[1] + share[2] * uv_[2];
    placed.fragment.alpha = hair_.alpha.at(uv, mip_);
    if (placed.fragment.alpha < grid_.faintest.value_or(hair_.faintest) || placed.fragment.alpha <= 0) return;
    if (placed.fragment.alpha >= grid_.solid_alpha) covered_from_[placed.line] = placed.fragment.depth;
    out.push_back(placed);
  }

  const FragmentView& view_;
  const HairSurface& hair_;
  std::span<const Eigen::Vector3f> positions_;
  const ViewGrid& grid_;
  std::vector<float> covered_from_;  ///< Per line: the nearest solid fragment so far.
  std::vector<Corner> corners_;      ///< Per vertex.
  std::array<std::uint32_t, 3> vertex_{};
  bool is_met_ = false;
  Eigen::Vector3f point_[3];
  Corner corner_[3];
  std::int64_t first_column_ = 0, last_column_ = -1, first_row_ = 0, last_row_ = -1;
  Eigen::Vector2f uv_[3];
  std::int64_t area_ = 1;
  float per_area_ = 1;
  Fragment base_;
  MipChoice mip_;
};

FragmentView::FragmentView(const HairSurface& hair, std::span<const Eigen::Vector3f> positions, const ViewGrid& grid)
    : towards_eye_(grid.towards_eye), spacing_(grid.spacing), solids_(hair.solids) {
  const Eigen::Vector3f upright = std::abs(towards_eye_.y()) < 0.99f ? Eigen::Vector3f(Eigen::Vector3f::UnitY())
                                                                     : Eigen::Vector3f(Eigen::Vector3f::UnitX());
  right_ = upright.cross(towards_eye_).normalized();
  up_ = towards_eye_.cross(right_);
  Projected projected;
  projected.reserve(positions.size());
  for (const Eigen::Vector3f& p : positions) projected.emplace_back(p.dot(right_), p.dot(up_), p.dot(towards_eye_));
  set_extent(hair, projected);
  left_ -= grid.aside;
  bottom_ -= grid.aside;
  std::vector<Placed> placed;
  Rasteriser rasteriser(*this, hair, positions, projected, grid);
  for (const std::uint32_t t : near_to_far(hair, projected)) rasteriser.draw(t, placed);
  sort_into_lines(placed);
}

/// So that what is solid comes before most of what it hides: in slices, each in stored order, for which no sorting is needed.
std::vector<std::uint32_t> FragmentView::near_to_far(const HairSurface& hair, const Projected& projected) {
  constexpr std::uint32_t kSlices = 256;
  float low = std::numeric_limits<float>::max(), high = -low;
  for (const Eigen::Array3f& p : projected) {
    low = std::min(low, p.z());
    high = std::max(high, p.z());
  }
  const float to_slices = high <= low ? 0 : float(kSlices) / (high - low);
  std::vector<std::uint32_t> slice(hair.triangles.size());
  std::array<std::uint32_t, kSlices + 1> begin{};
  for (std::size_t t = 0; t < slice.size(); ++t) {
    const auto& v = hair.triangles[t].vertex;
    const float nearest = std::max({projected[v[0]].z(), projected[v[1]].z(), projected[v[2]].z()});
    slice[t] = std::min(kSlices - 1, std::uint32_t((high - nearest) * to_slices));
    ++begin[slice[t] + 1];
  }
  for (std::size_t s = 1; s < begin.size(); ++s) begin[s] += begin[s - 1];
  std::vector<std::uint32_t> order(slice.size());
  for (std::uint32_t t = 0; t < slice.size(); ++t) order[begin[slice[t]]++] = t;
  return order;
}

void FragmentView::set_extent(const HairSurface& hair, const Projected& projected) {
  constexpr float kFar = std::numeric_limits<float>::max();
  Eigen::Array2f low(kFar, kFar), high(-kFar, -kFar);
  for (const HairSurface::Triangle& triangle : hair.triangles) {
    for (const std::uint32_t v : triangle.vertex) {
      low = low.min(projected[v].head<2>());
      high = high.max(projected[v].head<2>());
    }
  }
  if (hair.triangles.empty()) low = high = Eigen::Array2f::Zero();
  // The first line passes half a step outside: one that touched the outermost corner would say nothing.
  left_ = low.x() - 0.5f * spacing_;
  bottom_ = low.y() - 0.5f * spacing_;
  columns_ = std::size_t(std::ceil((high.x() - left_) / spacing_)) + 1;
  rows_ = std::size_t(std::ceil((high.y() - bottom_) / spacing_)) + 1;
}

void FragmentView::sort_into_lines(std::span<const Placed> placed) {
  begin_.assign(columns_ * rows_ + 1, 0);
  for (const Placed& p : placed) ++begin_[p.line + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  fragments_.resize(placed.size());
  for (const Placed& p : placed) fragments_[next[p.line]++] = p.fragment;
  for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
    const auto line = std::span(fragments_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
    std::ranges::sort(line, {}, [](const Fragment& f) { return std::pair(f.depth, f.triangle); });
  }
}

float FragmentView::solid_depth(std::size_t line) const {
  return coif::solid_depth(solids_, place(line, 0), -towards_eye_);
}

std::array<FragmentView::LineShare, 4> FragmentView::lines_around(const Eigen::Vector3f& point) const {
  const float x = std::clamp((point.dot(right_) - left_) / spacing_, 0.0f, float(columns_ - 1));
  const float y = std::clamp((point.dot(up_) - bottom_) / spacing_, 0.0f, float(rows_ - 1));
  const auto column = std::size_t(x), row = std::size_t(y);
  const std::size_t next_column = std::min(column + 1, columns_ - 1), next_row = std::min(row + 1, rows_ - 1);
  const float right = x - float(column), up = y - float(row);
  return {{{row * columns_ + column, (1 - right) * (1 - up)},
           {row * columns_ + next_column, right * (1 - up)},
           {next_row * columns_ + column, (1 - right) * up},
           {next_row * columns_ + next_column, right * up}}};
}

Eigen::Vector3f FragmentView::place(std::size_t line, float depth) const {
  return (left_ + float(line % columns_) * spacing_) * right_ + (bottom_ + float(line / columns_) * spacing_) * up_ -
         depth * towards_eye_;
}

float FragmentView::transmittance(const Eigen::Vector3f& point, float margin) const {
  const float column = std::round((point.dot(right_) - left_) / spacing_);
  const float row = std::round((point.dot(up_) - bottom_) / spacing_);
  if (!(column >= 0 && column < float(columns_) && row >= 0 && row < float(rows_))) return 1;
  const std::size_t index = std::size_t(row) * columns_ + std::size_t(column);
  const float depth = -point.dot(towards_eye_) - margin;
  if (depth > solid_depth(index)) return 0;
  float passes = 1;
  for (const Fragment& fragment : line(index)) {
    if (fragment.depth >= depth) break;
    passes *= 1 - fragment.alpha;
  }
  return passes;
}

}  // namespace coif
