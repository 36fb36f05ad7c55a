#pragma once

#include "visibility/fragment_view.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace coif::visibility {

/// A fragment on its way into its line.
struct PlacedFragment {
  std::uint32_t line;
  Fragment fragment;
};

/// Hair as a view sees it, before any line is looked along.
struct ProjectedHair {
  ProjectedHair(const HairSurface& hair, std::span<const Eigen::Vector3f> positions, const GridFrame& axes);

  std::vector<Eigen::Array3f> points;          ///< For each used vertex: along right, up and towards_eye.
  Eigen::Array3f low{0, 0, 0}, high{0, 0, 0};  ///< Bounds of the points.
};

/// Finds which lines of a grid meet which triangles, and where. One picture each.
class TriangleRaster {
 public:
  /// Keeps references to all that it is given.
  TriangleRaster(const HairSurface& hair, std::span<const Eigen::Vector3f> positions, const ProjectedHair& projected,
                 const ViewGrid& grid, const GridFrame& frame);

  /// In no order. Fragments that are hidden by earlier ones are left out.
  [[nodiscard]] std::vector<PlacedFragment> run();

  /// After run(), per line with fragments: the depth of the head; only if the grid leaves out what it hides.
  [[nodiscard]] std::vector<float> take_solid_depth() { return std::move(solid_depth_); }

 private:
  /// On a grid that is finer than that of the lines.
  struct Corner {
    std::int32_t x, y;
    float nearness;  ///< Metres towards the eye.
  };
  /// A triangle and the box of lines that it may meet.
  struct Met {
    std::uint32_t triangle;
    float nearest;  ///< Depth, metres, of its nearest corner.
    std::int32_t first_column, last_column, first_row, last_row;
  };

  /// Twice the areas between a line and the three edges, minus 1 for edges that are not owned.
  using Areas = std::array<std::int64_t, 3>;
  struct InsideLine {
    std::size_t line;
    Areas areas;
  };
  static constexpr std::size_t kFewLines = 64;

  [[nodiscard]] static std::int64_t edge(const Corner& a, const Corner& b, std::int64_t x, std::int64_t y);
  [[nodiscard]] static bool owns_edge(const Corner& a, const Corner& b);
  [[nodiscard]] std::vector<Met> met_triangles() const;
  [[nodiscard]] std::vector<Met> near_to_far(const std::vector<Met>& met) const;
  [[nodiscard]] bool is_covered(const Met& box, float nearest);
  [[nodiscard]] float& covered_from(std::size_t line);
  void draw(const Met& met);
  void meet();
  [[nodiscard]] MipChoice mip() const;
  void visit_lines(const Met& box);
  void note_row(std::size_t line, std::size_t columns, Areas at, const Areas& by_column);
  void visit_row(std::size_t line, std::size_t columns, Areas at, const Areas& by_column);
  void visit(std::size_t line, const Areas& inside);

  const HairSurface& hair_;
  std::span<const Eigen::Vector3f> positions_;
  const ProjectedHair& projected_;
  const ViewGrid& grid_;
  const GridFrame& frame_;
  SolidsAlong solids_;
  float faintest_;
  float depth_slack_;                ///< Largest rounding error of a fragment's depth, metres.
  std::vector<Corner> corners_;      ///< Per vertex.
  std::vector<float> covered_from_;  ///< Per line: the nearest solid fragment so far; NaN before the first use.
  std::vector<float> solid_depth_;
  std::vector<PlacedFragment> placed_;

  // The present triangle.
  std::array<std::uint32_t, 3> vertex_{};
  Corner corner_[3];
  float nearest_ = 0;
  std::int64_t area_ = 1;
  float per_area_ = 1;
  bool owns_[3] = {};  ///< Whether lines on the edge opposite to each corner are the triangle's.
  Fragment base_;
  bool is_met_ = false;
  Eigen::Vector3f point_[3];
  Eigen::Vector2f uv_[3];
  MipChoice mip_;
  std::array<InsideLine, kFewLines + 1> inside_;  ///< Lines inside it, and room for one that is not.
  std::size_t inside_count_ = 0;
};

}  // namespace coif::visibility
