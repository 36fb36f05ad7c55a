#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <cstdint>

namespace coif::view {

/// The target for light, and its conversion to the canvas's pixels, like develop() for pictures. With at most 8 bits
/// per channel where the browser cannot draw into half floats.
class DevelopedTarget {
 public:
  /// kUnsupported where the driver refuses the shader.
  static tl::expected<DevelopedTarget, ToolError> create();
  void destroy();

  /// Pixels of the canvas; `finer` samples of each in each direction, each with `covered` samples of the driver: 0, 4.
  /// Does nothing if the size is unchanged. False where there is no memory for it.
  [[nodiscard]] bool resize(std::uint32_t width, std::uint32_t height, std::uint32_t finer, std::uint32_t covered);

  void bind() const;
  [[nodiscard]] std::uint32_t width() const { return size_.width * size_.finer; }
  [[nodiscard]] std::uint32_t height() const { return size_.height * size_.finer; }

  /// Onto the canvas.
  void develop() const;

 private:
  struct Size {
    std::uint32_t width = 0, height = 0, finer = 0, covered = 0;
    bool operator==(const Size&) const = default;
  };

  DevelopedTarget() = default;
  [[nodiscard]] bool make(std::uint32_t color_format);
  void free_target();

  Size size_;
  std::uint32_t program_ = 0, vertex_array_ = 0;
  std::uint32_t texture_ = 0, resolved_ = 0, drawn_ = 0;
  std::uint32_t color_ = 0, depth_ = 0;  ///< Renderbuffers; `color_` of several samples.
};

}  // namespace coif::view
