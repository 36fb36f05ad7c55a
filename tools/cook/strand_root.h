#pragma once

#include "cook/fit_head.h"
#include "cook/patch_view.h"
#include "cook/strand_axis.h"

#include <span>

namespace coif {

/// What the two ends of a patch say about which one is the root. Each from -1 (the high end of the coordinate is it) to 1
/// (the low end), 0 where it says nothing.
struct RootEvidence {
  float distance = 0;  ///< Roots are nearer to the head's surface.
  float bones = 0;     ///< Roots follow bones that are nearer to the head bone.
  float height = 0;    ///< Hair hangs.
  float taper = 0;     ///< Tips are narrower.

  /// What the patch says on its own: positive where the low end is the root.
  [[nodiscard]] float sum() const { return distance + 1.5f * bones + 0.35f * height + 0.25f * taper; }
};

/// `depth_of_node`: bones between each node of the source and the head.
[[nodiscard]] RootEvidence weigh_ends(const HairMesh& mesh, const PatchView& patch, const StrandAxis& axis,
                                      const FittedHead& head, std::span<const float> depth_of_node);

}  // namespace coif
