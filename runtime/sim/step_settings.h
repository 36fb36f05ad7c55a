#pragma once

#include <coif/hair.h>

namespace coif {

/// kOk where a step may be made with these, whatever the asset; else kBadTimeStep or kBadArgument.
[[nodiscard]] Status check_settings(const StepSettings& settings);

}  // namespace coif
