#pragma once

#include "platform/stop.h"
#include "visibility/hair_surface.h"

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace coif::visibility {

/// A picture without perspective, looked at along a grid of lines.
struct ViewGrid {
  Eigen::Vector3f towards_eye = Eigen::Vector3f::UnitZ();  ///< Unit, head space.
  float spacing = 0.004f;                                  ///< Metres between neighbouring lines.
  float pixel = 0.001f;   ///< Metres: size of a pixel in the pictures that the view stands for; it chooses the mips.
  float solid_alpha = 2;  ///< Fragments behind one of at least this alpha are left out; above 1 all are there.
  std::optional<float> faintest = {};  ///< Instead of the hair's own: fainter fragments are left out.
  float aside = 0;                     ///< Metres by which all lines are moved to the left and down, 0..spacing / 2.
  bool past_head = true;               ///< False: fragments behind the head are left out, too.
};

/// The lines of a view: through a plane that faces the eye, in an integer number of columns and rows.
struct GridFrame {
  Eigen::Vector3f right, up, towards_eye;  ///< Unit.
  float spacing = 1;
  float left = 0, bottom = 0;  ///< The first line, along right and up.
  std::size_t columns = 0, rows = 0;

  /// A point of a line, head space.
  [[nodiscard]] Eigen::Vector3f place(std::size_t line, float depth) const {
    const std::size_t column = line % columns, row = line / columns;
    return (left + float(column) * spacing) * right + (bottom + float(row) * spacing) * up - depth * towards_eye;
  }
};

/// An intersection of a line with a triangle of the hair.
struct Fragment {
  float depth = 0;             ///< Metres along the line away from the eye; 0 in the plane through the head's joint.
  float alpha = 0;             ///< faintest..1.
  std::uint32_t triangle = 0;  ///< Index into HairSurface::triangles.
  std::uint32_t patch = 0;
  bool is_front = false;  ///< The triangle winds counter-clockwise as seen.
};

struct PlacedFragment;

/// All fragments of the hair along each line of a grid, nearest first, including hidden ones unless the grid says
/// otherwise: a software A-buffer (Carpenter 1984, "The A-buffer, an antialiased hidden surface method"). The same bits
/// on every machine and for every number of views made at a time; fragments at equal depth are in the order of their
/// triangles.
///
/// One-sided hair has no back faces here.
class FragmentView {
 public:
  /// Draws the hair with its vertices at `positions` (posed_positions()). Keeps no reference.
  FragmentView(const HairSurface& hair, std::span<const Eigen::Vector3f> positions, const ViewGrid& grid);

  [[nodiscard]] std::size_t line_count() const { return begin_.size() - 1; }
  [[nodiscard]] std::span<const Fragment> line(std::size_t index) const {
    return std::span(fragments_).subspan(begin_[index], begin_[index + 1] - begin_[index]);
  }
  /// The depth of the head, which hides everything behind it; infinity where the line misses it.
  [[nodiscard]] float solid_depth(std::size_t line) const;

  struct LineShare {
    std::size_t line;
    float share;  ///< 0..1; the four around a point add up to 1.
  };
  /// The four lines around a point, for averages that change smoothly; for points outside, where there is no hair,
  /// those at the grid's edge.
  [[nodiscard]] std::array<LineShare, 4> lines_around(const Eigen::Vector3f& point) const;

  /// A point of a line, head space.
  [[nodiscard]] Eigen::Vector3f place(std::size_t line, float depth) const { return frame_.place(line, depth); }

  /// Share of the light from the eye's side that reaches a point, on the line nearest to it: the product of 1 - alpha
  /// of all fragments more than `margin` metres nearer to the eye than the point, 0 behind the head, 1 outside the
  /// grid. A point of the hair itself needs a margin, or its own card shades it.
  [[nodiscard]] float transmittance(const Eigen::Vector3f& point, float margin) const;

 private:
  void sort_into_lines(std::span<const PlacedFragment> placed);

  GridFrame frame_;
  std::vector<std::uint32_t> begin_ = {0};  ///< Per line and one more: its first fragment.
  std::vector<Fragment> fragments_;
  std::vector<ColliderRecord> solids_;
  std::vector<float> solid_depth_;  ///< For lines with fragments, if nothing behind the head is needed; else empty.
};

/// The part of a fragment that matters for drawing order.
struct Layer {
  float alpha = 0;
  std::uint32_t triangle : 31 = 0;
  std::uint32_t is_front : 1 = 0;
};

/// Lines of one view on which the order of drawing can matter, each with its layers, nearest first. Layers behind the
/// head are left out, and so are those behind a layer of at least the view's solid_alpha, or from which less than a
/// thousandth of the light comes.
struct SightLines {
  SightLines() = default;
  SightLines(const FragmentView& view, float solid_alpha);

  [[nodiscard]] std::size_t size() const { return begin.size() - 1; }
  [[nodiscard]] std::span<const Layer> line(std::size_t index) const {
    return std::span(layers).subspan(begin[index], begin[index + 1] - begin[index]);
  }

  std::vector<std::uint32_t> begin = {0};  ///< Per line and one more: its first layer.
  std::vector<Layer> layers;
  std::size_t covered = 0;  ///< Lines of the view that meet hair, also those left out here.
};

/// Hair in one pose.
using HairPositions = std::vector<Eigen::Vector3f>;

/// The hair from one side in one of several poses; orders are found or judged by it.
struct SampledView {
  std::uint32_t cell = 0;  ///< The cell of its direction.
  std::uint32_t pose = 0;
  SightLines lines;
};

struct SampleSettings {
  std::size_t views_per_cell = 1;
  std::uint32_t seed = 0;         ///< Other seeds look from other directions.
  std::size_t lines = 3000;       ///< Wanted per view.
  float solid_alpha = 0.95f;      ///< Layers behind one of at least this alpha do not matter.
  float pixel = 0.001f;           ///< Metres; as ViewGrid.
  platform::Threads threads = 1;  ///< Number of threads that sample views; the result does not depend on it.
};

/// Distance between lines of sight, metres, with which about this many of them meet hair in this pose.
[[nodiscard]] float line_spacing(std::span<const Eigen::Vector3f> positions, std::size_t lines);

/// The pose that a cell's view is taken in.
[[nodiscard]] std::uint32_t pose_of_view(std::uint32_t cell, std::uint32_t view, std::size_t poses);

/// The view of a cell with that number, of settings.views_per_cell.
[[nodiscard]] SampledView sample_view(const HairSurface& hair, std::span<const HairPositions> poses,
                                      const SampleSettings& settings, std::uint32_t cell, std::uint32_t number);

/// Views in directions that fill a cell evenly. They take the poses in turn; every cell begins with another one, and
/// the first pose, at rest, comes every other time.
[[nodiscard]] std::vector<SampledView> sample_cell(const HairSurface& hair, std::span<const HairPositions> poses,
                                                   const SampleSettings& settings, std::uint32_t cell);

/// The views of all cells.
[[nodiscard]] std::vector<SampledView> sample_views(const HairSurface& hair, std::span<const HairPositions> poses,
                                                    const SampleSettings& settings);

/// Direction `index` of a sequence that fills a cell evenly, unit.
[[nodiscard]] Eigen::Vector3f direction_in_cell(std::uint32_t cell, std::uint32_t index);

}  // namespace coif::visibility
