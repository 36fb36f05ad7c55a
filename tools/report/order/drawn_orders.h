#pragma once
// An asset's finest level with its patches or triangles in other orders.

#include "write/asset_writer.h"

#include <coif/asset.h>
#include <coif/math.h>

#include <Eigen/Core>

#include <span>
#include <vector>

namespace coif {

/// All of an asset but its coarser levels of detail.
[[nodiscard]] AssetContents finest_level(const Asset& asset);

/// Its patches as the source file has them, back faces before front faces. Without further orders, as the following.
[[nodiscard]] AssetContents in_file_order(AssetContents finest);
/// The thesis's way: by distance from the head, back faces before front faces.
[[nodiscard]] AssetContents in_head_order(AssetContents finest);
/// As stored: the best single order that the cooker found.
[[nodiscard]] AssetContents in_stored_order(AssetContents finest);

/// Every triangle for itself, far to near by its middle as seen from `eye` (head space, metres), both faces together: what a
/// game that sorts triangles in every frame draws. `positions` of all vertices, in the pose.
[[nodiscard]] AssetContents sorted_by_triangle(AssetContents finest, std::span<const Eigen::Vector3f> positions,
                                               const Eigen::Vector3f& eye);

/// The indices of triangles, far to near: what such a game computes per frame.
[[nodiscard]] std::vector<std::uint32_t> far_to_near(std::span<const std::uint32_t> indices,
                                                     std::span<const Eigen::Vector3f> positions,
                                                     const Eigen::Vector3f& eye);

}  // namespace coif
