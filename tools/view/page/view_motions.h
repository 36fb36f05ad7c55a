#pragma once

#include "motion/head_path.h"

#include <memory>
#include <string>

namespace coif::view {

/// The page's choice of a motion: the built-in ones by their numbers, those of head_looks(), and "clip" where the page
/// has one. Separated by '|'.
[[nodiscard]] std::string motion_words(bool has_clip);

/// Whether the choice's number is that of the clip.
[[nodiscard]] bool is_clip(float choice);

/// Of the choice's number; the last one for any that is larger. Never null.
[[nodiscard]] std::unique_ptr<motion::HeadPath> chosen_path(float choice);

}  // namespace coif::view
