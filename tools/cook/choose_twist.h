#pragma once

#include "cook/left_out.h"
#include "write/asset_writer.h"

#include <string>
#include <vector>

namespace coif {

/// Which bones carry a twist from step to step, and what the others save.
struct ChosenTwist {
  std::vector<DynamicsRecord> dynamics;  ///< One per bone: the torsion is as it was, or kShortestArc.
  std::vector<std::string> notes;        ///< Which chains keep it, and why.
  std::vector<LeftOut> left_out;         ///< None or one.
};

/// A frame that is the shortest arc from the parent's needs no memory, but it flips where a bone folds back over its parent
/// (runtime/docs/MODEL.md, "Frames and twist"). Runs the motions of the suite and looks how far the bones of each chain
/// bend from their default direction by the parent: chains that stay below 120 degrees do without a twist. What cannot bend
/// so far, for its angle limit, is not run. `contents` holds skeleton, dynamics and colliders; the result does not depend on
/// `threads`.
[[nodiscard]] ChosenTwist choose_twist(const AssetContents& contents, unsigned threads);

}  // namespace coif
