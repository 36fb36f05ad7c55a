#pragma once
// What surrounds the hair in a picture: backdrop and opaque bodies.

#include "render/camera.h"
#include "render/solid_mesh.h"
#include "tool_error.h"

#include <coif/renderer.h>
#include <coif/shadow.h>

#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

/// Draws into the bound sRGB framebuffer. Its objects are freed with the OpenGL context.
class StageRenderer {
 public:
  /// `shadow`: what draw_bodies() will be given, or null.
  static tl::expected<StageRenderer, ToolError> create(std::span<const SolidMesh> meshes,
                                                       const HairShadow* shadow = nullptr);

  /// Clears depth and fills the picture with a vertical gradient.
  void draw_backdrop() const;

  /// Draws every mesh once, matte, lit by directional `lights`, under the head's pose. `shadow` is the first light's.
  void draw_bodies(const Camera& camera, const HeadPose& head, std::span<const Light> lights,
                   const HairShadow* shadow = nullptr) const;

  /// The same without colour, for the bound shadow's depth.
  void draw_casters(const Eigen::Matrix4f& clip_from_world, const HeadPose& head) const;

 private:
  void set_placement(const Eigen::Matrix4f& clip_from_world, const HeadPose& head) const;
  void draw_meshes() const;

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
