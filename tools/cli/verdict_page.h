#pragma once

#include "cli/verdict.h"

#include <span>
#include <string>

namespace coif {

/// All verdicts as one HTML document: a table of each file's issues with their meaning and cure, and its pictures.
[[nodiscard]] std::string verdict_page(std::span<const Verdict> verdicts);

}  // namespace coif
