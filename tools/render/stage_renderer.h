#pragma once
// What surrounds the hair in a picture: backdrop and opaque bodies.

#include "render/camera.h"
#include "render/solid_mesh.h"
#include "tool_error.h"

#include <coif/renderer.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// Draws into the bound sRGB framebuffer. Its objects are freed with the OpenGL context.
class StageRenderer {
 public:
  static tl::expected<StageRenderer, ToolError> create(std::span<const SolidMesh> meshes);

  /// Clears depth and fills the picture with a vertical gradient.
  void draw_backdrop() const;

  /// Draws every mesh once, matte, lit by directional `lights`, under the head's pose.
  void draw_bodies(const Camera& camera, const HeadPose& head, std::span<const Light> lights) const;

 private:
  struct Body {
    std::uint32_t vertex_array = 0;
    std::int32_t index_count = 0;
    Eigen::Vector3f color;
  };
  std::uint32_t backdrop_program_ = 0;
  std::uint32_t body_program_ = 0;
  std::uint32_t empty_vertex_array_ = 0;
  std::vector<Body> bodies_;
};

}  // namespace coif
