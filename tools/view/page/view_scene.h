#pragma once

#include "base/tool_error.h"
#include "render/camera.h"
#include "render/debug_overlay.h"
#include "render/stage_renderer.h"
#include "view/body/page_body.h"
#include "view/page/developed_target.h"
#include "view/page/layer_count.h"
#include "view/page/triangle_view.h"
#include "view/page/view_settings.h"

#include <coif/asset.h>
#include <coif/renderer.h>
#include <coif/shadow.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace coif::view {

/// Draws the views other than HairView::kHair. Makes its objects when they are first needed.
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

/// One asset in one WebGL context: all GPU objects of the page.
class ViewScene {
 public:
  /// The asset must outlive this object. `body`: what is beneath the hair; null: the asset's colliders. kUnsupported
  /// where the browser refuses something, kBadInput for an asset without a mesh.
  static tl::expected<std::unique_ptr<ViewScene>, ToolError> create(const Asset& asset,
                                                                    std::shared_ptr<const PageBody> body);
  ~ViewScene();
  ViewScene(const ViewScene&) = delete;
  ViewScene& operator=(const ViewScene&) = delete;

  /// Frames this many heads like `coif render`, enlarged by the settings' zoom.
  [[nodiscard]] const render::CrowdView& view(const ViewSettings& settings, double aspect, std::uint32_t heads);

  /// Pixels of the canvas. For each of `view`'s places one head with its pose and palette.
  tl::expected<void, ToolError> draw(const ViewSettings& settings, const render::CrowdView& view,
                                     std::span<const HairInstance> heads, std::uint32_t width, std::uint32_t height);

  [[nodiscard]] const std::vector<Eigen::Vector3d>& points() const { return points_; }

 private:
  ViewScene(const Asset& asset, std::shared_ptr<const PageBody> body)
      : asset_(asset), body_(std::move(body)), points_(render::framed_points(asset)), painter_(asset) {}
  tl::expected<void, ToolError> make();
  /// Makes the shadow of this technique, and a stage whose shader looks it up.
  tl::expected<void, ToolError> choose_shadow(const ShadowTechnique* technique);
  [[nodiscard]] std::vector<render::SolidMesh> stage_meshes() const;
  /// Lets a standing body follow the head's turn.
  void turn_body(const Quat& turn);
  Status cast(const ShadowCrowd& crowd, std::span<const HairInstance> heads, const render::CrowdView& view,
              const Light& light);
  tl::expected<void, ToolError> draw_lines(const ViewSettings& settings, const render::Camera& camera,
                                           std::span<const HairInstance> heads) const;

  struct Framed {
    float yaw = 0, pitch = 0, zoom = 0;
    double aspect = 0;
    std::uint32_t heads = 0;
    bool operator==(const Framed&) const = default;
  };

  const Asset& asset_;
  std::shared_ptr<const PageBody> body_;
  std::vector<render::SolidVertex> turned_;  ///< Scratch of turn_body().
  Quat body_turn_;                           ///< What the stage's body follows.
  std::vector<Eigen::Vector3d> points_;
  std::vector<std::byte> scratch_;
  HairRenderer renderer_;
  HairModel model_;
  HairShadow shadow_;
  const ShadowTechnique* technique_ = nullptr;
  std::optional<render::StageRenderer> stage_;
  std::optional<render::LineOverlay> lines_;
  ViewPainter painter_;
  std::optional<DevelopedTarget> target_;
  Framed framed_;
  render::CrowdView view_;
};

/// Finds Emscripten's OpenGL ES functions that the renderer and its shadows call, by name in a list: Emscripten's own
/// search links every function.
[[nodiscard]] GlLoader web_gl_loader();

}  // namespace coif::view
