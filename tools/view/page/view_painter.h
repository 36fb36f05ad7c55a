#pragma once

#include "base/tool_error.h"
#include "render/stage_renderer.h"
#include "view/page/developed_target.h"
#include "view/page/layer_count.h"
#include "view/page/triangle_view.h"
#include "view/page/view_settings.h"

#include <tl/expected.hpp>

#include <memory>
#include <span>

namespace coif::view {

/// Draws the views other than HairView::kHair. Makes what it needs when it is first asked for.
class ViewPainter {
 public:
  /// The asset must outlive this object, and the context its last use.
  explicit ViewPainter(const Asset& asset) : asset_(asset) {}

  /// Onto the stage that is in `target`, which stays bound. kUnsupported where the browser refuses something.
  tl::expected<void, ToolError> draw(const ViewSettings& settings, const render::Camera& camera,
                                     std::span<const HairInstance> heads, const render::StageRenderer& stage,
                                     const DevelopedTarget& target);

 private:
  tl::expected<void, ToolError> draw_layers(const TrianglePass& pass, const render::Camera& camera,
                                            std::span<const HairInstance> heads, const render::StageRenderer& stage,
                                            const DevelopedTarget& target);

  const Asset& asset_;
  std::unique_ptr<TriangleView> triangles_;
  std::unique_ptr<LayerCount> layers_;
};

}  // namespace coif::view
