#pragma once

// Ways to draw one asset that are compared, and the poses in which they are.

#include "base/tool_error.h"
#include "render/kept_order.h"
#include "render/order_pictures.h"
#include "report/order/order_report.h"
#include "write/asset_writer.h"

#include <coif/asset.h>
#include <coif/asset_records.h>
#include <coif/hair.h>
#include <coif/math.h>
#include <coif/transparency.h>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace coif::report {

struct DrawnWay {
  std::string name;
  std::size_t model = 0;  ///< Index of the model in OrderPictures.
  const TransparencyMode* transparency = &kBlendMode;
  const MaterialRecord* material = nullptr;  ///< Instead of the asset's, unless null.
  std::uint32_t samples = 1;
  /// The unit of each triangle, if units are sorted far to near for each picture, for which `model` is then made anew;
  /// empty: nothing is sorted.
  std::vector<std::uint32_t> sorted_units = {};
  std::shared_ptr<render::KeptBoneOrder> bones = {};  ///< The renderer sorts these for each picture, unless null.
  bool faces_together = false;
  std::uint64_t bytes = 0;  ///< Bytes of indices.
};

/// Hair at one moment, head space.
struct PosedHair {
  std::vector<Mat34> palette;
  std::vector<Eigen::Vector3f> positions;  ///< All vertices, metres.
};

/// A row's pose: views take turns between its moments.
struct OrderPose {
  std::string name;  ///< rest or a motion.
  std::vector<PosedHair> moments;
};

// An asset's finest level with its patches or triangles in other orders.

/// The whole asset without its coarser levels of detail.
[[nodiscard]] AssetContents finest_level(const Asset& asset);

/// Whether front and back faces share one order, or back faces come before front faces.
void set_faces(AssetContents& contents, bool together);

/// Its patches in the source file's order, back faces before front faces. Like the following, without further orders.
[[nodiscard]] AssetContents in_file_order(AssetContents finest);
/// The thesis's way: by distance from the head, back faces before front faces.
[[nodiscard]] AssetContents in_head_order(AssetContents finest);
/// In stored order: the best single order that the cook found.
[[nodiscard]] AssetContents in_stored_order(AssetContents finest);

/// Units that a game sorts in every frame, one per triangle: each triangle for itself.
[[nodiscard]] std::vector<std::uint32_t> each_triangle(const AssetContents& finest);
/// The drawing of a game that sorts units in every frame: the unit whose triangles' mean is furthest from `eye` (head
/// space, metres) comes first, each unit's triangles in stored order. `positions` of all vertices, in the pose.
[[nodiscard]] AssetContents sorted_by_unit(AssetContents finest, std::span<const std::uint32_t> unit_of_triangle,
                                           std::span<const Eigen::Vector3f> positions, const Eigen::Vector3f& eye);

/// The indices of triangles in that order, as such a game computes them in every frame.
[[nodiscard]] std::vector<std::uint32_t> far_to_near(std::span<const std::uint32_t> indices,
                                                     std::span<const std::uint32_t> unit_of_triangle,
                                                     std::span<const Eigen::Vector3f> positions,
                                                     const Eigen::Vector3f& eye);

/// "rest", the settled hair, and for hair that moves "turn", "charge" and "tumble", each at three moments: the head at
/// its fastest, the hair at its furthest, and on its way back. Cooked orders are made for moments of the first two, not
/// for the last. Moved by `solver`. Errors: those of simulate_pose().
tl::expected<std::vector<OrderPose>, ToolError> make_order_poses(const Asset& asset, const Solver& solver);

/// Directions to look from, each for the same share of the sphere, neighbours in the list far apart: a spherical
/// Fibonacci lattice (Gonzalez 2010, "Measurement of areas on a sphere using Fibonacci and latitude-longitude
/// lattices").
[[nodiscard]] std::vector<ViewAngle> spread_directions(std::uint32_t count);

/// The ways to draw one asset that are compared.
struct OrderWays {
  AssetContents finest;                                  ///< The asset without coarser levels.
  DrawnWay exact;                                        ///< The reference of all others, with `exact_material`.
  std::unique_ptr<const MaterialRecord> exact_material;  ///< The asset's, with every texel's own alpha.
  DrawnWay own;                                          ///< Blended, with all the asset's own orders.
  std::vector<DrawnWay> orders;                          ///< Blended.
  std::vector<DrawnWay> modes;                           ///< The asset's own orders.
  std::vector<OrderLeftOut> left_out;
};

/// The list memory of the renderer of exact pictures: four times its default, for pictures of a thousand pixels in each
/// direction.
inline constexpr std::uint32_t kListBytes = 256u << 20;

/// The reference's material: only texels of full alpha are solid, and only texels that no 8-bit picture shows are left
/// out. Hair with a mask keeps its material: its alpha only marks the edge.
[[nodiscard]] MaterialRecord with_true_alphas(MaterialRecord material);

/// Uploads the asset once per order. Errors: those of OrderPictures.
tl::expected<OrderWays, ToolError> make_order_ways(const Asset& asset, render::OrderPictures& pictures);

}  // namespace coif::report
