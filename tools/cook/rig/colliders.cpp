#include "cook/rig/colliders.h"

#include "cook/recipe/hair_recipe.h"
#include "cook/recipe/rig_recipe.h"

#include <fmt/format.h>

#include <algorithm>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr double kSmallestShare = 0.5;  ///< A head that has to shrink further was not the head.
constexpr double kTouching = 1.0e-5;    ///< Metres: a fitted head ends where the first particle is.
constexpr double kStretch = 0.02;  ///< The default solver does not stretch; this is for rounding and blended poses.

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
double share_kept(const FittedHead& head, const Skeleton& skeleton, Findings& findings) {
  const double share = share_at_first_particle(head, skeleton);
  if (share >= 1) return 1;
  if (head.declared) {
    findings.warn("C123", fmt::format("the declared head pushes the hair at rest: a bone ends {:.0f} % of the radius "
                                      "inside it; make head.radii smaller",
                                      100 * (1 - share)));
    return 1;
  }
  const double kept = std::max(share * 0.999, kSmallestShare);
  findings.warn("C123",
                fmt::format("the fitted head was shrunk to {:.0f} % so that it does not push the hair at rest{}",
                            100 * kept, share < kSmallestShare ? "; some bones still end inside it" : ""));
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

/// As high as the ellipsoid and inside its width and depth; a sphere where it is not higher than that.
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

bool in_reach(const HeadCollider& shape, const Vector3d& root, double reach) {
  // Hair that is kept inside may touch the shell from anywhere.
  return shape.keeps_inside || distance_at_least(shape, root) <= reach;
}

}  // namespace

double depth_of(const HeadCollider& shape, const Vector3d& particle, double radius) {
  if (shape.keeps_inside) return distance_at_least(shape, particle) + radius;
  return depth_inside(shape, particle, radius);
}

std::vector<BoneReach> reach_of_bones(const Skeleton& skeleton) {
  std::vector<BoneReach> reach(skeleton.bones.size());
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    const SkeletonBone& bone = skeleton.bones[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    const bool first = skeleton.bones[bone.parent].kind != BoneKind::kSimulated;
    reach[b].root = first ? bone.start : reach[bone.parent].root;
    reach[b].length = bone.length() + (first ? 0 : reach[bone.parent].length);
  }
  return reach;
}

Colliders head_colliders(const FittedHead& head, const Skeleton& skeleton, Findings& findings) {
  Colliders colliders;
  colliders.of_bone.assign(skeleton.bones.size(), 0);
  if (head.shape == HeadShape::kNothing) return colliders;
  const Vector3d radii = head.radii * share_kept(head, skeleton, findings);
  colliders.shapes.push_back(head.shape == HeadShape::kCapsule ? upright_capsule(head.center, radii)
                                                               : ellipsoid(head.center, radii));
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    colliders.of_bone[b] = skeleton.bones[b].kind == BoneKind::kSimulated ? 1 : 0;
  }
  return colliders;
}

void drop_colliders_out_of_reach(const Skeleton& skeleton, Colliders& colliders) {
  const std::vector<BoneReach> reach = reach_of_bones(skeleton);
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    if (skeleton.bones[b].kind != BoneKind::kSimulated) continue;
    const double radius = colliders.hit_radius.empty() ? 0 : colliders.hit_radius[b];
    for (std::size_t c = 0; c < colliders.shapes.size(); ++c) {
      if (in_reach(colliders.shapes[c], reach[b].root, reach[b].length * (1 + kStretch) + radius)) continue;
      colliders.of_bone[b] &= ~(1u << c);
    }
  }
}

void report_rest_penetration(const Skeleton& skeleton, const Colliders& colliders, const char* what, const char* cure,
                             Findings& findings) {
  std::size_t colliding = 0, inside = 0;
  double deepest = 0;
  std::string where;
  for (std::size_t b = 0; b < skeleton.bones.size(); ++b) {
    colliding += colliders.of_bone[b] != 0 ? 1 : 0;
    const double radius = colliders.hit_radius.empty() ? 0 : colliders.hit_radius[b];
    double depth = 0;
    for (std::size_t c = 0; c < colliders.shapes.size(); ++c) {
      if (!(colliders.of_bone[b] >> c & 1)) continue;
      depth = std::max(depth, depth_of(colliders.shapes[c], skeleton.bones[b].tail, radius));
    }
    if (depth <= kTouching) continue;
    ++inside;
    if (depth <= deepest) continue;
    deepest = depth;
    where = skeleton.bones[b].name;
  }
  if (skeleton.simulated_count() > 0) {
    findings.note(fmt::format("{} of {} simulated bones can reach a {}; {} inside one at rest", colliding,
                              skeleton.simulated_count(), what, inside));
  }
  if (inside == 0) return;
  findings.warn(
      "C124",
      fmt::format("{} bones are inside a {} at rest, '{}' by {:.1f} mm; they will be pushed out of the modelled "
                  "pose: make the collider or the hit radius smaller, or {}",
                  inside, what, where, 1000 * deepest, cure));
}

void leave_out_colliders(Colliders& colliders, Findings& findings) {
  std::uint32_t used = 0;
  for (const std::uint32_t set : colliders.of_bone) used |= set;
  std::vector<HeadCollider> shapes;
  std::vector<std::uint32_t> sets(colliders.of_bone.size(), 0);
  for (std::size_t c = 0; c < colliders.shapes.size(); ++c) {
    if ((used >> c & 1) == 0) {
      findings.leave_out({fmt::format("collider {}", c), "no bone can reach it", sizeof(ColliderRecord), 0});
      continue;
    }
    for (std::size_t b = 0; b < sets.size(); ++b) sets[b] |= (colliders.of_bone[b] >> c & 1) << shapes.size();
    shapes.push_back(colliders.shapes[c]);
  }
  colliders.shapes = std::move(shapes);
  colliders.of_bone = std::move(sets);
}

Colliders find_colliders(const importer::SourceModel& source, const HeadBone& head_bone, const FittedHead& head,
                         const Skeleton& skeleton, const RigRecipe& recipe, Findings& findings) {
  Findings told;
  Colliders colliders;
  if (recipe.dynamics_source != DynamicsSource::kCurves && head.shape == HeadShape::kAuto && !head.declared) {
    colliders = spring_colliders(source, head_bone.node, skeleton, findings);
  }
  if (colliders.shapes.empty()) {
    colliders = head_colliders(head, skeleton, told);
  } else {
    told.note(fmt::format("colliders: {} of the file's spring bones on the head", colliders.shapes.size()));
  }
  drop_colliders_out_of_reach(skeleton, colliders);
  const std::size_t known = told.warnings.size();
  report_rest_penetration(skeleton, colliders, "collider", "set \"head.shape\" in the recipe", told);
  if (known > 0) told.warnings.resize(known);  // The warning about the head's collider has been given already.
  findings.append(told);
  // Hair that nothing moves keeps its head: pictures show it.
  if (skeleton.simulated_count() > 0) leave_out_colliders(colliders, findings);
  return colliders;
}

}  // namespace coif::cook
