#include "render/picture_scene.h"

#include "base/geometry.h"
#include "render/motion_colors.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <string>
#include <vector>

namespace coif::render {
namespace {

/// The camera follows the head: the picture's world begins at each head's joint.
std::vector<HairInstance> placed_heads(const PictureScene& scene, const motion::HairPose& pose, std::uint32_t lod) {
  std::vector<HairInstance> heads;
  for (const Eigen::Vector3d& place : scene.view.places) {
    heads.push_back({pose.head, pose.palette, lod});
    Eigen::Map<Eigen::Vector3d>{heads.back().head.position} = place;
  }
  return heads;
}

}  // namespace

std::vector<Light> lights_of(const PictureSettings& settings, const Camera& camera) {
  if (settings.light) return settings.light->lights;
  const auto rig = rig_lights(settings.lights, camera);
  return {rig.begin(), rig.end()};
}

Status draw_scene(HairRenderer& renderer, const PictureScene& scene, const OffscreenTarget& target,
                  const PictureSettings& settings) {
  const std::vector<Light> lights = lights_of(settings, scene.view.camera);
  DrawDesc desc = studio_desc(scene.view.camera, lights);
  desc.component = settings.component;
  const MaterialRecord* const own = settings.material ? &*settings.material : nullptr;
  desc.material = settings.colliders ? &scene.glass : own;
  MaterialRecord lit;
  if (settings.light) {
    lit = desc.material != nullptr ? *desc.material : scene.model.material();
    std::ranges::copy(settings.light->sky, lit.ambient);
    desc.material = &lit;
  }
  desc.transparency = settings.transparency;
  desc.order = scene.order;

  const std::vector<HairInstance> heads = placed_heads(scene, scene.pose, settings.lod);
  std::vector<HeadPose> poses;
  for (const HairInstance& head : heads) poses.push_back(head.head);
  if (scene.shadow != nullptr && !lights.empty()) {
    const ShadowCrowd crowd{&scene.model, heads, desc.material};
    const Status drawn =
        scene.shadow->draw(lights[0], scene.ball, scene.stage, poses, settings.patches ? nullptr : &crowd);
    if (drawn != Status::kOk) return drawn;
    desc.shadow = &scene.shadow->shadow();
  }
  target.bind();
  scene.stage.draw_backdrop(settings.backdrop);
  // A mannequin is closed: its near side hides its far side. Patches and bodies may be open.
  const bool is_closed = settings.coarse_mannequin && !settings.patches && settings.body == nullptr;
  if (is_closed) glEnable(GL_CULL_FACE);
  for (const HeadPose& pose : poses) {
    if (settings.cuts_out_bodies) {
      scene.stage.cut_out_bodies(scene.view.camera, pose);
    } else {
      scene.stage.draw_bodies(scene.view.camera, pose, lights, desc.shadow);
    }
  }
  if (is_closed) glDisable(GL_CULL_FACE);
  if (scene.ground != nullptr) {
    for (const Eigen::Vector3d& place : scene.view.places) scene.ground->draw(scene.view.camera, place);
  }
  // Patches are on the stage.
  const Status drawn = settings.patches ? Status::kOk : renderer.draw(scene.model, heads, desc);
  for (const HeadPose& pose : poses) scene.stage.draw_ghosts(scene.view.camera, pose, lights);
  return drawn;
}

tl::expected<void, ToolError> draw_debug_lines(const PictureScene& scene, const PictureSettings& settings) {
  std::vector<DebugLine> lines;
  for (const HairInstance& head : placed_heads(scene, scene.pose, settings.lod)) {
    const auto own = debug_lines_of(scene.asset, head, settings.debug);
    if (!own) return tl::unexpected(own.error());
    lines.insert(lines.end(), own->begin(), own->end());
  }
  constexpr float kThickness = 1.5f;  // pixels of the finished picture
  const std::uint32_t finer = settings.oversampling;
  return draw_over(scene.view.camera, lines, settings.width * finer, settings.height * finer,
                   kThickness * float(finer));
}

tl::expected<void, ToolError> color_by_motion(HairRenderer& renderer, const PictureScene& scene,
                                              const PictureSettings& settings, std::span<float> radiance) {
  const auto target =
      MotionTarget::create(settings.width * settings.oversampling, settings.height * settings.oversampling);
  if (!target) return tl::unexpected(target.error());
  const std::vector<HairInstance> heads = placed_heads(scene, scene.pose, settings.lod);
  const std::vector<HairInstance> before = placed_heads(scene, scene.before, settings.lod);
  MotionDesc desc;
  Eigen::Map<Eigen::Matrix4f>{desc.clip_from_world} = scene.view.camera.clip_from_world;
  Eigen::Map<Eigen::Matrix4f>{desc.previous_clip_from_world} = scene.view.camera.clip_from_world;
  desc.eye = desc.previous_eye = to_vec3(scene.view.camera.eye);
  target->begin();
  for (const HairInstance& head : heads) scene.stage.draw_casters(scene.view.camera.clip_from_world, head.head);
  const Status status = draw_motion_vectors(renderer, scene.model, heads, before, desc);
  if (status != Status::kOk) {
    return failure(ToolError::Kind::kBadInput, std::string("the hair's motion cannot be drawn: ") + describe(status));
  }
  target->color(radiance);
  return {};
}

}  // namespace coif::render
