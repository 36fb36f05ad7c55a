#pragma once

#include "cook/hair_views.h"
#include "cook/triangle_grid.h"

namespace coif {

/// Chooses patches to leave out of a coarser level: hidden ones, tiny ones, and those that lie on others.
class PatchDropper {
 public:
  /// Left-out hair lies within `reach` (metres) of hair that stays. Keeps references.
  PatchDropper(const HairMesh& mesh, const PatchSet& patches, const AlphaTest& alpha, double reach, unsigned threads);

  /// Drops patches of `drawn` until `excess` triangles are gone or nothing more may go: the least seen for their
  /// `triangles` first, and none that leaves holes. `triangles[p]`: how many patch p has at this level. Returns the
  /// triangles that are gone.
  std::size_t drop(std::size_t excess, std::span<const std::size_t> triangles, std::vector<bool>& drawn);

  /// Share of the pixels of all views that had hair and have none any more.
  [[nodiscard]] double bared() const;

 private:
  [[nodiscard]] bool may_go(std::uint32_t patch, std::vector<bool>& drawn) const;

  const HairMesh& mesh_;
  HairViews views_;
  TriangleGrid grid_;
  std::vector<std::vector<std::uint32_t>> vertices_;  ///< Of each patch.
  double reach_;
  std::size_t bared_ = 0;  ///< Pixels.
};

}  // namespace coif
