#pragma once

#include "cook/patch_surface.h"

namespace coif {

/// All that used corner `from` uses `to` from now on.
struct CornerMove {
  std::uint32_t from = 0;
  std::uint32_t to = 0;
};

/// A patch that loses its points one by one: which may go where without tearing or folding it.
class ShrinkingSurface {
 public:
  using Points = std::array<std::uint32_t, 3>;  ///< Of one triangle.

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

  /// What may_collapse() has allowed last. Appends to `moves`.
  void collapse(std::uint32_t from, std::uint32_t to, std::vector<CornerMove>& moves);

 private:
  using Triangle = PatchSurface::Triangle;

  [[nodiscard]] bool keeps_topology(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] bool keeps_facing(std::uint32_t from, std::uint32_t to) const;
  [[nodiscard]] bool find_moves(std::uint32_t from, std::uint32_t to);
  [[nodiscard]] std::uint32_t moved_corner(std::uint32_t corner) const;

  const PatchSurface& surface_;
  std::vector<Triangle> triangles_;
  std::vector<std::vector<std::uint32_t>> triangles_of_;  ///< Per point; those that are left.
  std::vector<bool> on_border_, fixed_;
  std::uint32_t left_ = 0;
  // Of the question in hand.
  std::vector<std::uint32_t> mark_, neighbours_;
  std::uint32_t last_mark_ = 0;
  std::vector<Points> star_;
  std::vector<CornerMove> moves_;
};

}  // namespace coif
