#pragma once

#include "render/egl_context.h"
#include "render/ground.h"
#include "render/picture.h"
#include "render/stage_renderer.h"

#include <tl/expected.hpp>

#include <span>

namespace coif::render {

/// One picture, simulated and framed. Refers to what it is made of.
struct PictureScene {
  const HairModel& model;
  const StageRenderer& stage;
  const motion::HairPose& pose;
  const CrowdView& view;
  const ShadowBall& ball;
  const MaterialRecord& glass;  ///< Of hair that is looked through.
  StudioShadow* shadow;         ///< Null: none.
  TriangleOrder* order;         ///< Null: the asset's own.
  const Asset& asset;
  const motion::HairPose& before;  ///< A frame earlier.
  const GroundRenderer* ground;    ///< Null: none.
};

/// Shadows, backdrop, bodies, ground, hair.
Status draw_scene(HairRenderer& renderer, const PictureScene& scene, const OffscreenTarget& target,
                  const PictureSettings& settings);

/// Over what draw_scene() left.
tl::expected<void, ToolError> draw_debug_lines(const PictureScene& scene, const PictureSettings& settings);

/// Into the picture's samples, as draw_scene() left them.
tl::expected<void, ToolError> color_by_motion(HairRenderer& renderer, const PictureScene& scene,
                                              const PictureSettings& settings, std::span<float> radiance);

}  // namespace coif::render
