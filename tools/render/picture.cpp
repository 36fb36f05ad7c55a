#include "render/picture.h"

#include "base/files.h"
#include "motion/head_path.h"
#include "render/camera.h"
#include "render/egl_context.h"
#include "render/gallery.h"
#include "render/ground.h"
#include "render/kept_stages.h"
#include "render/picture_scene.h"
#include "render/presentation.h"
#include "render/stage_renderer.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <iterator>
#include <utility>

namespace coif::render {
namespace {

constexpr std::uint32_t kMaxHeads = 10'000;
constexpr double kMaxSeconds = 3600;
constexpr std::uint32_t kShadowTexels = 1024;
constexpr std::uint32_t kMostSamples = 8192;

/// Checks the settings for an asset with a mesh.
tl::expected<void, ToolError> check(const Asset& asset, const PictureSettings& settings) {
  const auto side_ok = [](std::uint32_t side) { return side >= 16 && side <= 8192; };
  if (!side_ok(settings.width) || !side_ok(settings.height)) {
    return usage("a picture has 16 to 8192 pixels each way, not " + std::to_string(settings.width) + " x " +
                 std::to_string(settings.height));
  }
  if (settings.heads < 1 || settings.heads > kMaxHeads) {
    return usage("a picture shows 1 to 10000 heads, not " + std::to_string(settings.heads));
  }
  if (!(settings.time >= 0 && settings.time <= kMaxSeconds)) {
    return failure(ToolError::Kind::kUsage,
                   "the time in a motion is 0 to 3600 seconds, not " + std::to_string(settings.time));
  }
  if (!(settings.margin >= 1 && settings.margin <= 10)) {
    return usage("a picture's margin is 1 to 10, not " + std::to_string(settings.margin));
  }
  if (!std::isfinite(settings.yaw_degrees) || !std::isfinite(settings.pitch_degrees)) {
    return usage("yaw and pitch of the view are not finite numbers");
  }
  if (settings.camera && settings.heads != 1) return usage("a camera of your own shows one head");
  if (settings.oversampling < 1 || settings.oversampling > 4) {
    return usage("a picture has 1 to 4 samples of a pixel each way, not " + std::to_string(settings.oversampling));
  }
  if (std::uint64_t{std::max(settings.width, settings.height)} * settings.oversampling > kMostSamples) {
    return usage("a picture has at most 8192 samples each way; ask for fewer of each pixel, or a smaller picture");
  }
  if (settings.lod >= asset.lod_count()) {
    return usage("there is no level of detail " + std::to_string(settings.lod) + "; the asset has " +
                 std::to_string(asset.lod_count()) + ", counted from 0");
  }
  return {};
}

/// Hair that one can look through.
MaterialRecord like_glass(const Asset& asset) {
  constexpr float kAlpha = 0.3f;
  MaterialRecord material = thesis_material(asset);
  material.base_color[3] = kAlpha;
  material.opaque_threshold = 1;
  material.discard_threshold = 0;
  return material;
}

/// None where the picture has no ground.
tl::expected<std::optional<GroundRenderer>, ToolError> ground_of(const PictureSettings& settings,
                                                                 std::span<const SolidMesh> meshes,
                                                                 const HeadPose& head, const CrowdView& view) {
  if (settings.ground == GroundChoice::kNever) return std::nullopt;
  const GroundShade shade = shade_below(meshes, head);
  if (!shows_ground(settings.ground, shade, view.camera, view.places.front())) return std::nullopt;
  auto ground = GroundRenderer::create(shade);
  if (!ground) return tl::unexpected(ground.error());
  return std::optional(*ground);
}

/// The driver's samples are used if the user wants them, if transparency is made of them, or if there are no others.
std::uint32_t samples_of_driver(const PictureSettings& settings) {
  const bool needs_them =
      covers_samples(*settings.transparency) || (settings.edge_samples == 0 && settings.oversampling == 1);
  const std::uint32_t samples = std::max(needs_them ? samples_for(*settings.transparency) : 0, settings.edge_samples);
  return samples > 1 ? samples : 0;
}

tl::expected<Picture, ToolError> take_picture(DrawingDevice& device, KeptTargets& targets, const PictureScene& scene,
                                              const PictureSettings& settings) {
  const std::uint32_t finer = settings.oversampling;
  const auto kept = targets.of_size(settings.width * finer, settings.height * finer, samples_of_driver(settings));
  if (!kept) return tl::unexpected(kept.error());
  const OffscreenTarget& target = **kept;
  Picture picture{settings.width, settings.height, {}, device.context.device(), 0, target.samples(), scene.view.camera};
  picture.lights = lights_of(settings, scene.view.camera);
  for (int frame = settings.warm_up ? 0 : 1; frame < 2; ++frame) {
    glFinish();
    const auto start = std::chrono::steady_clock::now();
    if (const Status status = draw_scene(device.renderer, scene, target, settings); status != Status::kOk) {
      return failure(ToolError::Kind::kBadInput, std::string("the hair cannot be drawn: ") + describe(status));
    }
    glFinish();
    picture.draw_ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
  }
  if (settings.debug.has_lines()) {
    if (auto drawn = draw_debug_lines(scene, settings); !drawn) return tl::unexpected(drawn.error());
  }
  std::vector<float> radiance = target.read_radiance();
  if (settings.debug.motion) {
    if (auto drawn = color_by_motion(device.renderer, scene, settings, radiance); !drawn) {
      return tl::unexpected(drawn.error());
    }
  }
  picture.rgba = develop(radiance, settings.width, settings.height, finer);
  if (settings.keeps_light) picture.light = light_of(std::move(radiance), settings.width, settings.height, finer);
  return picture;
}

/// Null: at rest. A clip keeps the file's directions; built-in motions go where the face looks.
std::shared_ptr<const motion::HeadPath> played_path(const Asset& asset, const PictureSettings& settings) {
  if (settings.clip) return settings.clip;
  if (!settings.motion) return nullptr;
  auto path = motion::path_of(*settings.motion);
  return yaw_of_face(asset) != 0 ? motion::turned_round(std::move(path)) : std::move(path);
}

tl::expected<std::vector<Eigen::Vector3d>, ToolError> what_is_framed(const Asset& asset,
                                                                     const PictureSettings& settings,
                                                                     const motion::HeadPath* path) {
  const Vec3& wind = settings.step.environment.wind;
  const bool is_still = path == nullptr && wind.x == 0 && wind.y == 0 && wind.z == 0 &&
                        (settings.company == nullptr || settings.company->gusts.amplitude == 0);
  if (is_still) return framed_points(asset);
  return points_in_motion(asset, path, settings.time, settings.step, settings.solver, settings.company.get());
}

}  // namespace

tl::expected<FramedPicture, ToolError> frame_picture(const Asset& asset, const PictureSettings& settings) {
  auto points = what_is_framed(asset, settings, played_path(asset, settings).get());
  if (!points) return tl::unexpected(points.error());
  // A face may be longer than the part that hair lies on, so the frame takes it in.
  if (settings.bust && settings.mannequin && !settings.colliders) {
    std::ranges::move(bust_outline(asset.colliders(), yaw_of_face(asset) != 0), std::back_inserter(*points));
  }
  const double aspect = double(settings.width) / settings.height;
  if (settings.camera) {
    CrowdView placed = view_from(*settings.camera, aspect, *points);
    return FramedPicture{std::move(*points), std::move(placed)};
  }
  const CameraSettings camera{.yaw_degrees = settings.yaw_degrees + yaw_of_face(asset),
                              .pitch_degrees = settings.pitch_degrees,
                              .aspect = aspect,
                              .heads = settings.heads,
                              .margin = settings.margin};
  CrowdView view = frame_crowd(*points, camera);
  return FramedPicture{std::move(*points), std::move(view)};
}

/// The asset in the context. Objects of the context die with it, last.
struct PictureMaker::Loaded {
  Loaded(const Asset& source, std::unique_ptr<DrawingDevice> opened) : asset(source), device(std::move(opened)) {}

