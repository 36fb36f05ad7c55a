#include "visibility/fragment_view.h"

#include "base/parallel_for.h"

#include <coif/view_cells.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace coif::visibility {
namespace {

constexpr float kUnseen = 1.0f / 1024;
constexpr float kSolid = 0.999f;

}  // namespace

SightLines::SightLines(const FragmentView& view, float solid_alpha) {
  for (std::size_t i = 0; i < view.line_count(); ++i) {
    const auto fragments = view.line(i);
    if (fragments.empty()) continue;
    const float end = view.solid_depth(i);
    if (fragments.front().depth > end) continue;
    ++covered;
    if (fragments.front().alpha >= kSolid) continue;
    float passes = 1;
    for (const Fragment& fragment : fragments) {
      if (fragment.depth > end || passes < kUnseen) break;
      layers.push_back({fragment.alpha, fragment.triangle & 0x7FFFFFFFu, fragment.is_front ? 1u : 0u});
      if (fragment.alpha >= solid_alpha) break;
      passes *= 1 - fragment.alpha;
    }
    begin.push_back(std::uint32_t(layers.size()));
  }
}

namespace {

/// Steps of the additive sequence that fills a square most evenly. Source: Roberts 2018, "The unreasonable
/// effectiveness of quasirandom sequences".
constexpr double kStepX = 0.7548776662466927, kStepY = 0.5698402909980532;

/// Area that the hair covers in a picture, on average over all directions: a quarter of the surface of a convex body
/// (Cauchy's formula). For hair, whose cards hide each other, the box around it is good enough.
double mean_outline(std::span<const Eigen::Vector3f> positions) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : positions) box.extend(p);
  if (box.isEmpty()) return 0;
  const Eigen::Vector3d s = box.sizes().cast<double>();
  return (s.x() * s.y() + s.y() * s.z() + s.z() * s.x()) / 2;
}

}  // namespace

std::uint32_t pose_of_view(std::uint32_t cell, std::uint32_t view, std::size_t poses) {
  if (poses < 2 || (cell + view) % 2 == 0) return 0;
  return 1 + (cell + view) / 2 % std::uint32_t(poses - 1);
}

float line_spacing(std::span<const Eigen::Vector3f> positions, std::size_t lines) {
  return float(std::sqrt(std::max(mean_outline(positions), 1.0e-8) / double(lines)));
}

Eigen::Vector3f direction_in_cell(std::uint32_t cell, std::uint32_t index) {
  constexpr float kEdges[5] = {-1, -kViewCellEdge, 0, kViewCellEdge, 1};
  const auto place = [&](double step, std::uint32_t column) {
    const double share = 0.5 + step * (index + 1.0);
    return kEdges[column] + float(share - std::floor(share)) * (kEdges[column + 1] - kEdges[column]);
  };
  const std::uint32_t axis = cell / 32;
  Eigen::Vector3f direction;
  direction[axis] = cell / 16 % 2 == 0 ? 1.0f : -1.0f;
  direction[(axis + 1) % 3] = place(kStepX, cell % 4);
  direction[(axis + 2) % 3] = place(kStepY, cell / 4 % 4);
  return direction.normalized();
}

SampledView sample_view(const HairSurface& hair, std::span<const HairPositions> poses, const SampleSettings& settings,
                        std::uint32_t cell, std::uint32_t number) {
  const std::uint32_t turn = number + settings.seed;
  const std::uint32_t pose = pose_of_view(cell, turn, poses.size());
  ViewGrid grid;
  grid.towards_eye = direction_in_cell(cell, turn);
  grid.spacing = line_spacing(poses.front(), settings.lines);
  grid.pixel = settings.pixel;
  grid.solid_alpha = settings.solid_alpha;
  grid.past_head = false;
  const FragmentView view(hair, poses[pose], grid);
  return {cell, pose, SightLines(view, settings.solid_alpha)};
}

std::vector<SampledView> sample_cell(const HairSurface& hair, std::span<const HairPositions> poses,
                                     const SampleSettings& settings, std::uint32_t cell) {
  std::vector<SampledView> views;
  for (std::uint32_t i = 0; i < settings.views_per_cell; ++i) {
    views.push_back(sample_view(hair, poses, settings, cell, i));
  }
  return views;
}

std::vector<SampledView> sample_views(const HairSurface& hair, std::span<const HairPositions> poses,
                                      const SampleSettings& settings) {
  std::array<std::vector<SampledView>, kViewCells> of_cell;
  parallel_for(kViewCells, settings.threads,
               [&](std::size_t cell) { of_cell[cell] = sample_cell(hair, poses, settings, std::uint32_t(cell)); });
  std::vector<SampledView> all;
  for (std::vector<SampledView>& views : of_cell) std::ranges::move(views, std::back_inserter(all));
  return all;
}

}  // namespace coif::visibility
