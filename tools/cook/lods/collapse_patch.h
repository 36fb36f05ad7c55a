#pragma once

#include "cook/lods/patch_surface.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <stop_token>

namespace coif::cook {

/// The squared distances of a point from several planes, each times a weight, as one polynomial (Garland and Heckbert
/// 1997, "Surface simplification using quadric error metrics").
class SurfaceQuadric {
 public:
  /// `normal` has length 1.
  void add_plane(const Eigen::Vector3d& normal, const Eigen::Vector3d& on_plane, double weight) {
    const double offset = -normal.dot(on_plane);
    square_ += weight * normal * normal.transpose();
    linear_ += weight * offset * normal;
    constant_ += weight * offset * offset;
  }

  void add(const SurfaceQuadric& other) {
    square_ += other.square_;
    linear_ += other.linear_;
    constant_ += other.constant_;
  }

  [[nodiscard]] double at(const Eigen::Vector3d& point) const {
    return point.dot(square_ * point) + 2 * linear_.dot(point) + constant_;
  }

 private:
  Eigen::Matrix3d square_ = Eigen::Matrix3d::Zero();
  Eigen::Vector3d linear_ = Eigen::Vector3d::Zero();
  double constant_ = 0;
};

/// Everything that used corner `from` uses `to` from now on.
struct CornerMove {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

/// A patch that loses its points one by one; says which points may collapse without tearing or folding it.
class ShrinkingSurface {
 public:
  using Points = std::array<std::uint32_t, 3>;  ///< The points of one triangle.

  /// Keeps a reference. Triangles without area are left out.
  explicit ShrinkingSurface(const PatchSurface& surface);

  [[nodiscard]] std::uint32_t triangles_left() const { return left_; }
  [[nodiscard]] bool is_fixed(std::uint32_t point) const { return fixed_[point]; }

  /// Points that share a triangle with `point`, each once. Valid until the next call.
  [[nodiscard]] std::span<const std::uint32_t> neighbours(std::uint32_t point);

  /// Whether `from` may move to its neighbour `to`: the surface keeps its topology, no triangle turns over, borders and
  /// texture seams move only along themselves, and no point loses its last triangle but `from`.
  [[nodiscard]] bool may_collapse(std::uint32_t from, std::uint32_t to);

  /// The triangles around `to` when `from` has gone there. Valid until the next call.
  [[nodiscard]] std::span<const Points> star_after(std::uint32_t from, std::uint32_t to);

  /// Performs the collapse that may_collapse() allowed last. Appends to `moves`.
  void collapse(std::uint32_t from, std::uint32_t to, std::vector<CornerMove>& moves);

 private:
  using Triangle = PatchSurface::Triangle;

  [[nodiscard]] bool keeps_topology(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] bool keeps_facing(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] bool find_moves(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] std::uint32_t moved_corner(std::uint32_t corner) const;

  const PatchSurface& surface_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::uint32_t>> triangles_of_;  ///< Per point: the remaining triangles.
  std::vector<bool> on_border_, fixed_;
  std::uint32_t left_ = 0;
  // Scratch of the present question.
  std::vector<std::uint32_t> mark_, neighbours_;
  std::uint32_t last_mark_ = 0;
  std::vector<Points> star_;
  std::vector<CornerMove> moves_;
};

/// The order in which a patch loses its triangles, one edge after the other. Any number of first steps gives a coarser
/// patch from the finest one's vertices, so levels of detail share them.
struct CollapseSequence {
  struct Step {
    float error = 0;                   ///< Metres, in the worst of the poses, when it was made; ascending.
    std::uint32_t triangles_left = 0;  ///< After this step.
    std::uint32_t moves_end = 0;       ///< moves[0 .. moves_end) belong to this step and those before.
  };
  std::vector<Step> steps;
  std::vector<CornerMove> moves;
};

struct CollapseLimits {
  double largest_error = 0.01;  ///< Metres.
  double fewest_share = 0;      ///< Share of its triangles that a patch always keeps.
};

/// Collapses edges onto one of their ends, those first that change the shape least. Corners of the outline stay, so
/// that strips keep their points and their width, and something of every piece stays.
///
/// A step's error is measured: how far the points that are gone lie from the triangles now around where they went.
/// Near-linear in the triangles.
[[nodiscard]] CollapseSequence collapse_patch(const PatchSurface& surface, const CollapseLimits& limits,
                                              const std::stop_token& stop = {});

/// The patch after its first `steps` steps: for each corner the one that it has become.
[[nodiscard]] std::vector<std::uint32_t> collapsed_corners(const PatchSurface& surface,
                                                           const CollapseSequence& sequence, std::size_t steps);

/// Largest distance of the surface's points from the patch after `steps` steps, over all poses, metres. Each point
/// searches from where it has gone, as long as neighbours are nearer, so the true distance may be smaller.
[[nodiscard]] double collapsed_error(const PatchSurface& surface, const CollapseSequence& sequence, std::size_t steps);

/// The patch after its first `steps` steps: three vertices of the mesh for each remaining triangle. `originals` are the
/// original vertices of the patch's triangles, in the order of PatchSurface::triangles.
[[nodiscard]] std::vector<std::uint32_t> collapsed_triangles(const PatchSurface& surface,
                                                             const CollapseSequence& sequence, std::size_t steps,
                                                             std::span<const std::uint32_t> originals);

}  // namespace coif::cook
