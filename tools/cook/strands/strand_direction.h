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
  std::vector<SeenStrands> seen;     ///< Per patch, what images show of it; empty: nothing is known.
  platform::Threads threads = 1;     ///< The result does not depend on it.
};

/// StrandSettings::roots, of all patches and of each alone: as the recipe says, else as the source knows.
[[nodiscard]] std::vector<std::string> declared_roots(const StripRecipe& recipe, const importer::SourceModel& source,
                                                      const HairStrips& hair);

/// The direction of the strands on every vertex: along the texture axis that runs down the patch's longer side, or over
/// the surface from end to end where texture coordinates say nothing. The root is the end that RootEvidence points to,
/// as far as other patches do not contradict (settle_beliefs()). Patches are separate. Notes how roots were told from
/// tips, and where nothing tells them; warns where strands run as if another axis pointed up.
[[nodiscard]] StrandField find_strand_direction(const HairStrips& hair, const FittedHead& head,
                                                const StrandSettings& settings, Findings& findings);

/// Cuts patches whose strands seem to run from one side of the head over its top to the other, and end there as they
/// began: hair grows at the top, so that each half has a root of its own, which the places of `hair` cannot say. And
/// those that run from one side of a parting down and round the head to the other: each half grows at the parting and
/// ends where they meet, lowest. Those for which `roots` (as StrandSettings has it, of each patch) says where it is
/// stay. Returns how many patches there are more; their strands are to be found anew.
std::uint32_t split_partings(HairStrips& hair, const FittedHead& head, std::span<const std::string> roots,
                             Findings& findings);

/// StrandSettings::depth_of_node for a head bone: 0 for it and whatever is not below it.
[[nodiscard]] std::vector<float> depths_below(const importer::SourceModel& source, std::uint32_t head_node);

struct ShellSplit {
  std::uint32_t shells = 0;  ///< Patches that were too wide.
  std::uint32_t parts = 0;   ///< What they became.
  std::uint32_t left = 0;    ///< Patches that are still too wide: no edges run along them.
};

/// Cuts patches wider than `widest` metres across their strands, and separates the parts. A patch is drawn in one place
/// of the order, and a cap that reaches round the head has none: its left half is behind where its right half is in
/// front. Cuts follow edges that run along the strands: quads in a row from root to tip stay together as a ribbon, and
/// neighbouring ribbons join, the narrowest result first, as far as the width allows. Parts are numbered behind the
/// existing patches. Notes what was cut.
ShellSplit split_shells(HairStrips& hair, double widest, Findings& findings, const std::stop_token& stop = {});

/// Metres, for split_shells(): the recipe's, else what hides its own back half on a head of this size.
[[nodiscard]] double widest_patch(const StripRecipe& recipe, const FittedHead& head);

}  // namespace coif::cook
