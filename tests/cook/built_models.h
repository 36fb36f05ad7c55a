#pragma once
// Source models that tests make themselves, small enough to know every number of.

#include "cook/hair_mesh.h"

namespace coif {

struct StripDesc {
  Eigen::Vector3f root{0, 1.6f, -0.1f};  ///< Middle of the upper edge, metres.
  Eigen::Vector3f along{0, -0.3f, 0};    ///< Root to tip.
  Eigen::Vector3f across{0.05f, 0, 0};   ///< Width.
  std::uint32_t rows = 4;
  bool v_upwards = false;    ///< V is 0 at the tip instead of the root.
  bool uv_sideways = false;  ///< U runs along the strip.
};

/// A strip of 2 * rows triangles with smooth indices and texture coordinates, without normals.
[[nodiscard]] SourceMesh make_strip(const StripDesc& desc);

/// The mesh as the cooker sees it, every vertex on node 0.
[[nodiscard]] HairMesh hair_from(const SourceMesh& source);

/// One vertex per corner: what exporters make of flat shading.
void split_vertices(SourceMesh& mesh);

/// root > Head (at y = 1.6) > scalp > hair_1 > hair_2 > hair_2_end straight down in steps of 0.1 m, and one strip that
/// follows scalp, hair_1 and hair_2 by height.
[[nodiscard]] SourceModel make_wig();

/// Adds a node; returns its index.
std::uint32_t add_node(SourceModel& model, const std::string& name, std::uint32_t parent, const Eigen::Vector3d& at);

}  // namespace coif
