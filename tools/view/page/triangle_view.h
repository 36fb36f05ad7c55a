#pragma once

#include "base/tool_error.h"
#include "render/camera.h"
#include "view/page/triangle_corners.h"

#include <tl/expected.hpp>

#include <cstdint>
#include <memory>
#include <span>

namespace coif::view {

/// The part of the hair to draw, and the alpha from which on it counts as hair.
struct TrianglePass {
  HairView view = HairView::kPatches;
  float alpha = 1, least_alpha = 0;  ///< The material's own; texels with less, times that, are holes.
  bool both_faces = true;
  bool counts = false;  ///< Adds LayerCount::kStep to each channel in place of colours, whatever is in front.
};

/// Draws the triangles of heads in plain colours, without light, over the existing depth. Separate from HairRenderer,
/// with its own objects: games do not link it.
class TriangleView {
 public:
  /// The asset must outlive this object. kUnsupported where the driver refuses the shader.
  static tl::expected<std::unique_ptr<TriangleView>, ToolError> create(const Asset& asset);
  ~TriangleView();
  TriangleView(const TriangleView&) = delete;
  TriangleView& operator=(const TriangleView&) = delete;

  /// Into the bound framebuffer, heads in the order given, each in HairRenderer's order. Leaves depth test, blending
  /// and culling off.
  void draw(const render::Camera& camera, std::span<const HairInstance> heads, const TrianglePass& pass);

 private:
  explicit TriangleView(const Asset& asset) : corners_(asset) {}
  void upload_texture(const Asset& asset);
  void make_corners();

  TriangleCorners corners_;
  std::uint32_t program_ = 0, vertex_array_ = 0, buffer_ = 0, texture_ = 0;
};

}  // namespace coif::view
