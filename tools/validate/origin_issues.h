#pragma once

#include "validate/issue.h"

#include <coif/asset.h>

#include <vector>

namespace coif {

/// Whether an asset was cooked from what `now` describes: source and recipe by their hashes, tool and importer by their
/// versions; versions only where both hashes agree. Hashes do not cover texture files beside source and recipe.
[[nodiscard]] std::vector<Issue> find_origin_issues(const Asset& asset, const ProvenanceRecord& now);

/// Whether a cook of today gives the same chunks; what PROV says of the tools does not count.
[[nodiscard]] std::vector<Issue> find_recook_issues(const Asset& asset, const Asset& cooked_anew);

}  // namespace coif
