#pragma once

#include <coif/research.h>

namespace coif::render {

/// It draws some of a pixel's samples (alpha to coverage), of which there should be more than one.
[[nodiscard]] inline bool covers_samples(const TransparencyMode& mode) {
  return &mode == &kCoverageMode || &mode == &kProportionalMode || &mode == &kJitteredMode;
}

}  // namespace coif::render
