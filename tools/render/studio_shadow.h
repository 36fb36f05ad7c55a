#pragma once

#include "render/stage_renderer.h"
#include "tool_error.h"

#include <coif/shadow.h>

#include <Eigen/Core>

#include <tl/expected.hpp>

#include <memory>
#include <span>

namespace coif {

/// The ball around heads at these places (world, metres) of which each has these points (from its place); neither may be
/// empty. With room for hair that swings.
[[nodiscard]] ShadowBall ball_around(std::span<const Eigen::Vector3d> points, std::span<const Eigen::Vector3d> places);

/// The key light's shadow in a picture: of hair and bodies, on both. The context must be current as long as it lives.
class StudioShadow {
 public:
  StudioShadow(StudioShadow&&) noexcept = default;
  StudioShadow& operator=(StudioShadow&&) = delete;
  ~StudioShadow();

  /// Error: kUnsupported where the driver has no memory for it. `renderer` must outlive this object.
  static tl::expected<StudioShadow, ToolError> create(HairRenderer& renderer, const GlLoader& loader,
                                                      const ShadowDesc& desc);

  /// Draws the map. `crowd` may be null: hair casts none. Leaves no framebuffer bound.
  Status draw(const Light& light, const ShadowBall& ball, const StageRenderer& stage, std::span<const HeadPose> heads,
              const ShadowCrowd* crowd);

  [[nodiscard]] const HairShadow& shadow() const { return *shadow_; }

 private:
  StudioShadow() = default;

  std::unique_ptr<HairShadow> shadow_;
};

}  // namespace coif
