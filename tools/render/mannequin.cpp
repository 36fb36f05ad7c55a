#include "render/stage_renderer.h"

#include "base/collider_shapes.h"
#include "base/geometry.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>

namespace coif::render {
namespace {

constexpr float kLargestHead = 0.5f;  // metres

// Hair rests on the collider; drawn at full size the two would fight for the same depth.
constexpr float kMannequinScale = 0.98f;

/// Quads of a mesh from pole to pole and around.
struct Grid {
  std::uint32_t rings, sectors;
};
constexpr Grid kFine{48, 96}, kCoarse{16, 32};  // even rings: one is the equator

/// From a unit sphere's axes, with its poles on Y, to head space.
Eigen::Quaternionf orientation(const ColliderRecord& collider) {
  if (collider.shape != ColliderShape::kCapsule) return Eigen::Map<const Eigen::Quaternionf>(collider.rotation);
  const Eigen::Map<const Eigen::Vector3f> axis(collider.axis);
  return turn_between(Eigen::Vector3f(Eigen::Vector3f::UnitY()), Eigen::Vector3f(axis));
}

/// A sphere or ellipsoid; a capsule is a sphere whose upper half is moved to the segment's other end.
SolidMesh mannequin_mesh(const ColliderRecord& collider, const Grid& grid = kFine) {
  const Eigen::Map<const Eigen::Vector3f> center(collider.center);
  const Eigen::Map<const Eigen::Vector3f> axis(collider.axis);  // 0 unless a capsule
  const Eigen::Array3f radii = kMannequinScale * Eigen::Map<const Eigen::Array3f>(collider.radii);
  const Eigen::Quaternionf rotation = orientation(collider);

  SolidMesh mesh;
  for (std::uint32_t ring = 0; ring <= grid.rings; ++ring) {
    const float polar = std::numbers::pi_v<float> * static_cast<float>(ring) / static_cast<float>(grid.rings);
    const float share = 2 * ring <= grid.rings ? 1.0f : 0.0f;
    const Eigen::Vector3f ring_center = center + share * axis;
    for (std::uint32_t sector = 0; sector <= grid.sectors; ++sector) {
      const float around =
          2 * std::numbers::pi_v<float> * static_cast<float>(sector) / static_cast<float>(grid.sectors);
      const Eigen::Array3f unit(std::sin(polar) * std::sin(around), std::cos(polar),
                                std::sin(polar) * std::cos(around));
      mesh.vertices.push_back(
          {ring_center + rotation * (unit * radii).matrix(), (rotation * (unit / radii).matrix()).normalized()});
    }
  }
  const std::uint32_t row = grid.sectors + 1;
  for (std::uint32_t ring = 0; ring < grid.rings; ++ring) {
    for (std::uint32_t sector = 0; sector < grid.sectors; ++sector) {
      const std::uint32_t a = ring * row + sector;
      const std::uint32_t b = a + row;
      mesh.triangles.insert(mesh.triangles.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
  }
  return mesh;
}

}  // namespace

std::vector<SolidMesh> mannequin_meshes(std::span<const ColliderRecord> colliders, bool is_coarse) {
  std::vector<SolidMesh> meshes;
  for (const ColliderRecord& collider : colliders) {
    // A ball of a metre stands for a floor or a wall, which is not shown.
    const bool is_seen =
        is_solid(collider) && *std::max_element(std::begin(collider.radii), std::end(collider.radii)) < kLargestHead;
    if (is_seen) meshes.push_back(mannequin_mesh(collider, is_coarse ? kCoarse : kFine));
  }
  return meshes;
}

std::vector<SolidMesh> moving_meshes(std::span<const MovingCollider> colliders, const HeadPose& head) {
  const auto from = [](const Quat& q) { return Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized(); };
  const Eigen::Map<const Eigen::Vector3d> origin(head.position);
  const Eigen::Quaterniond to_head = from(head.rotation).conjugate();
  std::vector<SolidMesh> meshes;
  for (const MovingCollider& collider : colliders) {
    const bool is_ball = collider.shape == ColliderShape::kSphere;
    if (!is_ball && collider.shape != ColliderShape::kCapsule) continue;
    const Eigen::Map<const Eigen::Vector3d> place(collider.center);
    const Eigen::Vector3d own_axis(collider.axis.x, collider.axis.y, collider.axis.z);
    ColliderRecord record{};
    record.shape = collider.shape;
    record.rotation[3] = 1;
    Eigen::Map<Eigen::Vector3f>(record.center) = (to_head * (place - origin) / head.scale).cast<float>();
    if (!is_ball) {
      Eigen::Map<Eigen::Vector3f>(record.axis) =
          (to_head * (from(collider.rotation) * own_axis) / head.scale).cast<float>();
    }
    std::fill(std::begin(record.radii), std::end(record.radii), collider.radius / head.scale);
    meshes.push_back(mannequin_mesh(record));
  }
  return meshes;
}

}  // namespace coif::render
