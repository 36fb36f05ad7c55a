#pragma once

#include "motion/head_path.h"
#include "render/egl_context.h"
#include "render/ground.h"
#include "render/picture.h"
#include "render/stage_renderer.h"

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::render {

/// One picture, simulated and framed. Keeps references to its parts.
struct PictureScene {
  const HairModel& model;
  const StageRenderer& stage;
  const motion::HairPose& pose;
  const CrowdView& view;
  const ShadowBall& ball;
  const MaterialRecord& glass;  ///< For hair that one can look through.
  StudioShadow* shadow;         ///< Null: none.
  TriangleOrder* order;         ///< Null: the asset's own.
  const Asset& asset;
  const motion::HairPose& before;  ///< A frame earlier.
  const GroundRenderer* ground;    ///< Null: none.
};

/// The picture's lights, the one that casts shadows first.
[[nodiscard]] std::vector<Light> lights_of(const PictureSettings& settings, const Camera& camera);

/// The picture's bodies, ghosts, colliders and patches, with the hair in this pose.
[[nodiscard]] std::vector<SolidMesh> stage_meshes(const Asset& asset, const PictureSettings& settings,
                                                  const motion::HairPose& pose);

/// Shadows, backdrop, bodies, ground, hair.
Status draw_scene(HairRenderer& renderer, const PictureScene& scene, const OffscreenTarget& target,
                  const PictureSettings& settings);

/// Draws over the result of draw_scene().
tl::expected<void, ToolError> draw_debug_lines(const PictureScene& scene, const PictureSettings& settings);

/// Into the picture's samples, as draw_scene() left them.
tl::expected<void, ToolError> color_by_motion(HairRenderer& renderer, const PictureScene& scene,
                                              const PictureSettings& settings, std::span<float> radiance);

/// The points that a picture of a moving head frames: all places of hair and head during the first seconds of the
/// motion, and at the picture's own `time`, relative to the head's position (the camera follows it). So moments of one
/// motion share one frame. World axes, the hair's metres from the head's joint. Errors: those of simulate_poses().
tl::expected<std::vector<Eigen::Vector3d>, ToolError> points_in_motion(const Asset& asset, const motion::HeadPath* path,
                                                                       double time, const StepSettings& step,
                                                                       const Solver* solver,
                                                                       const motion::HairCompany* company = nullptr);

/// Maps radiance (linear, 0 or more) to 0..1, since a screen cannot show all of it. Values below three quarters of
/// white are unchanged; above, the brightest channel approaches white without reaching it, and the others keep their
/// ratio to it, so that highlights keep their hue and their form.
void apply_tone_curve(std::span<float, 3> radiance);

/// The light of a picture from `oversampling` times as many samples in each direction, in the order of develop().
[[nodiscard]] LinearPicture light_of(std::vector<float> samples, std::uint32_t width, std::uint32_t height,
                                     std::uint32_t oversampling);

/// Makes the pixels of a picture from `oversampling` times as many in each direction: RGBA, linear, rows top to bottom,
/// `width` * `height` blocks of them -> sRGB. The tone curve is applied to each sample first, so that an edge before a
/// highlight is as smooth as any.
[[nodiscard]] std::vector<std::uint8_t> develop(std::span<const float> samples, std::uint32_t width,
                                                std::uint32_t height, std::uint32_t oversampling);

}  // namespace coif::render
