#pragma once

#include "gl/draw_block.h"

namespace coif {

/// What a camera may see.
class Frustum {
 public:
  /// Column-major, OpenGL clip space.
  explicit Frustum(const float (&clip_from_view)[16]);

  /// False only where nothing of the ball is in view. View space, metres.
  [[nodiscard]] bool may_show(const float (&center)[3], float radius) const;

 private:
  float planes_[6][4];  ///< Inside: dot(xyz, p) + w >= 0; xyz unit, or 0 for a plane at infinity.
};

}  // namespace coif
