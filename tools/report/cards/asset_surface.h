#pragma once

#include "base/tool_error.h"
#include "cards/card_surface.h"
#include "groom/groom.h"

#include <coif/asset.h>

#include <Eigen/Core>
#include <tl/expected.hpp>

#include <cstdint>

namespace coif::report {

/// How strands became the places of an asset: as the cook found their unit and what is up, and about the head's joint,
/// which the asset knows.
struct CookedPlace {
  double factor = 1;  ///< For lengths.
  Eigen::Matrix3f turn = Eigen::Matrix3f::Identity();
  Eigen::Vector3f head_joint = Eigen::Vector3f::Zero();  ///< Metres, after both.

  [[nodiscard]] Eigen::Vector3f of_strand(const Eigen::Vector3f& point) const {
    return float(factor) * (turn * point) - head_joint;
  }
  [[nodiscard]] Eigen::Vector3f in_groom(const Eigen::Vector3f& head_space) const {
    return turn.transpose() * (head_space + head_joint) / float(factor);
  }
};

/// Finds among the units and up directions that a cook may choose those with which the box around the strands is most
/// nearly the one around the asset's finest level. kBadInput where no box is near it: the asset was cooked from other
/// strands, or by a recipe with another unit.
[[nodiscard]] tl::expected<CookedPlace, ToolError> find_cooked_place(const Asset& asset, const groom::Groom& groom);

/// What one level of detail draws, at rest, in the groom's space: its own triangles, tangents, and the alpha of its
/// largest mip.
[[nodiscard]] cards::CardSurface surface_of_asset(const Asset& asset, std::uint32_t lod, const CookedPlace& place);

}  // namespace coif::report
