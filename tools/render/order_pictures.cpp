#include "render/order_pictures.h"

#include "render/camera.h"
#include "render/egl_context.h"
#include "render/stage_renderer.h"

#include <GLES3/gl3.h>

#include <utility>

namespace coif::render {
namespace {

CrowdView view_of(std::span<const Eigen::Vector3d> points, const HairShot& shot) {
  return frame_crowd(points, {.yaw_degrees = shot.yaw_degrees,
                              .pitch_degrees = shot.pitch_degrees,
                              .aspect = double(shot.width) / shot.height});
}

}  // namespace

struct OrderPictures::Device {
  using TargetSize = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

  explicit Device(std::unique_ptr<DrawingDevice> opened) : drawing(std::move(opened)) {}

  tl::expected<const OffscreenTarget*, ToolError> target(const HairShot& shot) {
    const TargetSize size{shot.width, shot.height, shot.samples};
    const auto found = targets.find(size);
    if (found != targets.end()) return &found->second;
    // One sample means a framebuffer without multisampling; with it drivers may give more samples than requested.
    auto made = OffscreenTarget::create(shot.width, shot.height, shot.samples > 1 ? shot.samples : 0);
    if (!made) return tl::unexpected(made.error());
    return &targets.emplace(size, std::move(*made)).first->second;
  }

  std::unique_ptr<DrawingDevice> drawing;  ///< Destroyed after the objects made in it.
  std::vector<std::unique_ptr<HairModel>> models;
  StageRenderer stage;
  std::map<TargetSize, OffscreenTarget> targets;
};

OrderPictures::OrderPictures() = default;
OrderPictures::~OrderPictures() = default;

tl::expected<std::unique_ptr<OrderPictures>, ToolError> OrderPictures::create(const Asset& asset,
                                                                              const RendererDesc& desc) {
  if (auto drawable = check_drawable(asset); !drawable) return tl::unexpected(drawable.error());
  auto drawing = DrawingDevice::create(desc);
  if (!drawing) return tl::unexpected(drawing.error());
  std::unique_ptr<OrderPictures> made(new OrderPictures);
  made->points_ = framed_points(asset);
  made->device_ = std::make_unique<Device>(std::move(*drawing));
  const auto stage = StageRenderer::create(mannequin_meshes(asset.colliders()));
  if (!stage) return tl::unexpected(stage.error());
  made->device_->stage = *stage;
  return made;
}

tl::expected<std::size_t, ToolError> OrderPictures::add(const Asset& variant) {
  device_->models.push_back(std::make_unique<HairModel>());
  const std::size_t model = device_->models.size() - 1;
  if (auto uploaded = replace(model, variant); !uploaded) return tl::unexpected(uploaded.error());
  return model;
}

tl::expected<void, ToolError> OrderPictures::replace(std::size_t model, const Asset& variant) {
  const Status status = device_->models[model]->upload(device_->drawing->renderer, variant);
  if (status == Status::kOk) return {};
  return failure(ToolError::Kind::kUnsupported, std::string("the driver refuses the asset: ") + describe(status) + " " +
                                                    device_->drawing->renderer.failure());
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
    // Only hair writes alpha, so it shows how much of a pixel is hair.
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    device_->stage.draw_backdrop();
    device_->stage.draw_bodies(camera, HeadPose{}, lights);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  }
  DrawDesc desc = studio_desc(camera, lights);
  desc.material = shot.material;
  desc.transparency = shot.transparency;
  desc.order = shot.order;
  const HairInstance head{HeadPose{}, shot.palette, shot.lod};
  const Status status = device_->drawing->renderer.draw(*device_->models[shot.model], std::span(&head, 1), desc);
  if (status == Status::kOk) return {};
  const bool is_driver = status == Status::kDriver;
  return failure(is_driver ? ToolError::Kind::kUnsupported : ToolError::Kind::kBadInput,
                 std::string("the hair cannot be drawn in mode '") + name_of(*shot.transparency) +
                     "': " + (is_driver ? device_->drawing->renderer.failure() : describe(status)));
}

tl::expected<Picture, ToolError> OrderPictures::take(const HairShot& shot) {
  if (auto drawn = draw_scene(shot, true); !drawn) return tl::unexpected(drawn.error());
  const auto target = device_->target(shot);
  return Picture{shot.width, shot.height, (*target)->read(), device_->drawing->context.device(), 0};
}

tl::expected<void, ToolError> OrderPictures::draw(const HairShot& shot) {
  if (auto drawn = draw_scene(shot, false); !drawn) return drawn;
  glFinish();
  return {};
}

Eigen::Vector3d OrderPictures::eye(const HairShot& shot) const { return view_of(points_, shot).camera.eye; }

const MaterialRecord& OrderPictures::material(std::size_t model) const { return device_->models[model]->material(); }

std::string OrderPictures::device() const { return device_->drawing->context.device(); }

}  // namespace coif::render
