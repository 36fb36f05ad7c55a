#pragma once

#include "base/tool_error.h"
#include "cook/recipe/cook_settings.h"
#include "cook/recipe/hair_recipe.h"
#include "cook/recipe/strip_recipe.h"
#include "cook/select/head.h"
#include "cook/stages/cook_log.h"
#include "cook/strands/choose_patches.h"
#include "cook/strands/hair_strips.h"
#include "cook/strands/patches.h"
#include "cook/texture/base_color.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <vector>

namespace coif::cook {

/// Hair as strips, and the head that they grow on.
struct Strips {
  HairStrips hair;
  ExtractedPatches extracted;
  std::vector<PatchListing> listings;  ///< Empty unless somebody asks, or the recipe says something of patches alone.
  HeadBone head_bone;
  FittedHead head;
};

/// The second stage of a cook, of hair that was found in `source`. Errors: the recipe's patches or head bone are not
/// there, or no hair is left.
tl::expected<Strips, ToolError> find_strips(const importer::SourceModel& source, HairMesh hair, const BaseColor& color,
                                            const HairRecipe& of_head, const StripRecipe& recipe,
                                            const CookSettings& settings, CookLog& log);

}  // namespace coif::cook
