#include "cook/rig/colliders.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif {
namespace {

using Eigen::Vector3d;

constexpr double kSmallestShare = 0.5;  ///< A head that has to shrink further was not the head.
constexpr double kTouching = 1.0e-5;    ///< Metres: a fitted head ends where the first particle is.
constexpr double kStretch = 0.02;       ///< The default solver's is none; this is for rounding and blended poses.

/// Smallest share of the head's size at which some particle would be on its surface; 1 or more: none is inside.
double share_at_first_particle(const FittedHead& head, const Skeleton& skeleton) {
  double share = 1;
  for (const SkeletonBone& bone : skeleton.bones) {
    if (bone.kind != BoneKind::kSimulated) continue;
    share = std::min(share, (bone.tail - head.center).cwiseQuotient(head.radii).norm());
  }
  return share;
}

/// The share of the head's size that the collider keeps.
double share_kept(const FittedHead& head, const Skeleton& skeleton, Colliders& colliders) {
  const double share = share_at_first_particle(head, skeleton);
  if (share >= 1) return 1;
  if (head.declared) {
    colliders.warnings.push_back(
        fmt::format("the declared head pushes the hair at rest: a bone ends {:.0f} % of the radius "
                    "inside it; make head.radii smaller",
                    100 * (1 - share)));
    return 1;
  }
  const double kept = std::max(share * 0.999, kSmallestShare);
  colliders.warnings.push_back(
      fmt::format("the fitted head was shrunk to {:.0f} % so that it does not push the hair at rest{}", 100 * kept,
                  share < kSmallestShare ? "; some bones still end inside it" : ""));
  return kept;
}

HeadCollider ellipsoid(const Vector3d& center, const Vector3d& radii) {
  HeadCollider shape;
  const bool sphere = radii.minCoeff() == radii.maxCoeff();
  shape.shape = sphere ? ColliderShape::kSphere : ColliderShape::kEllipsoid;
  shape.center = center;
  shape.radii = radii;
  return shape;
}

/// As high as the ellipsoid and inside of its width and depth; a sphere where it is no higher than that.
HeadCollider upright_capsule(const Vector3d& center, const Vector3d& radii) {
  const double radius = std::min({radii.x(), radii.y(), radii.z()});
  const double half = radii.y() - radius;
  if (!(half > 0)) return ellipsoid(center, Vector3d::Constant(radius));
  HeadCollider shape;
  shape.shape = ColliderShape::kCapsule;
  shape.center = center - half * Vector3d::UnitY();
  shape.axis = 2 * half * Vector3d::UnitY();
  shape.radii.setConstant(radius);
  return shape;
}

/// How deep a particle with this hit radius is in the shape, metres; negative or zero where it may be.
double depth_inside(const HeadCollider& shape, const Vector3d& particle, double radius) {
  if (shape.keeps_inside) return distance_at_least(shape, particle) + radius;
  return coif::depth_inside(static_cast<const ColliderSize&>(shape), particle, radius);
}

bool in_reach(const HeadCollider& shape, const Vector3d& root, double reach) {
  // Whoever is kept inside may touch the shell from anywhere.
  return shape.keeps_inside || distance_at_least(shape, root) <= reach;
}

}  // namespace

Colliders head_colliders(const FittedHead& head, const Skeleton& skeleton, const Recipe& recipe) {
  Colliders colliders;
  colliders.of_bone.assign(skeleton.bones.size(), 0);
  if (recipe.head_shape == "none") return colliders;
  const Vector3d radii = head.radii * share_kept(head, skeleton, colliders);
  colliders.shapes.push_back(recipe.head_shape == "capsule" ? upright_capsule(head.center, radii)
                                                            : ellipsoid(head.center, radii));
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    colliders.of_bone[b] = skeleton.bones[b].kind == BoneKind::kSimulated ? 1 : 0;
  }
  return colliders;
}

void drop_colliders_out_of_reach(const Skeleton& skeleton, Colliders& colliders) {
  struct Reach {
    Vector3d root;
    double length;
  };
  std::vector<Reach> reach(skeleton.bones.size());
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const SkeletonBone& bone = skeleton.bones[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    const bool first = skeleton.bones[bone.parent].kind != BoneKind::kSimulated;
    reach[b].root = first ? bone.start : reach[bone.parent].root;
    reach[b].length = bone.length() + (first ? 0 : reach[bone.parent].length);
    const double radius = colliders.hit_radius.empty() ? 0 : colliders.hit_radius[b];
    for (std::size_t c = 0; c < colliders.shapes.size(); ++c) {
      if (in_reach(colliders.shapes[c], reach[b].root, reach[b].length * (1 + kStretch) + radius)) continue;
      colliders.of_bone[b] &= ~(1u << c);
    }
  }
}

