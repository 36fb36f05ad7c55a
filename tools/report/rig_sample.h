#pragma once

#include "report/rig.h"

#include <cstdint>
#include <vector>

namespace coif {

/// A part of a rig, for measurements that would take too long on all of it.
struct RigSample {
  Rig rig;
  std::vector<std::uint32_t> bones;  ///< Of the whole rig: one for each bone of `rig`.
};

/// Whole trees of bones, evenly chosen over the head, with at most `most_bones` bones, but at least one tree: trees do not
/// act on each other, so each moves as it does among all.
[[nodiscard]] RigSample sample_of(const Rig& rig, std::size_t most_bones);

}  // namespace coif
