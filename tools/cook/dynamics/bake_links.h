#pragma once

#include "base/tool_error.h"
#include "cook/recipe/findings.h"
#include "cook/rig/skeleton.h"
#include "cook/strands/hair_strips.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif::cook {

struct RigRecipe;

/// Which bones of neighbouring chains stay together, as the recipe says it of the bones packed in `contents`.
/// Empty where it wants none, and then a note tells of strips that hang on two chains. Error (kBadInput): the
/// recipe names bones that are not there or do not move, or two of one chain, or more pairs than anybody means.
/// `source` is the file's name.
[[nodiscard]] tl::expected<std::vector<LinkRecord>, ToolError> bake_links(const std::string& source,
                                                                          const HairStrips& hair, const HairRig& rig,
                                                                          const AssetContents& contents,
                                                                          const RigRecipe& recipe, Findings& findings);

}  // namespace coif::cook
