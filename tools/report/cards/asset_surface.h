#pragma once

#include "base/tool_error.h"
#include "cards/card_surface.h"
#include "groom/groom.h"

#include <coif/asset.h>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstdint>

namespace coif::report {

/// The transform from strands to an asset: the unit and up axis that the cook found, and the head's joint, which the
/// asset has.
struct CookedPlace {
  double factor = 1;  ///< Applied to lengths.
  Eigen::Matrix3f turn = Eigen::Matrix3f::Identity();
  Eigen::Vector3f head_joint = Eigen::Vector3f::Zero();  ///< Metres, after both.

  [[nodiscard]] Eigen::Vector3f of_strand(const Eigen::Vector3f& point) const {
    return float(factor) * (turn * point) - head_joint;
  }
  [[nodiscard]] Eigen::Vector3f in_groom(const Eigen::Vector3f& head_space) const {
    return turn.transpose() * (head_space + head_joint) / float(factor);
  }
};

/// Among the units and up directions that a cook may choose, finds those whose box around the strands fits best to that
/// around the asset's finest level. kBadInput where none fits: the asset was cooked from other strands, or by a recipe
/// with another unit.
[[nodiscard]] tl::expected<CookedPlace, ToolError> find_cooked_place(const Asset& asset, const groom::Groom& groom);

/// The surface of one level of detail at rest, in the groom's space: its triangles, tangents, and the alpha of all mips
/// with the material's thresholds, as it is drawn.
[[nodiscard]] cards::CardSurface surface_of_asset(const Asset& asset, std::uint32_t lod, const CookedPlace& place);

}  // namespace coif::report
