#pragma once

#include <algorithm>

namespace coif::sample {

/// 0 at `from`, 1 at `to`, flat at both ends and beyond them. `from` may be the larger one.
inline double smooth_step(double from, double to, double x) {
  const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

}  // namespace coif::sample
