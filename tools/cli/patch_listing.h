#pragma once

#include "cli/command.h"
#include "cli/cook_job.h"

namespace coif::cli {

/// `coif cook SOURCE --list patches [-o PICTURE.png]`: cooks a draft, prints its patches with their numbers, and draws
/// them.
tl::expected<Exit, ToolError> list_patches_of(const CookOptions& options, const RecipeChoice& choice,
                                              const Messages& messages);

}  // namespace coif::cli
