#pragma once

#include "cook/strand_direction.h"

#include <cstdint>
#include <string>
#include <vector>

namespace coif {

struct ShellSplit {
  std::uint32_t shells = 0;  ///< Patches that were too wide.
  std::uint32_t parts = 0;   ///< What they became.
  std::uint32_t left = 0;    ///< Patches that are still too wide: no edges run along them.
};

/// Cuts patches wider than `widest` metres across their strands. A patch is drawn in one place of the order, and a cap
/// that reaches round the head has none: its left half is behind where its right half is in front. Cuts follow edges
/// that run along the strands: quads in a row from root to tip stay together as a ribbon, and neighbouring ribbons join,
/// the narrowest result first, as far as the width allows. Updates `patches` only; parts are numbered behind the
/// existing ones. `place` of each vertex from weld_places().
ShellSplit split_shells(const HairMesh& mesh, std::span<const std::uint32_t> place, const StrandField& strands,
                        double widest, PatchSet& patches);

}  // namespace coif
