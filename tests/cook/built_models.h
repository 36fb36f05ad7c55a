#pragma once

// Source models that tests make themselves, small enough to know every number of.

#include "cook/lods/make_lods.h"
#include "cook/select/hair_mesh.h"
#include "cook/select/mesh_topology.h"
#include "cook/told.h"

#include <string>

namespace coif::cook {

struct StripDesc {
  Eigen::Vector3f root{0, 1.6f, -0.1f};  ///< Middle of the upper edge, metres.
  Eigen::Vector3f along{0, -0.3f, 0};    ///< Root to tip.
  Eigen::Vector3f across{0.05f, 0, 0};   ///< Width.
  float tip_width = 1;                   ///< Share of `across`; the strip narrows evenly.
  std::uint32_t rows = 4;
  bool v_upwards = false;    ///< V is 0 at the tip instead of the root.
  bool uv_sideways = false;  ///< U runs along the strip.
};

/// A strip of 2 * rows triangles with smooth indices and texture coordinates, without normals.
[[nodiscard]] importer::SourceMesh make_strip(const StripDesc& desc);

/// The mesh as the cooker sees it, every vertex on node 0.
[[nodiscard]] HairMesh hair_from(const importer::SourceMesh& source);

/// Vertices at one place are welded; no strands yet. Without `patches` all of it is one.
[[nodiscard]] HairStrips strips_from(HairMesh mesh, PatchSet patches = {});

/// A sheet of `columns` by `rows` quads over `turn` radians: its upper half on a ball of `radius` metres around
/// (0, 1.6, 0), from the crown down to the widest, its lower half hanging straight down from there. V is 0 at the
/// crown, 1 at the edge.
[[nodiscard]] importer::SourceMesh make_cap(std::uint32_t columns, std::uint32_t rows, float turn, float radius = 0.1f);

/// Appends `part` to `mesh`, not connected, moved by `node` alone where `mesh` has influences.
void append_piece(importer::SourceMesh& mesh, const importer::SourceMesh& part, std::uint32_t node);

/// One vertex per corner: what exporters make of flat shading.
void split_vertices(importer::SourceMesh& mesh);

/// root > Head (at y = 1.6) > scalp > hair_1 > hair_2 > hair_2_end straight down in steps of 0.1 m, and one strip,
/// narrowing towards its tip, that follows scalp, hair_1 and hair_2 by height.
[[nodiscard]] importer::SourceModel make_wig();

/// Adds a node; returns its index.
std::uint32_t add_node(importer::SourceModel& model, const std::string& name, std::uint32_t parent,
                       const Eigen::Vector3d& at);

/// Nodes alone: Hips, Neck and Head, and below that, number 3, one for a mesh; the head's middle is about (0, 1.65, 0).
[[nodiscard]] importer::SourceModel make_spine();

/// Part of a ball of `radius` metres around (0, 1.65, 0), from height `low` to `high`, each -1..1 of it; `open`: the
/// share of the circle that it leaves free at the front.
[[nodiscard]] importer::SourceMesh make_shell(double radius, double low, double high, double open = 0);

// Strips with textures, for what is measured over texture coordinates.

/// A strip whose texture coordinates fill the rectangle from `low` to `high`.
[[nodiscard]] importer::SourceMesh strip_over(const Eigen::Vector2f& low, const Eigen::Vector2f& high);

/// Adds a strip with a material of its own, beside those that are there.
importer::SourceMaterial& add_surface(importer::SourceModel& model, const std::string& material,
                                      const Eigen::Vector2f& low = Eigen::Vector2f::Zero(),
                                      const Eigen::Vector2f& high = Eigen::Vector2f::Ones());

/// All meshes of the model as the cooker joins them.
[[nodiscard]] HairMesh whole_hair(const importer::SourceModel& model);

// Surfaces and levels of detail of them for tests, small enough to know every number of.

struct CardDesc {
  std::uint32_t columns = 4, rows = 12;
  float width = 0.06f, length = 0.3f;
  float bend_radius = 0;  ///< Radius of the cylinder along its length that the card is part of; 0: flat.
  Eigen::Vector3f root{0, 1.6f, -0.1f};
};

/// A grid that hangs down from its root, U across, V 0 at the root and 1 at the tip.
[[nodiscard]] importer::SourceMesh make_card(const CardDesc& desc);

/// Appends `card` to `mesh`.
void append_card(const importer::SourceMesh& card, importer::SourceMesh& mesh);

/// All of the mesh as one patch, in one pose.
[[nodiscard]] PatchSurface surface_of(const HairMesh& mesh, std::span<const Pose> poses);

/// The patch after so many steps, as vertices of the mesh.
[[nodiscard]] std::vector<std::uint32_t> after(const HairMesh& mesh, const PatchSurface& surface,
                                               const CollapseSequence& sequence, std::size_t steps);

/// Distance of a point from the nearest of these triangles, by looking at all of them.
[[nodiscard]] double distance_from(const HairMesh& mesh, std::span<const std::uint32_t> triangles,
                                   const Eigen::Vector3f& point);

}  // namespace coif::cook
