#pragma once

#include "cook/image.h"
#include "cook/recipe.h"
#include "tool_error.h"
#include "write/asset_writer.h"

#include <tl/expected.hpp>

#include <span>
#include <string>
#include <vector>

namespace coif {

/// Looks for the orders in which the packed hair is best drawn (search_orders()), at rest and in motion, and writes them, and
/// the opaque threshold where the recipe leaves it open. What is drawn is never worse, as far as the search can tell, than by
/// distance from the head, which is kept where nothing is blended. Mips must have their own alpha yet: each threshold is
/// tried with those that keep_coverage() would make for it with `used`. Returns what was chosen, with figures. Errors:
/// kBadInput for hair that the runtime cannot simulate.
tl::expected<std::vector<std::string>, ToolError> choose_order(const Recipe& recipe, std::span<const Image> used,
                                                               unsigned threads, AssetContents& contents);

}  // namespace coif
