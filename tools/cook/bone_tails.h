#pragma once

#include "cook/hair_mesh.h"
#include "cook/skeleton.h"

namespace coif {

/// Where the bone of `node` ends, model space: at its heaviest hair child; without one at the last joint below it; without
/// that where the vertices end that it carries; without those as far again as its parent. At least 1 mm from `start`.
[[nodiscard]] Eigen::Vector3d find_bone_tail(const SourceModel& source, const HairMesh& hair, std::uint32_t node,
                                             std::span<const std::uint32_t> hair_children, const Eigen::Vector3d& start,
                                             const SkeletonBone& parent);

}  // namespace coif
