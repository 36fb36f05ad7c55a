// What stands on a picture's stage beside the hair.

#include "render/picture_scene.h"
#include "render/presentation.h"
#include "render/stage_renderer.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace coif::render {
namespace {

constexpr float kColliderColor[3] = {0.08f, 0.25f, 0.6f};  ///< Linear; no hair and no clay has it.

bool shows_bust(const PictureSettings& settings) {
  return settings.bust && settings.mannequin && settings.body == nullptr && !settings.colliders;
}

}  // namespace

std::vector<SolidMesh> stage_meshes(const Asset& asset, const PictureSettings& settings, const motion::HairPose& pose) {
  std::vector<SolidMesh> meshes;
  const Eigen::Map<const Eigen::Vector3f> head_joint(asset.skeleton().head_joint);
  if (settings.body != nullptr) {
    const char* const head_bone = asset.bone_name(0);
    const BodyTurn body{head_bone != nullptr ? head_bone : "", pose.head.rotation};
    for (const importer::SourceMesh& mesh : settings.body->meshes) {
      dress(*settings.body, mesh, settings.body_textures,
            meshes.emplace_back(body_mesh(*settings.body, mesh, head_joint, body)));
    }
  }
  if (settings.ghost != nullptr) {
    for (const importer::SourceMesh& mesh : settings.ghost->meshes)
      meshes.emplace_back(body_mesh(*settings.ghost, mesh, head_joint)).is_ghost = true;
  }
  const bool wants_head = settings.body == nullptr && settings.mannequin;
  if (shows_bust(settings)) {
    std::ranges::move(bust_meshes(asset.colliders(), yaw_of_face(asset) != 0), std::back_inserter(meshes));
  }
  if (settings.colliders || (wants_head && std::ranges::all_of(meshes, &SolidMesh::is_ghost))) {
    for (SolidMesh& mesh : mannequin_meshes(asset.colliders(), settings.coarse_mannequin)) {
      if (settings.colliders) mesh.color = Eigen::Vector3f(kColliderColor);
      meshes.push_back(std::move(mesh));
    }
  }
  if (settings.company && settings.company->colliders) {
    const auto moving = settings.company->colliders(settings.time);
    for (SolidMesh& mesh : moving_meshes(moving, pose.head)) meshes.push_back(std::move(mesh));
  }
  if (settings.patches) {
    std::vector<SolidMesh> patches = patch_surfaces(asset, pose.palette, settings.lod);
    if (settings.marked_patch) mark_patch(*settings.marked_patch, patches);
    for (SolidMesh& patch : patches) meshes.push_back(std::move(patch));
  }
  return meshes;
}

}  // namespace coif::render
