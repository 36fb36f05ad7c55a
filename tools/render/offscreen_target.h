#pragma once

#include "tool_error.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <vector>

namespace coif {

/// An sRGB framebuffer with depth, four samples per pixel where the driver has them. Its objects are freed with the
/// OpenGL context.
class OffscreenTarget {
 public:
  static tl::expected<OffscreenTarget, ToolError> create(std::uint32_t width, std::uint32_t height,
                                                         std::uint32_t samples = 4);

  /// Makes it the framebuffer that is drawn to, with its whole area as viewport.
  void bind() const;

  /// Resolved pixels, RGBA, sRGB-encoded, rows top to bottom.
  [[nodiscard]] std::vector<std::uint8_t> read() const;

 private:
  std::uint32_t width_ = 0;
  std::uint32_t height_ = 0;
  std::uint32_t drawn_ = 0;     ///< Framebuffer object with samples and depth.
  std::uint32_t resolved_ = 0;  ///< Framebuffer object to read from.
};

}  // namespace coif
