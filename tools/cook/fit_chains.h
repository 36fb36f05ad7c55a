#pragma once

#include "cook/fit_head.h"
#include "cook/skin_weights.h"
#include "cook/strand_direction.h"

namespace coif {

struct FittedRig {
  Skeleton skeleton;
  SkinWeights weights;             ///< One entry per vertex of the hair.
  std::vector<std::string> notes;  ///< What was fitted where, for the report.
};

/// Bones for hair that has none: groups what hangs free into locks, fits a chain to each from where it leaves the scalp to
/// its tip, and blends skin weights along and between chains. `rigid` has the head bone, the file's map from nodes to it,
/// and nothing that moves.
/// `place` of each vertex from weld_places().
[[nodiscard]] FittedRig fit_chains(const SourceModel& source, const HairMesh& hair,
                                   std::span<const std::uint32_t> place, const StrandField& strands,
                                   const FittedHead& head, const Skeleton& rigid, const Recipe& recipe);

}  // namespace coif
