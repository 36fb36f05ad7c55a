#pragma once

#include "base/tool_error.h"

#include <coif/motion_vectors.h>
#include <coif/renderer.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace coif::render {

/// Motion vectors as colours, for a picture. The hue is the direction (red to the right, green to the upper left, blue
/// to the lower left), and is full from a hundredth of the picture per frame on. Grey stands still.
class MotionTarget {
 public:
  /// Pixels each way. kUnsupported where the device cannot draw to two half floats. Its objects are freed with the
  /// context.
  static tl::expected<MotionTarget, ToolError> create(std::uint32_t width, std::uint32_t height);

  /// Binds and clears it; then draw the depth of solid things, then draw_motion_vectors().
  void begin() const;

  /// Puts the colours of pixels with a vector over those of a picture of the same size: RGBA, linear, rows top to
  /// bottom.
  void color(std::span<float> radiance) const;

 private:
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::uint32_t framebuffer_ = 0;
};

/// Linear RGB of a vector, parts of the picture.
void motion_color(float x, float y, std::span<float, 3> rgb);

}  // namespace coif::render
