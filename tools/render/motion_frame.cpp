#include "render/picture_scene.h"

#include "base/geometry.h"
#include "render/stage_renderer.h"

#include <coif/skinning.h>

#include <Eigen/Geometry>

#include <algorithm>

namespace coif::render {
namespace {

constexpr double kFramedSeconds = 3;
constexpr double kBetween = 0.1;              ///< Seconds from one look to the next.
constexpr std::size_t kMostPoints = 400'000;  ///< Dense hair needs only some of its points.

std::vector<double> moments_until(double time) {
  std::vector<double> moments;
  for (int i = 0; i * kBetween <= kFramedSeconds; ++i) moments.push_back(i * kBetween);
  moments.push_back(time);
  std::ranges::sort(moments);
  return moments;
}

}  // namespace

tl::expected<std::vector<Eigen::Vector3d>, ToolError> points_in_motion(const Asset& asset, const motion::HeadPath* path,
                                                                       double time, const StepSettings& step,
                                                                       const Solver* solver,
                                                                       const motion::HairCompany* company) {
  const std::vector<double> moments = path != nullptr ? moments_until(time) : std::vector<double>{0};
  const auto poses = motion::simulate_poses(asset, path, moments, step, solver, company);
  if (!poses) return tl::unexpected(poses.error());
  const std::vector<SolidMesh> head = mannequin_meshes(asset.colliders());
  const std::size_t stride = 1 + asset.vertices().size() * poses->size() / kMostPoints;
  std::vector<SkinnedVertex> skinned(asset.vertices().size());
  std::vector<Eigen::Vector3d> points;
  for (const motion::HairPose& pose : *poses) {
    const Quat& q = pose.head.rotation;
    const auto scale = double(pose.head.scale);
    const Eigen::Quaterniond turn = Eigen::Quaternionf(q.w, q.x, q.y, q.z).cast<double>().normalized();
    if (skin_vertices(asset, pose.palette, 0, skinned) != Status::kOk) continue;
    for (std::size_t v = 0; v < skinned.size(); v += stride) {
      points.push_back(scale * (turn * to_eigen(skinned[v].position).cast<double>()));
    }
    for (const SolidMesh& mesh : head) {
      for (const SolidVertex& v : mesh.vertices) points.push_back(scale * (turn * v.position.cast<double>()));
    }
  }
  return points;
}

}  // namespace coif::render
