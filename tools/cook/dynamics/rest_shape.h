#pragma once

#include "cook/recipe/findings.h"
#include "write/asset_writer.h"

#include <vector>

namespace coif::cook {

/// Leans each bone's pull, of those for which `takes` is true, against the weight that it carries, so that under an
/// upright head hair rests exactly as modelled. Closed form, in the model of each chain. A bone too soft to carry that
/// is made as stiff as it takes; a note says how many.
void keep_rest_shape(const std::vector<bool>& takes, AssetContents& contents, Findings& findings);

}  // namespace coif::cook
