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

/// Whether front and back faces share one order, or back faces come before front faces.
void set_faces(AssetContents& contents, bool together);

/// Its patches as the source file has them, back faces before front faces. Without further orders, as the following.
[[nodiscard]] AssetContents in_file_order(AssetContents finest);
/// The thesis's way: by distance from the head, back faces before front faces.
[[nodiscard]] AssetContents in_head_order(AssetContents finest);
/// As stored: the best single order that the cooker found.
[[nodiscard]] AssetContents in_stored_order(AssetContents finest);

/// Units that a game sorts in every frame, one per triangle: each triangle for itself.
[[nodiscard]] std::vector<std::uint32_t> each_triangle(const AssetContents& finest);
/// All that hangs mostly on one bone (thesis, chapter 8, as future work: bones sorted, within a bone a fixed order). Needs
/// skinned hair.
[[nodiscard]] std::vector<std::uint32_t> leading_bones(const AssetContents& finest);

/// What a game draws that sorts units in every frame: the unit whose triangles' mean is furthest from `eye` (head space,
/// metres) first, each unit's triangles in stored order. `positions` of all vertices, in the pose.
[[nodiscard]] AssetContents sorted_by_unit(AssetContents finest, std::span<const std::uint32_t> unit_of_triangle,
                                           std::span<const Eigen::Vector3f> positions, const Eigen::Vector3f& eye);

/// The indices of triangles in that order: what such a game computes per frame.
[[nodiscard]] std::vector<std::uint32_t> far_to_near(std::span<const std::uint32_t> indices,
                                                     std::span<const std::uint32_t> unit_of_triangle,
                                                     std::span<const Eigen::Vector3f> positions,
                                                     const Eigen::Vector3f& eye);

}  // namespace coif
