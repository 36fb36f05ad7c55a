#pragma once
// Source models that tests make themselves, small enough to know every number of.

#include "cook/hair_mesh.h"

namespace coif {

struct StripDesc {
  Eigen::Vector3f root{0, 1.6f, -0.1f};  ///< Middle of the upper edge, metres.
  Eigen::Vector3f along{0, -0.3f, 0};    ///< Root to tip.
  Eigen::Vector3f across{0.05f, 0, 0};   ///< Width.
  float tip_width = 1;                   ///< Of `across`; the strip narrows evenly.
  std::uint32_t rows = 4;
  bool v_upwards = false;    ///< V is 0 at the tip instead of the root.
  bool uv_sideways = false;  ///< U runs along the strip.
};

/// A strip of 2 * rows triangles with smooth indices and texture coordinates, without normals.
[[nodiscard]] SourceMesh make_strip(const StripDesc& desc);

/// The mesh as the cooker sees it, every vertex on node 0.
[[nodiscard]] HairMesh hair_from(const SourceMesh& source);

/// A sheet of `columns` by `rows` quads over `turn` radians: its upper half on a ball of `radius` metres around (0, 1.6, 0),
/// from the crown down to the widest, its lower half hanging straight down from there. V is 0 at the crown, 1 at the edge.
[[nodiscard]] SourceMesh make_cap(std::uint32_t columns, std::uint32_t rows, float turn, float radius = 0.1f);

/// Appends `part` to `mesh`, not connected, moved by `node` alone where `mesh` has influences.
void append_piece(SourceMesh& mesh, const SourceMesh& part, std::uint32_t node);

/// One vertex per corner: what exporters make of flat shading.
void split_vertices(SourceMesh& mesh);

/// root > Head (at y = 1.6) > scalp > hair_1 > hair_2 > hair_2_end straight down in steps of 0.1 m, and one strip,
/// narrowing towards its tip, that follows scalp, hair_1 and hair_2 by height.
[[nodiscard]] SourceModel make_wig();

/// Adds a node; returns its index.
std::uint32_t add_node(SourceModel& model, const std::string& name, std::uint32_t parent, const Eigen::Vector3d& at);

}  // namespace coif
