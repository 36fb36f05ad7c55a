#pragma once

#include "cook/hair_views.h"
#include "cook/strand_direction.h"

#include <string>
#include <vector>

namespace coif {

/// Which strips end as if cut with scissors: real hair thins out, and what stays opaque over its whole width up to the
/// last edge shows that it is a polygon.
struct HardTips {
  std::vector<std::uint32_t> patches;  ///< Those that end hard, ascending.
  std::vector<std::string> warnings;
};

/// A patch ends hard where it has a free edge at its tips, where it is opaque there over at least half of the width that
/// it has at its widest, and where no other hair lies over that edge or takes up its strands. So what is modelled to a
/// point, what fades in alpha, closed shapes and ends tied up in other hair do not count. `opaque` has the threshold from
/// which on texels are drawn as opaque. `place` of each vertex from weld_places(). Warns where it is more than a few.
[[nodiscard]] HardTips find_hard_tips(const HairMesh& mesh, std::span<const std::uint32_t> place,
                                      const PatchSet& patches, const StrandField& strands, const FittedHead& head,
                                      const AlphaTest& opaque, unsigned threads);

}  // namespace coif
