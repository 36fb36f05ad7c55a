#pragma once
// Strips with textures, for what is measured over texture coordinates.

#include "cook/hair_mesh.h"

#include <string>

namespace coif {

/// A strip whose texture coordinates fill the rectangle from `low` to `high`.
[[nodiscard]] SourceMesh strip_over(const Eigen::Vector2f& low, const Eigen::Vector2f& high);

/// Adds a strip with a material of its own, beside those that are there.
SourceMaterial& add_surface(SourceModel& model, const std::string& material,
                            const Eigen::Vector2f& low = Eigen::Vector2f::Zero(),
                            const Eigen::Vector2f& high = Eigen::Vector2f::Ones());

/// All meshes of the model as the cooker joins them.
[[nodiscard]] HairMesh whole_hair(const SourceModel& model);

}  // namespace coif
