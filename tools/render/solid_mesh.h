#pragma once

#include "import/source_model.h"

#include <coif/asset_records.h>

#include <Eigen/Core>

#include <cstdint>
#include <span>
#include <vector>

namespace coif {

struct SolidVertex {
  Eigen::Vector3f position;
  Eigen::Vector3f normal;  ///< Unit.
};

/// What is drawn opaque beneath the hair. Head space, metres.
struct SolidMesh {
  std::vector<SolidVertex> vertices;
  std::vector<std::uint32_t> triangles;
  Eigen::Vector3f color{0.42f, 0.33f, 0.28f};  ///< Linear; the default is a mannequin's clay.
};

/// Colliders as smooth bodies, a little smaller than they collide. Left out: planes, and shapes that keep hair inside,
/// which would hide it.
[[nodiscard]] std::vector<SolidMesh> mannequin_meshes(std::span<const ColliderRecord> colliders);

/// A mesh of the source model; `head_joint` as in the asset's skeleton. A mesh without normals gets smooth ones.
[[nodiscard]] SolidMesh body_mesh(const SourceModel& model, const SourceMesh& mesh, const Eigen::Vector3f& head_joint);

}  // namespace coif
