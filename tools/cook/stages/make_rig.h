#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/rig_recipe.h"
#include "cook/rig/skeleton.h"
#include "cook/stages/cook_log.h"
#include "cook/stages/find_strips.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

namespace coif::cook {

/// What moves hair.
struct CookedRig {
  HairRig rig;
  /// Bones, chains, colliders, dynamics, limits, links and tuning as the runtime has them. No tuning in a draft, and
  /// where nothing moves.
  AssetContents contents;
};

/// The third stage of a cook: bones of the file or fitted ones, what they must not enter, and how they move. Each
/// chain's equation becomes one that has a solution, and then gets the cheapest way to solve it. Errors: the recipe's
/// bones are not there, or no rate keeps its budget.
tl::expected<CookedRig, ToolError> make_rig(const importer::SourceModel& source, const Strips& strips,
                                            const RigRecipe& recipe, const CookSettings& settings, CookLog& log);

}  // namespace coif::cook
