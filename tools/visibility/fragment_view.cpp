#include "visibility/fragment_view.h"

#include "visibility/hair_surface.h"
#include "visibility/triangle_raster.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif::visibility {
namespace {

GridFrame axes_towards(const Eigen::Vector3f& towards_eye) {
  const Eigen::Vector3f upright = std::abs(towards_eye.y()) < 0.99f ? Eigen::Vector3f(Eigen::Vector3f::UnitY())
                                                                    : Eigen::Vector3f(Eigen::Vector3f::UnitX());
  GridFrame frame;
  frame.towards_eye = towards_eye;
  frame.right = upright.cross(towards_eye).normalized();
  frame.up = towards_eye.cross(frame.right);
  return frame;
}

void set_lines(const ViewGrid& grid, const ProjectedHair& hair, GridFrame& frame) {
  frame.spacing = grid.spacing;
  // The first line lies half a step outside: one that touched the outermost corner would see nothing.
  frame.left = hair.low.x() - 0.5f * frame.spacing;
  frame.bottom = hair.low.y() - 0.5f * frame.spacing;
  frame.columns = std::size_t(std::ceil((hair.high.x() - frame.left) / frame.spacing)) + 1;
  frame.rows = std::size_t(std::ceil((hair.high.y() - frame.bottom) / frame.spacing)) + 1;
  frame.left -= grid.aside;
  frame.bottom -= grid.aside;
}

}  // namespace

FragmentView::FragmentView(const HairSurface& hair, std::span<const Eigen::Vector3f> positions, const ViewGrid& grid)
    : frame_(axes_towards(grid.towards_eye)), solids_(hair.solids) {
  const ProjectedHair projected(hair, positions, frame_);
  set_lines(grid, projected, frame_);
  TriangleRaster raster(hair, positions, projected, grid, frame_);
  sort_into_lines(raster.run());
  solid_depth_ = raster.take_solid_depth();
}

void FragmentView::sort_into_lines(std::span<const PlacedFragment> placed) {
  begin_.assign(frame_.columns * frame_.rows + 1, 0);
  for (const PlacedFragment& p : placed) ++begin_[p.line + 1];
  for (std::size_t i = 1; i < begin_.size(); ++i) begin_[i] += begin_[i - 1];
  std::vector<std::uint32_t> next(begin_.begin(), begin_.end() - 1);
  fragments_.resize(placed.size());
  for (const PlacedFragment& p : placed) fragments_[next[p.line]++] = p.fragment;
  for (std::size_t i = 0; i + 1 < begin_.size(); ++i) {
    const auto line = std::span(fragments_).subspan(begin_[i], begin_[i + 1] - begin_[i]);
    std::ranges::sort(line, {}, [](const Fragment& f) { return std::pair(f.depth, f.triangle); });
  }
}

float FragmentView::solid_depth(std::size_t line) const {
  if (!solid_depth_.empty() && !this->line(line).empty()) return solid_depth_[line];
  return coif::visibility::solid_depth(solids_, place(line, 0), -frame_.towards_eye);
}

std::array<FragmentView::LineShare, 4> FragmentView::lines_around(const Eigen::Vector3f& point) const {
  const float x = std::clamp((point.dot(frame_.right) - frame_.left) / frame_.spacing, 0.0f, float(frame_.columns - 1));
  const float y = std::clamp((point.dot(frame_.up) - frame_.bottom) / frame_.spacing, 0.0f, float(frame_.rows - 1));
  const auto column = std::size_t(x), row = std::size_t(y);
  const std::size_t next_column = std::min(column + 1, frame_.columns - 1),
                    next_row = std::min(row + 1, frame_.rows - 1);
  const float right = x - float(column), up = y - float(row);
  return {{{row * frame_.columns + column, (1 - right) * (1 - up)},
           {row * frame_.columns + next_column, right * (1 - up)},
           {next_row * frame_.columns + column, (1 - right) * up},
           {next_row * frame_.columns + next_column, right * up}}};
}

float FragmentView::transmittance(const Eigen::Vector3f& point, float margin) const {
  const float column = std::round((point.dot(frame_.right) - frame_.left) / frame_.spacing);
  const float row = std::round((point.dot(frame_.up) - frame_.bottom) / frame_.spacing);
  if (!(column >= 0 && column < float(frame_.columns) && row >= 0 && row < float(frame_.rows))) return 1;
  const std::size_t index = std::size_t(row) * frame_.columns + std::size_t(column);
  const float depth = -point.dot(frame_.towards_eye) - margin;
  if (depth > solid_depth(index)) return 0;
  float passes = 1;
  for (const Fragment& fragment : line(index)) {
    if (fragment.depth >= depth) break;
    passes *= 1 - fragment.alpha;
  }
  return passes;
}

}  // namespace coif::visibility
