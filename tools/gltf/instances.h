#pragma once

// A mesh that a node shows many times. Source: Khronos, "EXT_mesh_gpu_instancing".

#include "base/json.h"
#include "gltf/buffers.h"

#include <Eigen/Geometry>
#include <tl/expected.hpp>

#include <string>
#include <vector>

namespace coif::gltf {

inline constexpr std::size_t kMostInstances = 65536;

/// Where each instance of the node's mesh stands in the node; one that does nothing where the node has no instances.
/// The error is a sentence.
[[nodiscard]] tl::expected<std::vector<Eigen::Affine3d>, std::string> read_gltf_instances(
    const nlohmann::json& document, GltfBuffers& buffers, const nlohmann::json& node);

}  // namespace coif::gltf
