#include "render/presentation.h"

#include "base/collider_shapes.h"
#include "mannequin/portrait.h"
#include "mannequin/solid_shapes.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace coif::render {
namespace {

struct HeadBall {
  Eigen::Vector3f center, radii;  ///< Metres.
};

// Parts of the portrait: the skull alone, which hair lies on, and skull with face.
const HeadBall kSkull{{0, 1.630f, -0.012f}, {0.0760f, 0.0915f, 0.0975f}};
const HeadBall kWholeHead{{0, 1.606f, -0.006f}, {0.0760f, 0.1140f, 0.1010f}};

/// The largest solid ball that is no floor or wall.
std::optional<HeadBall> head_among(std::span<const ColliderRecord> colliders) {
  constexpr float kLargestHeadRadius = 0.5f;  // metres
  std::optional<HeadBall> head;
  for (const ColliderRecord& collider : colliders) {
    const bool is_ball = collider.shape == ColliderShape::kSphere || collider.shape == ColliderShape::kEllipsoid;
    const HeadBall ball{Eigen::Vector3f(collider.center), Eigen::Vector3f(collider.radii)};
    if (!is_ball || !is_solid(collider) || ball.radii.maxCoeff() >= kLargestHeadRadius) continue;
    if (!head || ball.radii.prod() > head->radii.prod()) head = ball;
  }
  return head;
}

/// The part of the portrait that a collider of that shape stands for: the longer, the more of the face.
HeadBall part_like(const HeadBall& ball) {
  const auto length = [](const HeadBall& b) { return b.radii.y() / b.radii.x(); };
  const float face = std::clamp((length(ball) - length(kSkull)) / (length(kWholeHead) - length(kSkull)), 0.0f, 1.0f);
  return {kSkull.center + face * (kWholeHead.center - kSkull.center),
          kSkull.radii + face * (kWholeHead.radii - kSkull.radii)};
}

/// The transform from the portrait to the head that a collider stands for.
class PortraitPlace {
 public:
  PortraitPlace(const HeadBall& head, bool faces_backwards)
      : from_(part_like(head)), to_(head), turn_(faces_backwards ? -1 : 1, 1, faces_backwards ? -1 : 1) {
    // One factor for all axes: a face that is too broad looks wrong.
    scale_ = head.radii.cwiseQuotient(from_.radii).mean();
  }

  [[nodiscard]] Eigen::Vector3f direction(const Eigen::Vector3d& own) const {
    return turn_.cwiseProduct(own.cast<float>());
  }

  /// The skull is kept inside the collider, which hair lies on, whatever a skull of that size would be.
  [[nodiscard]] Eigen::Vector3f point(const Eigen::Vector3d& own) const {
    constexpr float kInside = 0.97f;
    const Eigen::Vector3f free = scale_ * direction(own - from_.center.cast<double>());
    const float reach = free.cwiseQuotient(to_.radii).norm();
    const double high = mannequin::smooth_step(1.626, 1.684, own.y());
    const double behind =
        mannequin::smooth_step(0.010, -0.040, own.z()) * mannequin::smooth_step(1.545, 1.585, own.y());
    const float excess = std::max(1 - kInside / std::max(reach, kInside), 0.0f) * float(std::max(high, behind));
    return to_.center + (1 - excess) * free;
  }

 private:
  HeadBall from_, to_;
  Eigen::Vector3f turn_;
  float scale_ = 1;
};

SolidMesh solid_part(const mannequin::PortraitPart& part, const PortraitPlace& place) {
  SolidMesh mesh;
  for (std::size_t i = 0; i < part.mesh.positions.size(); ++i) {
    SolidVertex& vertex = mesh.vertices.emplace_back();
    vertex.position = place.point(part.mesh.positions[i]);
    vertex.normal = place.direction(part.mesh.normals[i]);
    if (!part.mesh.uvs.empty()) vertex.uv = part.mesh.uvs[i].cast<float>();
  }
  mesh.triangles = part.mesh.triangles;
  mesh.color = Eigen::Vector3d(part.material.red, part.material.green, part.material.blue).cast<float>();
  mesh.roughness = float(part.material.roughness);
  if (part.image)
    mesh.texture = std::make_shared<SolidTexture>(part.image->width, part.image->height, part.image->rgba);
  return mesh;
}

}  // namespace

std::vector<SolidMesh> bust_meshes(std::span<const ColliderRecord> colliders, bool faces_backwards) {
  const auto head = head_among(colliders);
  std::vector<SolidMesh> meshes;
  if (!head) return meshes;
  const mannequin::PortraitDetail detail{.spacing = 1.8, .texels = 384, .has_shoulders = false};
  for (const mannequin::PortraitPart& part : mannequin::make_portrait_parts(detail)) {
    meshes.push_back(solid_part(part, PortraitPlace(*head, faces_backwards)));
  }
  return meshes;
}

std::vector<Eigen::Vector3d> bust_outline(std::span<const ColliderRecord> colliders, bool faces_backwards) {
  // Crown, ears, nape, nose, chin, and the neck's end all around.
  constexpr double kOutline[][3] = {
      {0, 1.720, -0.012}, {0.082, 1.600, -0.01}, {-0.082, 1.600, -0.01}, {0, 1.630, -0.108}, {0, 1.568, 0.106},
      {0, 1.492, 0.075},  {0.055, 1.450, -0.03}, {-0.055, 1.450, -0.03}, {0, 1.450, 0.025},  {0, 1.450, -0.095}};
  const auto head = head_among(colliders);
  std::vector<Eigen::Vector3d> points;
  if (!head) return points;
  const PortraitPlace place(*head, faces_backwards);
  for (const auto& own : kOutline) points.push_back(place.point(Eigen::Vector3d(own)).cast<double>());
  return points;
}

}  // namespace coif::render
