#pragma once

#include "cook/fit_head.h"
#include "cook/skeleton.h"

#include <coif/asset_records.h>

#include <string>
#include <vector>

namespace coif {

/// A body that moves with a rigid bone. Model space, metres; the meaning of each field is ColliderRecord's.
struct HeadCollider {
  ColliderShape shape = ColliderShape::kSphere;
  std::uint32_t bone = 0;
  bool keeps_inside = false;
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d radii = Eigen::Vector3d::Zero();
  Eigen::Vector3d axis = Eigen::Vector3d::Zero();
};

/// What hair collides with, and which bones can.
struct Colliders {
  std::vector<HeadCollider> shapes;    ///< At most kMaxColliders.
  std::vector<std::uint32_t> of_bone;  ///< Per bone of the skeleton, bit i: its particle may touch shape i.
  std::vector<double> hit_radius;      ///< Per bone, metres; empty: 0 for all.
  std::vector<std::string> notes;
  std::vector<std::string> warnings;
};

/// The head as a collider, unless the recipe wants none. A fitted head shrinks until no particle is inside it at rest,
/// since it would push the modelled pose about; a declared one is left alone and the depth reported.
[[nodiscard]] Colliders head_colliders(const FittedHead& head, const Skeleton& skeleton, const Recipe& recipe);

/// Takes out of each bone's set what it cannot touch: a particle is never farther from its chain's first joint than the
/// bones between are long, and stretch of kStretch on top of that.
void drop_colliders_out_of_reach(const Skeleton& skeleton, Colliders& colliders);

/// Says how many bones can collide at all, and warns of those that are inside a shape at rest with their hit radius, with
/// the greatest depth: they will be pushed out of the modelled pose.
void report_rest_penetration(const Skeleton& skeleton, Colliders& colliders);

}  // namespace coif
