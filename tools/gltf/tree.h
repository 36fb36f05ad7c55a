#pragma once

// The nodes of a glTF document: their hierarchy and their local transforms.
// Source: Khronos, "glTF 2.0 Specification", chapter 3.5; "KHR_node_visibility".

#include "base/json.h"
#include "gltf/buffers.h"

#include <Eigen/Geometry>
#include <tl/expected.hpp>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coif::gltf {

/// A node's place in its parent, as its translation, rotation and scale or as a matrix.
struct GltfPlace {
  bool is_matrix = false;  ///< Then the other three have their defaults.
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();
  Eigen::Quaterniond rotation = Eigen::Quaterniond::Identity();  ///< Unit.
  Eigen::Vector3d scale = Eigen::Vector3d::Ones();
  Eigen::Affine3d parent_from_node = Eigen::Affine3d::Identity();
};

[[nodiscard]] Eigen::Affine3d gltf_placed(const Eigen::Vector3d& translation, const Eigen::Quaterniond& rotation,
                                          const Eigen::Vector3d& scale);

/// Null unless the node's numbers are finite and its rotation has a length.
[[nodiscard]] std::optional<GltfPlace> gltf_place(const nlohmann::json& node);

/// The parents of a glTF document's nodes. `document` needs the member `nodes` and must outlive the object.
class GltfTree {
 public:
  explicit GltfTree(const nlohmann::json& document);

  [[nodiscard]] std::size_t size() const { return parents_.size(); }
  [[nodiscard]] const nlohmann::json& node(std::uint32_t index) const;
  /// Printable, for messages; "node 3" for one without a name.
  [[nodiscard]] std::string label(std::uint32_t index) const;
  /// All nodes with that name, in the file's spelling.
  [[nodiscard]] std::vector<std::uint32_t> named(std::string_view name) const;
  /// The node and all that it hangs on, the root last. The error is a sentence: too many levels, or a loop.
  [[nodiscard]] tl::expected<std::vector<std::uint32_t>, std::string> with_parents(std::uint32_t index) const;

 private:
  const nlohmann::json& nodes_;
  std::vector<std::optional<std::uint32_t>> parents_;
};

/// A node that a scene shows.
struct GltfSceneNode {
  std::uint32_t in_file = 0;
  std::optional<std::uint32_t> parent;  ///< Place of an earlier one in the list.
  bool is_hidden = false;               ///< By KHR_node_visibility of the node or of one above it.
  bool is_placed = true;  ///< False where its numbers are no valid transform: it stands where its parent does.
  Eigen::Affine3d model_from_node = Eigen::Affine3d::Identity();
};

/// The nodes of the document's scene (`scene`, else the first; all roots where there is no scene), depth first,
/// children in their order, each once however often a damaged file names it. `model_from_file` is applied above the
/// roots.
[[nodiscard]] std::vector<GltfSceneNode> gltf_scene_nodes(
    const nlohmann::json& document, const Eigen::Affine3d& model_from_file = Eigen::Affine3d::Identity());

// A mesh that a node shows many times. Source: Khronos, "EXT_mesh_gpu_instancing".

inline constexpr std::size_t kMostInstances = 65536;

/// The transform of each instance of the node's mesh in the node; a single identity where the node has no instances.
/// The error is a sentence.
[[nodiscard]] tl::expected<std::vector<Eigen::Affine3d>, std::string> read_gltf_instances(
    const nlohmann::json& document, GltfBuffers& buffers, const nlohmann::json& node);

}  // namespace coif::gltf