void report_rest_penetration(const Skeleton& skeleton, Colliders& colliders) {
  std::size_t colliding = 0, inside = 0;
  double deepest = 0;
  std::string where;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    colliding += colliders.of_bone[b] != 0 ? 1 : 0;
    const double radius = colliders.hit_radius.empty() ? 0 : colliders.hit_radius[b];
    double depth = 0;
    for (std::size_t c = 0; c < colliders.shapes.size(); ++c) {
      if (!(colliders.of_bone[b] >> c & 1)) continue;
      depth = std::max(depth, depth_inside(colliders.shapes[c], skeleton.bones[b].tail, radius));
    }
    if (depth <= kTouching) continue;
    ++inside;
    if (depth <= deepest) continue;
    deepest = depth;
    where = skeleton.bones[b].name;
  }
  if (skeleton.simulated_count() > 0) {
    colliders.notes.push_back(fmt::format("{} of {} simulated bones can reach a collider; {} inside one at rest",
                                          colliding, skeleton.simulated_count(), inside));
  }
  if (inside == 0 || !colliders.warnings.empty()) return;
  colliders.warnings.push_back(
      fmt::format("{} bones are inside a collider at rest, '{}' by {:.1f} mm; they will be pushed out of the modelled "
                  "pose: make the collider or the hit radius smaller, or set \"head.shape\" in the recipe",
                  inside, where, 1000 * deepest));
}

namespace {

constexpr double kShortestCapsule = 1.0e-6;  ///< Metres between its ends; shorter ones are spheres.

bool is_below(const SourceModel& source, std::uint32_t node, std::uint32_t ancestor) {
  while (node != kNoIndex && node != ancestor) node = source.nodes[node].parent;
  return node != kNoIndex;
}

HeadCollider convert(const SourceCollider& from, const Skeleton& skeleton) {
  HeadCollider to;
  to.keeps_inside = from.keeps_inside && from.shape != SourceCollider::Shape::kPlane;
  to.center = from.center;
  to.radii.setConstant(from.radius);
  to.bone = skeleton.bone_of_node[from.node];
  while (skeleton.bones[to.bone].kind == BoneKind::kSimulated) to.bone = skeleton.bones[to.bone].parent;
  if (from.shape == SourceCollider::Shape::kPlane) {
    to.shape = ColliderShape::kPlane;
    to.axis = from.normal;
    to.radii.setZero();
  }
  const bool is_capsule = from.shape == SourceCollider::Shape::kCapsule;
  if (is_capsule && (from.tail - from.center).norm() > kShortestCapsule) {
    to.shape = ColliderShape::kCapsule;
    to.axis = from.tail - from.center;
  }
  return to;
}

class ColliderPass {
 public:
  ColliderPass(const SourceModel& source, std::uint32_t head_node, const Skeleton& skeleton)
      : source_(source), head_node_(head_node), skeleton_(skeleton), shape_of_(source.colliders.size(), kUnseen) {}

  SpringColliders run() && {
    const std::vector<BoneJoint> joints = joints_of_bones(source_, skeleton_);
    out_.colliders.of_bone.assign(skeleton_.bones.size(), 0);
    out_.colliders.hit_radius.assign(skeleton_.bones.size(), 0);
    for (std::size_t b = 0; b < joints.size(); ++b) {
      if (!joints[b]) continue;
      out_.colliders.hit_radius[b] = joints[b].joint->hit_radius;
      for (const std::uint32_t c : joints[b].spring->colliders) {
        if (shape_of_[c] == kUnseen) shape_of_[c] = place(c);
        if (shape_of_[c] != kNone) out_.colliders.of_bone[b] |= 1u << shape_of_[c];
      }
    }
    return std::move(out_);
  }

 private:
  static constexpr std::uint32_t kUnseen = kNone - 1;

  /// The number of the new shape, or kNone.
  std::uint32_t place(std::uint32_t collider) {
    const SourceCollider& from = source_.colliders[collider];
    const auto leave_out = [&](const char* why) {
      out_.left_out.push_back(
          {fmt::format("the spring bones' collider {} on '{}'", collider, source_.nodes[from.node].name), why});
      return kNone;
    };
    if (head_node_ == kNoIndex || !is_below(source_, from.node, head_node_)) {
      return leave_out("not on the head or below it, and only those can follow it");
    }
    if (from.shape != SourceCollider::Shape::kPlane && !(from.radius > 0)) return leave_out("it has no size");
    if (out_.colliders.shapes.size() >= kMaxColliders) return leave_out("an asset has no room for it");
    out_.colliders.shapes.push_back(convert(from, skeleton_));
    return std::uint32_t(out_.colliders.shapes.size() - 1);
  }

  const SourceModel& source_;
  std::uint32_t head_node_;
  const Skeleton& skeleton_;
  std::vector<std::uint32_t> shape_of_;
  SpringColliders out_;
};

}  // namespace

SpringColliders spring_colliders(const SourceModel& source, std::uint32_t head_node, const Skeleton& skeleton) {
  return ColliderPass(source, head_node, skeleton).run();
}

}  // namespace coif
