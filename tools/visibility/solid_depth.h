#pragma once

#include <coif/asset_records.h>

#include <Eigen/Core>

#include <span>

namespace coif {

/// Where a line first meets one of the solids: the smallest distance along the unit vector `along` from `origin`, which may be
/// negative; infinity where it misses all. Head space, metres. Capsules are taken as a row of balls, within a
/// hundredth of their size.
[[nodiscard]] float solid_depth(std::span<const ColliderRecord> solids, const Eigen::Vector3f& origin,
                                const Eigen::Vector3f& along);

}  // namespace coif
