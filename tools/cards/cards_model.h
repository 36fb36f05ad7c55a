#pragma once

#include "base/tool_error.h"
#include "groom/groom.h"
#include "import/source_model.h"

#include <tl/expected.hpp>

#include <cstddef>

namespace coif {

/// What cards may cost.
struct CardsBudget {
  std::size_t triangles = 8000;
  std::size_t texels = std::size_t{1} << 22;
  float strand_width =
      0;  ///< Metres, of strands whose groom says none; 0: so wide that they cover a head of their size as hair does.
};

/// A model of strips with one texture in place of the strands, as an artist would hand it in: the rest of a cook goes on from there.
/// Repeats for equal input, whatever `threads` is. kOverBudget where the budget is too small for the fewest cards that hold the hair.
[[nodiscard]] tl::expected<SourceModel, ToolError> model_of_cards(const Groom& groom, const CardsBudget& budget,
                                                                  unsigned threads);

}  // namespace coif
