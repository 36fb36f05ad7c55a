#pragma once

#include "cook/recipe/findings.h"
#include "cook/select/head.h"
#include "cook/strands/strand_evidence.h"
#include "platform/stop.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif::cook {

struct StripRecipe;

struct StrandSettings {
  std::vector<std::string>
      roots;                  ///< Per patch, as StripRecipe::strand_root or PatchOverride::root; empty: all "auto".
  bool trust_texture = true;  ///< False where patches are not unwrapped in one piece.
  std::vector<float> depth_of_node;  ///< Bones between each node of the source and the head bone.
  std::vector<SeenStrands> seen;     ///< Per patch, the strands that images show; empty: not known.
  RootWeights weights{};
  platform::Threads threads = 1;  ///< The result does not depend on it.
};

/// StrandSettings::roots, for all patches: the recipe's value, else the source's.
[[nodiscard]] std::vector<std::string> declared_roots(const StripRecipe& recipe, const importer::SourceModel& source,
                                                      const HairStrips& hair);

/// Finds the direction of the strands at every vertex: along the texture axis of the patch's longer side, or over the
/// surface from end to end where texture coordinates are of no use. The root is the end of RootEvidence, unless other
/// patches contradict (settle_beliefs()). Patches must be separate. Notes how roots were found, and patches without
/// evidence; warns if strands run as if another axis pointed up.
[[nodiscard]] StrandField find_strand_direction(const HairStrips& hair, const FittedHead& head,
                                                const StrandSettings& settings, Findings& findings);

/// Cuts two kinds of patches. In the first, strands seem to run from one side of the head over its top to the other,
/// with similar ends: hair grows at the top, so each half has its own root. In the second, they run from one side of a
/// parting down and round the head to the other: each half grows at the parting and ends at the lowest place. Patches
/// whose root is given in `roots` (as in StrandSettings, one per patch) stay whole. Returns the number of new patches;
/// their strands must be found again.
std::uint32_t split_partings(HairStrips& hair, const FittedHead& head, std::span<const std::string> roots,
                             Findings& findings);

/// StrandSettings::depth_of_node for a head bone: 0 for it and whatever is not below it.
[[nodiscard]] std::vector<float> depths_below(const importer::SourceModel& source, std::uint32_t head_node);

struct ShellSplit {
  std::uint32_t shells = 0;  ///< Patches that were too wide.
  std::uint32_t parts = 0;   ///< The number of parts that they became.
  std::uint32_t left = 0;    ///< Patches that are still too wide: no edges run along them.
};

/// Cuts patches wider than `widest` metres across their strands, and separates the parts. A patch has one place in the
/// draw order, but a cap around the head has none: its left half is behind where its right half is in front. Cuts
/// follow edges along the strands: quads in a row from root to tip stay together as a ribbon, and neighbouring ribbons
/// join, the narrowest result first, up to that width. Parts get numbers after the existing patches. Notes the cuts.
ShellSplit split_shells(HairStrips& hair, double widest, Findings& findings, const std::stop_token& stop = {});

/// Metres, for split_shells(): the recipe's, else the width that hides its own back half on a head of this size.
[[nodiscard]] double widest_patch(const StripRecipe& recipe, const FittedHead& head);

}  // namespace coif::cook
