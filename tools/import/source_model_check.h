#pragma once

#include "import/source_model.h"

#include <string>

namespace coif {

/// Every promise of source_model.h: cross-references in range, parents first, arrays of one size, finite numbers,
/// influences that add up to one. Empty when they hold, else the first that does not.
[[nodiscard]] std::string find_model_fault(const SourceModel& model);

}  // namespace coif
