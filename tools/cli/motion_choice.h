#pragma once

#include "cli/clip_choice.h"
#include "cli/options.h"
#include "motion/motion.h"

#include <optional>
#include <span>
#include <string>

namespace coif {

/// The built-in motions as words of the command line.
[[nodiscard]] std::span<const Choice<Motion>> motion_choices();

/// A built-in motion or a clip.
struct HeadMotion {
  Motion motion = Motion::kStill;
  std::optional<ClipChoice> clip{};  ///< Instead of `motion`.
};

/// --motion NAME|CLIP[:NODE]; `motion` must outlive the parsing.
CLI::Option* add_motion(CLI::App& app, HeadMotion& motion, const std::string& help);

/// A paragraph with each motion and its figures, for --help.
[[nodiscard]] std::string motion_help();

}  // namespace coif
