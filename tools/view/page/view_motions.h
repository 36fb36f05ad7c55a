#pragma once

#include "motion/head_path.h"

#include <memory>
#include <string>

namespace coif {

/// The page's choice of a motion: the built-in ones by their numbers, then those of head_looks(). Separated by '|'.
[[nodiscard]] std::string motion_words();

/// Of the choice's number; the last one for any that is larger. Never null.
[[nodiscard]] std::unique_ptr<HeadPath> chosen_path(float choice);

}  // namespace coif
