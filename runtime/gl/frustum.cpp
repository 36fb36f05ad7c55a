#include "gl/frustum.h"

#include <cmath>

namespace coif {

// A point is in view where -w <= x, y, z <= w: six sums and differences of the matrix's rows.
Frustum::Frustum(const float (&clip)[16]) {
  for (int i = 0; i < 6; ++i) {
    const int row = i / 2;
    const float sign = i % 2 == 0 ? 1.0f : -1.0f;
    float* const plane = planes_[i];
    for (int column = 0; column < 4; ++column) plane[column] = clip[4 * column + 3] + sign * clip[4 * column + row];
    const float length = std::sqrt(plane[0] * plane[0] + plane[1] * plane[1] + plane[2] * plane[2]);
    if (!(length > 0.0f)) continue;
    for (int column = 0; column < 4; ++column) plane[column] /= length;
  }
}

bool Frustum::may_show(const float (&center)[3], float radius) const {
  for (const float(&plane)[4] : planes_) {
    const float inside = plane[0] * center[0] + plane[1] * center[1] + plane[2] * center[2] + plane[3];
    if (inside < -radius) return false;
  }
  return true;
}

}  // namespace coif
