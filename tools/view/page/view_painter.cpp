#include "view/page/view_scene.h"

#include <GLES3/gl3.h>

namespace coif::view {
namespace {

TrianglePass pass_of(const Asset& asset, const ViewSettings& settings) {
  TrianglePass pass{.view = hair_view_of(settings.view)};
  if (pass.view == HairView::kPatches) return pass;  // whole, as the chart of patches shows them
  const MaterialRecord material = material_of(asset, settings);
  pass.alpha = material.base_color[3];
  pass.least_alpha = material.discard_threshold;
  pass.both_faces = (material.flags & kMaterialDoubleSided) != 0;
  pass.counts = pass.view == HairView::kOverdraw;
  return pass;
}

}  // namespace

tl::expected<void, ToolError> ViewPainter::draw(const ViewSettings& settings, const render::Camera& camera,
                                                std::span<const HairInstance> heads, const render::StageRenderer& stage,
                                                const DevelopedTarget& target) {
  if (!triangles_) {
    auto made = TriangleView::create(asset_);
    if (!made) return tl::unexpected(made.error());
    triangles_ = std::move(*made);
    target.bind();
  }
  const TrianglePass pass = pass_of(asset_, settings);
  if (pass.counts) return draw_layers(pass, camera, heads, stage, target);
  triangles_->draw(camera, heads, pass);
  return {};
}

tl::expected<void, ToolError> ViewPainter::draw_layers(const TrianglePass& pass, const render::Camera& camera,
                                                       std::span<const HairInstance> heads,
                                                       const render::StageRenderer& stage,
                                                       const DevelopedTarget& target) {
  if (!layers_) {
    auto made = LayerCount::create();
    if (!made) return tl::unexpected(made.error());
    layers_ = std::move(*made);
  }
  if (!layers_->begin(target.width(), target.height())) {
    return failure(ToolError::Kind::kUnsupported, "the browser's WebGL has no memory to count layers in");
  }
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_DEPTH_TEST);
  for (const HairInstance& head : heads) stage.draw_casters(camera.clip_from_world, head.head);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  triangles_->draw(camera, heads, pass);
  target.bind();
  layers_->color();
  return {};
}

}  // namespace coif::view
