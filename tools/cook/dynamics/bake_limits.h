#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"

#include <tl/expected.hpp>

#include <vector>

namespace coif::cook {

struct RigRecipe;

/// Which directions each bone may have, one record per bone of the skeleton: as the recipe says, else as the file's
/// springs do (VRMC_springBone_limit; not where "dynamics.source" is "curves"). Empty where no bone has a limit. The
/// recipe's lie about the direction in which a bone was modelled, and what they turn about is at right angles to that.
/// Error (kBadInput): the recipe names bones that are not there, or do not move.
[[nodiscard]] tl::expected<std::vector<LimitRecord>, ToolError> bake_limits(const importer::SourceModel& source,
                                                                            const Skeleton& skeleton,
                                                                            const RigRecipe& recipe,
                                                                            Findings& findings);

}  // namespace coif::cook
