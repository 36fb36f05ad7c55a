#pragma once

#include "import/scene_nodes.h"
#include "import/source_model.h"

#include <string>
#include <vector>

struct aiScene;

namespace coif {

/// One SourceMesh per mesh and node that shows it, in the order of nodes: instances are copied, since each stands
/// elsewhere. Points and lines, triangles with absent or non-finite vertices and vertices without a triangle are
/// dropped; meshes with no triangle left are too. Mesh names fall back to the node's.
[[nodiscard]] std::vector<SourceMesh> convert_meshes(const aiScene& scene, const SceneNodes& nodes,
                                                     std::vector<std::string>& warnings);

}  // namespace coif