  const Asset& asset;
  std::unique_ptr<DrawingDevice> device;
  HairModel model;
  KeptStages stages;
  KeptTargets targets;
};

PictureMaker::PictureMaker(std::unique_ptr<Loaded> loaded) : loaded_(std::move(loaded)) {}
PictureMaker::PictureMaker(PictureMaker&&) noexcept = default;
PictureMaker::~PictureMaker() = default;

tl::expected<PictureMaker, ToolError> PictureMaker::create(const Asset& asset) {
  if (const auto checked = check_drawable(asset); !checked) return tl::unexpected(checked.error());
  auto device = DrawingDevice::create({.stream_bytes = stream_bytes_for(asset)});
  if (!device) return tl::unexpected(device.error());
  auto loaded = std::make_unique<Loaded>(asset, std::move(*device));
  if (const Status status = loaded->model.upload(loaded->device->renderer, asset); status != Status::kOk) {
    return failure(ToolError::Kind::kUnsupported, std::string("the driver refuses the asset: ") + describe(status));
  }
  return PictureMaker(std::move(loaded));
}

tl::expected<Picture, ToolError> PictureMaker::take(const PictureSettings& settings) {
  const Asset& asset = loaded_->asset;
  if (const auto checked = check(asset, settings); !checked) return tl::unexpected(checked.error());
  const auto path = played_path(asset, settings);
  constexpr double kFrame = 1.0 / 60;  // seconds
  const double moments[2] = {std::max(settings.time - kFrame, 0.0), settings.time};
  const auto poses =
      motion::simulate_poses(asset, path.get(), moments, settings.step, settings.solver, settings.company.get());
  if (!poses) return tl::unexpected(poses.error());
  std::vector<SolidMesh> meshes = stage_meshes(asset, settings, poses->back());
  const motion::HairPose &before = poses->front(), &pose = poses->back();
  std::optional<StudioShadow> shadow;
  if (settings.shadows != nullptr && !settings.colliders) {
    auto made = StudioShadow::create(loaded_->device->renderer, loaded_->device->context.loader(),
                                     {.technique = settings.shadows, .size = kShadowTexels});
    if (!made) return tl::unexpected(made.error());
    shadow.emplace(std::move(*made));
  }
  const auto frame = frame_picture(asset, settings);
  if (!frame) return tl::unexpected(frame.error());
  const ShadowBall ball = ball_around(frame->points, frame->view.places);
  auto ground = ground_of(settings, meshes, pose.head, frame->view);
  if (!ground) return tl::unexpected(ground.error());
  const auto stage =
      loaded_->stages.with(std::move(meshes), shadow ? &shadow->shadow() : nullptr, rig_body_look(settings.lights));
  if (!stage) return tl::unexpected(stage.error());
  const MaterialRecord glass = like_glass(asset);
  std::unique_ptr<KeptBoneOrder> order;
  if (settings.order == OrderChoice::kBones) {
    auto kept = KeptBoneOrder::create(asset);
    if (!kept) return tl::unexpected(kept.error());
    order = std::move(*kept);
  }
  const PictureScene scene{loaded_->model,
                           **stage,
                           pose,
                           frame->view,
                           ball,
                           glass,
                           shadow ? &*shadow : nullptr,
                           order ? &order->order() : nullptr,
                           asset,
                           before,
                           *ground ? &**ground : nullptr};
  return take_picture(*loaded_->device, loaded_->targets, scene, settings);
}

tl::expected<Picture, ToolError> render_picture(const Asset& asset, const PictureSettings& settings) {
  // Before a driver is needed.
  if (const auto checked = check_drawable(asset); !checked) return tl::unexpected(checked.error());
  if (const auto checked = check(asset, settings); !checked) return tl::unexpected(checked.error());
  auto maker = PictureMaker::create(asset);
  if (!maker) return tl::unexpected(maker.error());
  return maker->take(settings);
}

tl::expected<void, ToolError> write_png(const std::string& path, const Picture& picture) {
  const std::vector<std::uint8_t> png = encode_png_quickly(picture.rgba, picture.width, picture.height);
  if (png.empty()) return failure(ToolError::Kind::kInternal, "out of memory");
  return write_output(path, std::as_bytes(std::span(png)));
}

}  // namespace coif::render
