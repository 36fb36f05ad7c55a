#pragma once

#include "cli/batch_summary.h"

#include <string>

namespace coif {

/// The outcomes as an HTML page, failures first, with a picture of each asset that can be drawn. Draws up to `jobs` at once,
/// each in a process of its own; call it while no other child is waited for.
[[nodiscard]] std::string batch_page(const Outcomes& outcomes, unsigned jobs);

}  // namespace coif
