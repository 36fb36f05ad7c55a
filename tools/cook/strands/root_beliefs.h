#pragma once

#include "cook/strands/strand_evidence.h"

#include <span>
#include <stop_token>
#include <vector>

namespace coif::cook {

/// What one patch brings to the question where its root is.
struct RootVote {
  int texture_axis = -1;  ///< Along which its strands run; -1: none.
  float evidence = 0;     ///< RootEvidence::sum().
  float area = 0;
  float painted = 1;  ///< How much it matters where others have their roots in the texture, 0..1.
};

/// For each patch the belief that its low end is the root, -1 (the high end) .. 1. Its own evidence counts, and what is
/// believed of the patches beside it, since hair that is combed one way runs one way; of those that show the same part
/// of the texture, since one picture of strands has one root; and of all, since one artist paints roots on one side.
/// Mean-field iteration on that graph: few rounds carry a belief across a head.
[[nodiscard]] std::vector<float> settle_beliefs(const HairMesh& mesh, const std::vector<PatchView>& views,
                                                std::span<const RootVote> votes,
                                                const std::vector<std::vector<Neighbour>>& neighbours,
                                                const std::stop_token& stop);

}  // namespace coif::cook
