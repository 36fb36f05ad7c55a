#pragma once

#include "cook/strands/strand_evidence.h"
#include "cook/texture/base_color.h"
#include "platform/stop.h"

#include <vector>

namespace coif::cook {

/// What the images show of how strands run, per patch; empty where there is no image. Strands are drawn as lines in
/// colour, alpha and, most clearly, in normal maps: across them an image is steep, along them it is not (the structure
/// tensor of Foerstner and Guelch 1987, looked at along the texture's axes). Every place that is steep at all has one
/// vote, so that a few highlights painted across the strands do not outvote them. Towards their tips strands are
/// painted thinner and fewer: alpha fades.
[[nodiscard]] std::vector<SeenStrands> find_strand_lines(const HairStrips& hair, const BaseColor& color,
                                                         const platform::Threads& threads);

/// Says of each patch for which `roots` (StrandSettings::roots) has "auto" at which end of the texture the map that
/// grows from root to tip (one channel) has its root. Patches across which it does not grow clearly stay "auto".
void read_root_to_tip(const HairStrips& hair, const Image& map, std::vector<std::string>& roots);

}  // namespace coif::cook
