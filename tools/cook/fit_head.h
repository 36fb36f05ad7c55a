#pragma once

#include "cook/hair_mesh.h"
#include "cook/recipe.h"
#include "cook/skeleton.h"

#include <optional>

namespace coif {

struct FittedHead {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();  ///< Model space, metres.
  Eigen::Vector3d radii = Eigen::Vector3d::Zero();   ///< Semi-axes along the model's axes; zero: no collider.
  std::string origin;                                ///< Where it comes from, for the report.
  std::vector<std::string> warnings;

  [[nodiscard]] bool collides() const { return radii.minCoeff() > 0; }
};

/// The head that hair stays out of: as the recipe declares it, else the box of the vertices outside `hair_meshes` that
/// follow the head bone, else the inside of the hair. A fitted head shrinks until no particle is inside it at rest, since
/// it would push the modelled pose about; a declared one is left alone and the depth reported. Patches are sorted by the
/// distance from its centre even where it does not collide.
[[nodiscard]] FittedHead fit_head(const SourceModel& source, const HairMesh& hair,
                                  std::span<const std::uint32_t> hair_meshes, const Skeleton& skeleton,
                                  const Recipe& recipe);

}  // namespace coif
