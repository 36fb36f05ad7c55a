#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <memory>

namespace coif::view {

/// Counts layers of hair, up to 255 per pixel, and converts the counts to kLayerColors.
class LayerCount {
 public:
  /// Added to a pixel of its target by each layer.
  static constexpr float kStep = 1 / 255.0f;

  /// kUnsupported where the driver refuses the shader.
  static tl::expected<std::unique_ptr<LayerCount>, ToolError> create();
  ~LayerCount();
  LayerCount(const LayerCount&) = delete;
  LayerCount& operator=(const LayerCount&) = delete;

  /// Binds the cleared target, in pixels, with a depth buffer. Does not reallocate if the size is unchanged. False
  /// where there is no memory for it.
  [[nodiscard]] bool begin(std::uint32_t width, std::uint32_t height);

  /// Draws over the bound framebuffer of that size, where there is at least one layer.
  void color() const;

 private:
  LayerCount() = default;
  void free_target();

  std::uint32_t program_ = 0, vertex_array_ = 0;
  std::uint32_t framebuffer_ = 0, texture_ = 0, depth_ = 0;
  std::uint32_t width_ = 0, height_ = 0;
};

}  // namespace coif::view
