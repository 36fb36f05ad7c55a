#pragma once

// A mesh as it is in a file, before it is placed in the model: every reader makes these, and one function places them.

#include "import/source_model.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif::importer {

struct RawBone {
  std::uint32_t node = 0;                                        ///< Into the model's nodes.
  Eigen::Affine3d bone_from_mesh = Eigen::Affine3d::Identity();  ///< The mesh's placement when it was bound.
};

struct RawWeight {
  std::uint32_t vertex = 0;
  std::uint32_t bone = 0;  ///< Into RawMesh::bones.
  float weight = 0;
};

/// A mesh in its own space. The other arrays are empty or have as many elements as `positions`. Numbers may have any
/// value, and indices may be out of range.
struct RawMesh {
  std::string name;
  std::uint32_t material = kNoIndex;
  /// For a mesh that no bone moves: an instance, a pivot.
  Eigen::Affine3d node_from_mesh = Eigen::Affine3d::Identity();
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;     ///< V grows downwards.
  std::vector<Eigen::Vector4f> colors;  ///< Linear.
  std::vector<std::uint32_t> triangles;
  std::size_t points_and_lines = 0;
  std::vector<RawBone> bones;  ///< None: rigid to its node.
  std::vector<RawWeight> weights;
};

/// The position of each vertex in the nodes' rest pose, and its skin weights.
class SkinBinding {
 public:
  /// Drops faulty data of the file, with counted warnings: weights of absent vertices or bones, weights that are not
  /// finite or not above zero. Weights are normalised; vertices of a skinned mesh without any weight follow
  /// `mesh_node`. `label` names the mesh in warnings.
  SkinBinding(const RawMesh& mesh, std::uint32_t mesh_node, std::span<const SourceNode> nodes, const std::string& label,
              Diagnostics& warnings);

  /// False when no vertex has a usable weight: the mesh is rigid to its node.
  [[nodiscard]] bool skinned() const { return !begin_.empty(); }
  /// Heaviest first. Empty when rigid.
  [[nodiscard]] std::span<const SourceInfluence> influences(std::size_t vertex) const;
  /// sum of weight * model_from_bone * bone_from_mesh.
  [[nodiscard]] Eigen::Affine3d model_from_mesh(std::size_t vertex) const;

 private:
  struct Weight {
    std::uint32_t vertex;
    SourceInfluence influence;
  };
  [[nodiscard]] std::vector<Weight> collect_weights(const RawMesh& mesh, const std::string& label,
                                                    Diagnostics& warnings);
  void build_table(std::vector<Weight>& weights, std::size_t vertex_count, std::uint32_t mesh_node,
                   const std::string& label, Diagnostics& warnings);
  void append_vertex(std::span<const Weight> weights);

  Eigen::Affine3d model_from_node_;
  std::vector<Eigen::Affine3d> palette_;  // per node of the model; identity where no bone of this mesh
  std::vector<bool> unweighted_;          // per vertex of a skinned mesh: follows the mesh's node
  std::vector<std::uint32_t> begin_;
  std::vector<SourceInfluence> influences_;
};

/// The mesh at rest in the model, carried by `node`. Triangles with absent or non-finite vertices and vertices without
/// a triangle are dropped, with warnings; unusable normals, UVs and colours are replaced. The result may have no
/// triangles.
[[nodiscard]] SourceMesh place_mesh(const RawMesh& mesh, std::uint32_t node, std::span<const SourceNode> nodes,
                                    Diagnostics& warnings);

/// Appends a placed mesh if it has triangles. Warns of what was left out: points and lines as source_code::kLoose, or
/// all of it.
void keep_mesh(const RawMesh& raw, SourceMesh placed, std::vector<SourceMesh>& meshes, Diagnostics& warnings);

/// Fills `posed_node` and `posed_degrees` of the placed mesh.
void measure_pose(const RawMesh& mesh, std::span<const SourceNode> nodes, SourceMesh& out);

}  // namespace coif::importer
