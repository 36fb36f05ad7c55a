#include "lab/placed_solid.h"

#include "lab/hair_segment.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace coif::lab {
namespace {

using Eigen::Vector3d;

void find_head(const Rig& rig, HairPlace& place) {
  std::size_t roots = 0;
  for (const RigBone& bone : rig.bones) {
    if (bone.parent >= 0) continue;
    place.head += bone.joint;
    ++roots;
  }
  place.head /= double(std::max<std::size_t>(roots, 1));
  double largest = 0;
  for (const SolidShape& solid : solid_shapes(rig.colliders)) {
    if (solid.keeps_inside || !(solid.size > largest)) continue;
    largest = place.head_radius = solid.size;
    place.head = solid.center;
  }
}

/// From the tip upwards, along half of the chain.
Vector3d middle_of(const Rig& rig, std::size_t tip, const std::vector<Vector3d>& ends) {
  double left = 0.5 * rig.tip_length[tip];
  for (int i = int(rig.tips[tip]); i >= 0; i = rig.bones[std::size_t(i)].parent) {
    const RigBone& bone = rig.bones[std::size_t(i)];
    if (left <= bone.length) return ends[std::size_t(i)] - bone.rest_direction * left;
    left -= bone.length;
  }
  return ends[rig.tips[tip]];
}

}  // namespace

HairPlace place_of(const Rig& rig) {
  HairPlace place;
  find_head(rig, place);
  const std::vector<Vector3d> ends = resting_ends(rig);
  const auto longest = std::size_t(std::ranges::max_element(rig.tip_length) - rig.tip_length.begin());
  if (longest >= rig.tips.size()) return place;
  place.length = rig.tip_length[longest];
  place.middle = middle_of(rig, longest, ends);
  Vector3d outward = place.middle - place.head;
  outward.y() = 0;
  place.outward = outward.norm() > 1.0e-6 ? Vector3d(outward.normalized()) : Vector3d(-Vector3d::UnitZ());
  return place;
}

}  // namespace coif::lab
