#pragma once

#include "cook/skin_weights.h"

namespace coif {

/// Positions of one pose, one per vertex, model space, metres.
using Pose = std::vector<Eigen::Vector3f>;

/// The rest pose, and where bones move, two poses in which every simulated bone is turned against its parent: about X in
/// one, about Z in the other, so that hair of any direction bends in at least one. What looks alike in all of them
/// looks alike in motion; at rest alone, a straight tail is as good as two triangles. A bone turns by 20 degrees, or less
/// where the longest chain would turn by more than 120 in all.
[[nodiscard]] std::vector<Pose> bent_poses(const HairMesh& mesh, const Skeleton& skeleton, const SkinWeights& weights);

}  // namespace coif
