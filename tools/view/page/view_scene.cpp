#include "view/page/view_scene.h"

#include "render/stage_renderer.h"

#include <coif/webgl.h>

#include <GLES3/gl3.h>

#include <algorithm>
#include <string>

namespace coif::view {
namespace {

constexpr std::uint32_t kShadowTexels = 1024;
constexpr std::uint32_t kCoveredSamples = 4;
constexpr float kLineThickness = 1.5f;  // pixels of the canvas

std::uint32_t finer_of(const ViewSettings& settings) { return settings.samples >= 2 ? 2 : 1; }

tl::unexpected<ToolError> refused(const char* what, const char* why) {
  return failure(ToolError::Kind::kUnsupported, std::string("the browser's WebGL refuses ") + what + ": " + why);
}

}  // namespace

tl::expected<std::unique_ptr<ViewScene>, ToolError> ViewScene::create(const Asset& asset,
                                                                      std::shared_ptr<const PageBody> body) {
  std::unique_ptr<ViewScene> scene(new ViewScene(asset, std::move(body)));
  if (auto made = scene->make(); !made) return tl::unexpected(made.error());
  return scene;
}

ViewScene::~ViewScene() {
  if (target_) target_->destroy();
  shadow_.destroy();
  model_.destroy();
  renderer_.destroy();
}

tl::expected<void, ToolError> ViewScene::make() {
  RendererDesc desc;
  scratch_.resize(desc.stream_bytes / 4);
  desc.webgl = &kWebGl;
  desc.scratch = scratch_;
  if (renderer_.create(web_gl_loader(), desc) != Status::kOk) return refused("the renderer", renderer_.failure());
  if (const Status status = model_.upload(renderer_, asset_); status != Status::kOk) {
    return refused("the asset", status == Status::kDriver ? renderer_.failure() : describe(status));
  }
  auto lines = render::LineOverlay::create();
  if (!lines) return tl::unexpected(lines.error());
  lines_ = *lines;
  auto target = DevelopedTarget::create();
  if (!target) return tl::unexpected(target.error());
  target_ = *target;
  return {};
}

tl::expected<void, ToolError> ViewScene::choose_shadow(const ShadowTechnique* technique) {
  if (stage_ && technique == technique_) return {};
  shadow_.destroy();
  if (technique != nullptr) {
    const ShadowDesc desc{.technique = technique, .size = kShadowTexels};
    if (shadow_.create(renderer_, web_gl_loader(), desc) != Status::kOk) {
      return refused("these shadows", renderer_.failure());
    }
  }
  if (stage_) stage_->destroy();
  auto stage = render::StageRenderer::create(stage_meshes(), technique != nullptr ? &shadow_ : nullptr);
  if (!stage) return tl::unexpected(stage.error());
  stage_ = std::move(*stage);
  technique_ = technique;
  body_turn_ = {};
  return {};
}

std::vector<render::SolidMesh> ViewScene::stage_meshes() const {
  if (!body_) return render::mannequin_meshes(asset_.colliders());
  const Eigen::Map<const Eigen::Vector3f> head_joint(asset_.skeleton().head_joint);
  std::vector<render::SolidMesh> meshes;
  for (const PageBodyMesh& body : body_->meshes) {
    for (render::SolidVertex& vertex : meshes.emplace_back(body.mesh).vertices) vertex.position -= head_joint;
  }
  return meshes;
}

void ViewScene::turn_body(const Quat& turn) {
  const bool is_new =
      turn.x != body_turn_.x || turn.y != body_turn_.y || turn.z != body_turn_.z || turn.w != body_turn_.w;
  if (!body_ || !is_new) return;
  const Eigen::Map<const Eigen::Vector3f> head_joint(asset_.skeleton().head_joint);
  for (std::size_t m = 0; m < body_->meshes.size(); ++m) {
    const PageBodyMesh& body = body_->meshes[m];
    if (body.turning.empty()) continue;
    turned_ = body.mesh.vertices;
    for (render::SolidVertex& vertex : turned_) vertex.position -= head_joint;
    render::turn_back(body.turning, turn, turned_);
    stage_->move(m, turned_);
  }
  body_turn_ = turn;
}

const render::CrowdView& ViewScene::view(const ViewSettings& settings, double aspect, std::uint32_t heads) {
  const Framed wanted{settings.yaw, settings.pitch, settings.zoom, aspect, heads};
  if (wanted == framed_) return view_;
  render::CameraSettings camera;
  camera.yaw_degrees = double(settings.yaw) + render::yaw_of_face(asset_);
  camera.pitch_degrees = double(settings.pitch);
  camera.aspect = aspect;
  camera.heads = heads;
  camera.margin /= std::clamp(double(settings.zoom), 0.1, 20.0);
  view_ = render::frame_crowd(points_, camera);
  framed_ = wanted;
  return view_;
}

Status ViewScene::cast(const ShadowCrowd& crowd, std::span<const HairInstance> heads, const render::CrowdView& view,
                       const Light& light) {
  if (const Status begun = shadow_.begin(light, render::ball_around(points_, view.places)); begun != Status::kOk)
    return begun;
  Eigen::Matrix4f clip;
  float columns[16];
  shadow_.clip_from_origin({}, columns);
  clip = Eigen::Map<const Eigen::Matrix4f>(columns);
  for (const HairInstance& head : heads) stage_->draw_casters(clip, head.head);
  return shadow_.draw({&crowd, 1});
}

tl::expected<void, ToolError> ViewScene::draw(const ViewSettings& settings, const render::CrowdView& view,
                                              std::span<const HairInstance> heads, std::uint32_t width,
                                              std::uint32_t height) {
  const bool shows_hair = hair_view_of(settings.view) == HairView::kHair;
  if (auto chosen = choose_shadow(shows_hair ? shadows_of(settings) : nullptr); !chosen) return chosen;
  if (!heads.empty()) turn_body(heads.front().head.rotation);
  const std::uint32_t finer = finer_of(settings);
  const TransparencyMode& mode = transparency_of(settings);
  const bool needs_samples = finer == 1 || render::covers_samples(mode);
  if (!target_->resize(width, height, finer, needs_samples ? kCoveredSamples : 0)) {
    return refused("a picture of this size", "make the window smaller, or take fewer samples");
  }
  const MaterialRecord material = material_of(asset_, settings);
  const auto lights = render::studio_lights(view.camera);
  DrawDesc desc = render::studio_desc(view.camera, lights);
  desc.component = component_of(settings);
  desc.material = &material;
  desc.transparency = &mode;
  Status status = Status::kOk;
  if (technique_ != nullptr) {
    status = cast({&model_, heads, &material}, heads, view, lights[0]);
    desc.shadow = &shadow_;
  }
  target_->bind();
  stage_->draw_backdrop();
  for (const HairInstance& head : heads) stage_->draw_bodies(view.camera, head.head, lights, desc.shadow);
  if (status == Status::kOk && shows_hair) status = renderer_.draw(model_, heads, desc);
  if (status != Status::kOk)
    return refused("the hair", status == Status::kDriver ? renderer_.failure() : describe(status));
  if (!shows_hair) {
    if (auto drawn = painter_.draw(settings, view.camera, heads, *stage_, *target_); !drawn) return drawn;
  }
  if (auto drawn = draw_lines(settings, view.camera, heads); !drawn) return drawn;
  target_->develop();
  return {};
}

tl::expected<void, ToolError> ViewScene::draw_lines(const ViewSettings& settings, const render::Camera& camera,
                                                    std::span<const HairInstance> heads) const {
  const render::DebugView shown{.bones = settings.bones != 0,
                                .colliders = settings.colliders != 0,
                                .contacts = settings.contacts != 0,
                                .limits = settings.limits != 0};
  if (!shown.has_lines()) return {};
  std::vector<DebugLine> lines;
  for (const HairInstance& head : heads) {
    const auto own = render::debug_lines_of(asset_, head, shown);
    if (!own) return tl::unexpected(own.error());
    lines.insert(lines.end(), own->begin(), own->end());
  }
  lines_->draw(camera, lines, target_->width(), target_->height(), kLineThickness * float(finer_of(settings)));
  return {};
}

}  // namespace coif::view
