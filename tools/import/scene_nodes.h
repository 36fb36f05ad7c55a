#pragma once

#include "import/source_model.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

struct aiNode;
struct aiScene;

namespace coif {

/// The node tree as a list, parents first, in the order of the file.
struct SceneNodes {
  std::vector<SourceNode> nodes;
  std::vector<const aiNode*> origin;                           ///< Beside each node; owned by the scene.
  std::unordered_map<std::string, std::uint32_t> joint_named;  ///< By the importer's raw name.
};

/// `model_from_scene` is applied above the root. A node whose transform is not finite takes its parent's place, with a
/// warning. Where several nodes carry a bone's name (a mesh 'head' beside a joint 'head'), the one without meshes and
/// within a skeleton is the joint; a warning says so where that does not decide.
[[nodiscard]] SceneNodes flatten_nodes(const aiScene& scene, const Eigen::Affine3d& model_from_scene,
                                       std::vector<std::string>& warnings);

}  // namespace coif
