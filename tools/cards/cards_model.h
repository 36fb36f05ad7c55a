#pragma once

#include "base/tool_error.h"
#include "cards/make_cards.h"
#include "groom/groom.h"
#include "import/source_model.h"
#include "platform/stop.h"

#include <tl/expected.hpp>

namespace coif::cards {

/// A model of strips with one texture in place of the strands, as an artist would hand it in: the rest of a cook goes
/// on from there. Levels of detail behind the finest are SourceModel::coarser. Repeats for equal input, whatever
/// `threads` is. kOverBudget where the budget is too small for the fewest cards that hold the hair.
[[nodiscard]] tl::expected<importer::SourceModel, ToolError> model_of_cards(const groom::Groom& groom,
                                                                            const CardsBudget& budget,
                                                                            const platform::Threads& threads);

}  // namespace coif::cards
