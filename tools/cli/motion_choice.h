#pragma once

#include "cli/options.h"
#include "motion/motion.h"

namespace coif {

/// The built-in motions as words of the command line.
[[nodiscard]] std::span<const Choice<Motion>> motion_choices();

/// A paragraph with each motion and its figures, for --help.
[[nodiscard]] std::string motion_help();

}  // namespace coif
