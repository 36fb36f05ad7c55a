#pragma once

#include "base/tool_error.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <memory>

namespace coif::view {

/// Where layers of hair are counted, up to 255 in a pixel, and how the counts become kLayerColors.
class LayerCount {
 public:
  /// What a layer adds to a pixel of its target.
  static constexpr float kStep = 1 / 255.0f;

  /// kUnsupported where the driver refuses the shader.
  static tl::expected<std::unique_ptr<LayerCount>, ToolError> create();
  ~LayerCount();
  LayerCount(const LayerCount&) = delete;
  LayerCount& operator=(const LayerCount&) = delete;

  /// Binds the target, empty, with a depth buffer, in pixels. What has the size already stays. False where there is no
  /// memory for it.
  [[nodiscard]] bool begin(std::uint32_t width, std::uint32_t height);

  /// Over what is in the bound framebuffer of that size, where there is a layer at least.
  void color() const;

 private:
  LayerCount() = default;
  void free_target();

  std::uint32_t program_ = 0, vertex_array_ = 0;
  std::uint32_t framebuffer_ = 0, texture_ = 0, depth_ = 0;
  std::uint32_t width_ = 0, height_ = 0;
};

}  // namespace coif::view
