#pragma once

#include "import/source_model.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <vector>

namespace coif {

/// Which of `nodes` each node of the glTF document became; kNoIndex for those outside the scene and those that cannot
/// be told. assimp 5.2 builds its tree by walking the document's from the scene's roots, children in their order, under
/// a root of its own unless the scene has exactly one; it keeps names and makes up missing ones. So nodes are told by
/// their place in the tree, and their names, where they have any, must agree. Below a disagreement a node is found by
/// its name where that is the only one of its kind on both sides.
[[nodiscard]] std::vector<std::uint32_t> match_gltf_nodes(const nlohmann::json& document,
                                                          const std::vector<SourceNode>& nodes);

}  // namespace coif
