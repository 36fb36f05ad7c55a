#pragma once

#include "base/tool_error.h"
#include "render/camera.h"

#include <coif/asset.h>
#include <coif/debug_lines.h>
#include <coif/drawing.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::render {

/// The debug lines that a picture shows over the hair.
struct DebugView {
  bool bones = false;
  bool colliders = false;
  bool contacts = false;
  bool limits = false;
  bool motion = false;  ///< Hair in colours of how far it has moved in the picture since the frame before.

  [[nodiscard]] bool has_lines() const { return bones || colliders || contacts || limits; }
};

/// The lines of one head. kInternal where the runtime refuses it.
tl::expected<std::vector<DebugLine>, ToolError> debug_lines_of(const Asset& asset, const HairInstance& head,
                                                               const DebugView& view);

/// Lines over pictures. Its objects are freed with the OpenGL context.
class LineOverlay {
 public:
  /// kUnsupported where the driver refuses it.
  static tl::expected<LineOverlay, ToolError> create();

  /// Draws `lines` over all that is in the framebuffer of this size (pixels), `thickness` pixels wide, each in its
  /// kind's colour.
  void draw(const Camera& camera, std::span<const DebugLine> lines, std::uint32_t width, std::uint32_t height,
            float thickness) const;

 private:
  LineOverlay() = default;

  std::uint32_t program_ = 0;
  std::uint32_t vertex_array_ = 0;
  std::uint32_t buffer_ = 0;
};

/// The same for a single picture.
tl::expected<void, ToolError> draw_over(const Camera& camera, std::span<const DebugLine> lines, std::uint32_t width,
                                        std::uint32_t height, float thickness);

}  // namespace coif::render
