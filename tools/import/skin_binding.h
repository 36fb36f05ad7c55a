#pragma once

#include "import/scene_nodes.h"
#include "import/source_model.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

struct aiMesh;

namespace coif {

/// Where each vertex of a mesh stands in the rest pose of the nodes, and what holds it there.
class SkinBinding {
 public:
  /// Drops, with counted warnings, what the file gets wrong: bones without a node, weights of absent vertices, weights
  /// that are not finite or not above zero. Weights are normalised; a skinned mesh's vertices without any weight
  /// follow `mesh_node`. `label` names the mesh in warnings.
  SkinBinding(const aiMesh& mesh, std::uint32_t mesh_node, const SceneNodes& nodes, const std::string& label,
              std::vector<std::string>& warnings);

  /// False when no vertex has a usable weight: the mesh is rigid to its node.
  [[nodiscard]] bool skinned() const { return !begin_.empty(); }
  /// Heaviest first. Empty when rigid.
  [[nodiscard]] std::span<const SourceInfluence> influences(std::size_t vertex) const;
  /// sum of weight * model_from_joint * joint_from_mesh.
  [[nodiscard]] Eigen::Affine3d model_from_mesh(std::size_t vertex) const;

 private:
  struct Weight {
    std::uint32_t vertex;
    SourceInfluence influence;
  };
  [[nodiscard]] std::vector<Weight> collect_weights(const aiMesh& mesh, const SceneNodes& nodes,
                                                    const std::string& label, std::vector<std::string>& warnings);
  void build_table(std::vector<Weight>& weights, std::size_t vertex_count, std::uint32_t mesh_node,
                   const std::string& label, std::vector<std::string>& warnings);
  void append_vertex(std::span<const Weight> weights);

  Eigen::Affine3d model_from_node_;
  std::vector<Eigen::Affine3d> palette_;  // per node of the scene; identity where no bone of this mesh
  std::vector<bool> unweighted_;          // per vertex of a skinned mesh: follows the mesh's node
  std::vector<std::uint32_t> begin_;
  std::vector<SourceInfluence> influences_;
};

}  // namespace coif
