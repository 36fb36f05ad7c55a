#include "render/order_pictures.h"

#include "render/camera.h"
#include "render/egl_context.h"
#include "render/stage_renderer.h"

#include <GLES3/gl3.h>

#include <utility>

namespace coif {
namespace {

tl::unexpected<ToolError> shot_fault(ToolError::Kind kind, std::string message) {
  return tl::unexpected(ToolError{kind, std::move(message)});
}

CrowdView view_of(std::span<const Eigen::Vector3d> points, const HairShot& shot) {
  return frame_crowd(points, {.yaw_degrees = shot.yaw_degrees,
                              .pitch_degrees = shot.pitch_degrees,
                              .aspect = double(shot.width) / shot.height});
}

DrawDesc description(const HairShot& shot, const Camera& camera) {
  DrawDesc desc;
  Eigen::Map<Eigen::Matrix4f>{desc.clip_from_world} = camera.clip_from_world;
  desc.eye = {float(camera.eye.x()), float(camera.eye.y()), float(camera.eye.z())};
  desc.material = shot.material;
  desc.transparency = shot.transparency;
  desc.framebuffer_is_srgb = true;
  return desc;
}

}  // namespace

struct OrderPictures::Device {
  using TargetSize = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

  explicit Device(EglContext opened) : context(std::move(opened)) {}

  tl::expected<const OffscreenTarget*, ToolError> target(const HairShot& shot) {
    const TargetSize size{shot.width, shot.height, shot.samples};
    const auto found = targets.find(size);
    if (found != targets.end()) return &found->second;
    // One sample is a framebuffer without multisampling: with it drivers may give more than was asked for.
    auto made = OffscreenTarget::create(shot.width, shot.height, shot.samples > 1 ? shot.samples : 0);
    if (!made) return tl::unexpected(made.error());
    return &targets.emplace(size, std::move(*made)).first->second;
  }

  EglContext context;  ///< Before what is made in it.
  HairRenderer renderer;
  std::vector<std::unique_ptr<HairModel>> models;
  StageRenderer stage;
  std::map<TargetSize, OffscreenTarget> targets;
};

OrderPictures::OrderPictures() = default;
OrderPictures::~OrderPictures() = default;

tl::expected<std::unique_ptr<OrderPictures>, ToolError> OrderPictures::create(const Asset& asset,
                                                                              const RendererDesc& desc) {
  if (!asset.is_open() || asset.vertices().empty() || asset.indices().empty()) {
    return shot_fault(ToolError::Kind::kBadInput,
                "the asset has no mesh to draw; cook it again without leaving the mesh out");
  }
  auto context = EglContext::create();
  if (!context) return tl::unexpected(context.error());
  std::unique_ptr<OrderPictures> made(new OrderPictures);
  made->points_ = framed_points(asset);
  made->device_ = std::make_unique<Device>(std::move(*context));
  Device& device = *made->device_;
  if (device.renderer.create(device.context.loader(), desc) != Status::kOk) {
    return shot_fault(ToolError::Kind::kUnsupported,
                std::string("the renderer does not start: ") + device.renderer.failure());
  }
  const auto stage = StageRenderer::create(mannequin_meshes(asset.colliders()));
  if (!stage) return tl::unexpected(stage.error());
  device.stage = *stage;
  return made;
}

tl::expected<std::size_t, ToolError> OrderPictures::add(const Asset& variant) {
  device_->models.push_back(std::make_unique<HairModel>());
  const std::size_t model = device_->models.size() - 1;
  if (auto uploaded = replace(model, variant); !uploaded) return tl::unexpected(uploaded.error());
  return model;
}

tl::expected<void, ToolError> OrderPictures::replace(std::size_t model, const Asset& variant) {
  const Status status = device_->models[model]->upload(device_->renderer, variant);
  if (status == Status::kOk) return {};
  return shot_fault(ToolError::Kind::kUnsupported,
              std::string("the driver refuses the asset: ") + describe(status) + " " + device_->renderer.failure());
}

tl::expected<void, ToolError> OrderPictures::draw_scene(const HairShot& shot, bool with_stage) {
  const auto target = device_->target(shot);
  if (!target) return tl::unexpected(target.error());
  (*target)->bind();
  const Camera camera = view_of(points_, shot).camera;
  const auto lights = studio_lights(camera);
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  if (with_stage) {
    // Only hair writes alpha, so that it tells how much of a pixel is hair.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    device_->stage.draw_backdrop();
    device_->stage.draw_bodies(camera, HeadPose{}, lights);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  DrawDesc desc = description(shot, camera);
  desc.lights = lights;
  const HairInstance head{HeadPose{}, shot.palette, shot.lod};
  const Status status = device_->renderer.draw(*device_->models[shot.model], std::span(&head, 1), desc);
  if (status == Status::kOk) return {};
  const bool is_driver = status == Status::kDriver;
  return shot_fault(is_driver ? ToolError::Kind::kUnsupported : ToolError::Kind::kBadInput,
              std::string("the hair cannot be drawn in mode '") + name_of(*shot.transparency) +
                  "': " + (is_driver ? device_->renderer.failure() : describe(status)));
}

tl::expected<Picture, ToolError> OrderPictures::take(const HairShot& shot) {
  if (auto drawn = draw_scene(shot, true); !drawn) return tl::unexpected(drawn.error());
  const auto target = device_->target(shot);
  return Picture{shot.width, shot.height, (*target)->read(), device_->context.device(), 0};
}

tl::expected<void, ToolError> OrderPictures::draw(const HairShot& shot) {
  if (auto drawn = draw_scene(shot, false); !drawn) return drawn;
  glFinish();
  return {};
}

Eigen::Vector3d OrderPictures::eye(const HairShot& shot) const { return view_of(points_, shot).camera.eye; }

const MaterialRecord& OrderPictures::material(std::size_t model) const { return device_->models[model]->material(); }

std::string OrderPictures::device() const { return device_->context.device(); }

}  // namespace coif
