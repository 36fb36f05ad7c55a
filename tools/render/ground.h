#pragma once

#include "base/tool_error.h"
#include "render/camera.h"
#include "render/stage_renderer.h"

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::render {

/// When a picture has a ground.
enum class GroundChoice {
  kWhereSeen,  ///< Where it shows the ground under a whole body.
  kAlways,
  kNever,
};

/// The shade on a level, square ground under the things that stand on it. World axes, metres, from the head's joint.
struct GroundShade {
  Eigen::Vector3f middle = Eigen::Vector3f::Zero();
  float half = 0;         ///< Half of a side; 0: nothing stands anywhere.
  float head_height = 0;  ///< Height of the joint above the ground, as a multiple of the height above the joint.
  std::vector<std::uint8_t> opacity;  ///< kSide rows towards +Z of kSide texels towards +X.

  static constexpr std::uint32_t kSide = 192;
};

/// The ground touches the lowest vertex. It is darkest where surfaces touch it, and they count for less, and are
/// softer, the higher they are: the share of the sky that they hide.
[[nodiscard]] GroundShade shade_below(std::span<const SolidMesh> meshes, const HeadPose& head);

/// Whether a picture from there has it, of a head at `place`.
[[nodiscard]] bool shows_ground(GroundChoice choice, const GroundShade& shade, const Camera& camera,
                                const Eigen::Vector3d& place);

/// Draws it into the bound framebuffer, over the backdrop, behind bodies that are drawn already. Its objects are freed
/// with the OpenGL context.
class GroundRenderer {
 public:
  static tl::expected<GroundRenderer, ToolError> create(const GroundShade& shade);

  /// Below a head at `place`. Nothing is drawn from under the ground.
  void draw(const Camera& camera, const Eigen::Vector3d& place) const;

 private:
  Eigen::Vector3f middle_ = Eigen::Vector3f::Zero();
  float half_ = 0;
  std::uint32_t program_ = 0, vertex_array_ = 0, texture_ = 0;
};

}  // namespace coif::render
