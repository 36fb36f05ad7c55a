#pragma once

#include "cook/find_head_bone.h"
#include "cook/hair_mesh.h"
#include "cook/recipe.h"

#include <Eigen/Core>

#include <span>
#include <string>

namespace coif {

/// The head as the cooker sees it: an ellipsoid. Roots are near it, patches are sorted by the distance from its centre,
/// and unless there are better colliders hair stays out of it.
struct FittedHead {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< Model space, metres.
  Eigen::Vector3d radii = Eigen::Vector3d::Zero();   ///< Semi-axes along the model's axes, > 0.
  std::string origin;                                ///< Where it comes from, for the report.
  bool declared = false;                             ///< By the recipe: not to be shrunk.

  /// Distance of a point from the surface, metres, negative inside; exact on spheres, else along the ray to the centre.
  [[nodiscard]] double distance(const Eigen::Vector3d& point) const {
    const Eigen::Vector3d from = point - center;
    const double scaled = from.cwiseQuotient(radii).norm();
    return scaled > 0 ? from.norm() * (1 - 1 / scaled) : -radii.minCoeff();
  }
};

/// As the recipe declares it, else the box of the vertices outside `hair_meshes` that follow the head bone, else the
/// inside of the hair.
[[nodiscard]] FittedHead fit_head(const SourceModel& source, const HairMesh& hair,
                                  std::span<const std::uint32_t> hair_meshes, const HeadBone& head_bone,
                                  const Recipe& recipe);

}  // namespace coif
