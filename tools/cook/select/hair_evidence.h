#pragma once

// The signs that a part of a source is hair: names, bones, transparency, place.

#include "cook/select/called.h"
#include "cook/select/hair_mesh.h"
#include "cook/select/mesh_topology.h"
#include "import/source_model.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace coif::cook {

/// What a name is asked: is_called_hair() and its like.
using NameQuestion = bool (*)(std::string_view name);

/// Whether a mesh or its material is called so.
[[nodiscard]] bool either_is_called(const importer::SourceModel& source, const importer::SourceMesh& mesh,
                                    NameQuestion is_called);

/// What the names of a mesh, its material and its texture say of it.
struct HairNames {
  std::string why_hair;        ///< "its material is called 'Hair'"; empty where nothing says that it is hair.
  bool say_otherwise = false;  ///< Worn on a head or in hair, or a part of skin and face.
};

[[nodiscard]] HairNames names_of(const importer::SourceModel& source, const importer::SourceMesh& mesh);

/// Its material is drawn with transparency, or named after it.
[[nodiscard]] bool is_transparent(const importer::SourceModel& source, const importer::SourceMesh& mesh);

/// A triangle's colour as seen, 0..1, by its material and its vertices; none where it has a texture.
[[nodiscard]] std::optional<Eigen::Vector3f> color_without_texture(const importer::SourceModel& source,
                                                                   const importer::SourceMesh& mesh,
                                                                   std::size_t triangle);

/// Whether each mesh that gave hair, or its material, is called so; the name of a file with nothing but hair counts
/// where these say nothing.
[[nodiscard]] bool hair_is_called(const importer::SourceModel& source, const HairMesh& hair, NameQuestion is_called,
                                  NameQuestion is_file_called);

/// Whether the hair is called a beard and nothing lies over the middle of a head.
[[nodiscard]] bool is_beard(const importer::SourceModel& source, const HairMesh& hair);

/// Weight of the vertex `v` on those nodes for which `counts` is true, 0..1; a mesh without a skin has all of it on its
/// node.
[[nodiscard]] float weight_on(const importer::SourceMesh& mesh, std::size_t v, const std::vector<bool>& counts);

/// Per node, true for hair's own bones: with a hair name or moved by a spring, and below the head if there is one. The
/// node of a mesh is no bone, whatever its name.
[[nodiscard]] std::vector<bool> find_hair_bones(const importer::SourceModel& source);

/// True where hands, feet, arms or legs move a good part of some mesh: the model is, or has, a body.
[[nodiscard]] bool moves_limbs(const importer::SourceModel& source);

/// The head bone, as far as names show it: the one declared by the file, else the node called head with most nodes
/// below it. kNoIndex if there is none.
[[nodiscard]] std::uint32_t guess_head_node(const importer::SourceModel& source);

/// Per node, false for nodes below a head that carry something other than hair: eyes, lids, lips, jaw. Where the file
/// has hair bones, only these and the nodes above and below them carry hair.
[[nodiscard]] std::vector<bool> find_carriers(const importer::SourceModel& source);

/// Share of a piece's weight: a fringe mostly follows the head.
inline constexpr double kMovedByHairBones = 0.03;
inline constexpr double kSurelyMoved = 0.4;  ///< At some vertex; faces under a fringe have only a touch of its bones.

/// Evidence about one connected piece.
struct PieceEvidence {
  std::size_t triangles = 0;
  double hair_bone_share = 0;         ///< Share of hair bones in its skin weight, 0..1.
  double largest_triangle_share = 0;  ///< Largest share of hair bones at a triangle, 0..1.
  double largest_hair_bone = 0;       ///< Share of hair bones at the vertex where it is largest, 0..1.
  double eye_bone_share = 0;          ///< Share of lids, lashes, brows and eyes, 0..1.
  double head_share = 0;              ///< Share of the head and everything below it, 0..1.
  double height = 0;                  ///< Height of its highest vertex, metres.

  [[nodiscard]] bool is_moved_as_hair() const {
    return hair_bone_share >= kMovedByHairBones && largest_hair_bone >= kSurelyMoved;
  }
};

/// Share of a piece's weight: above it the piece is a lash, a brow or a lid.
inline constexpr double kMovedByEyes = 0.15;
inline constexpr double kOnHead = 0.3;  ///< Share of a piece's weight: long hair reaches the shoulders.

/// One entry per piece of `mesh`.
[[nodiscard]] std::vector<PieceEvidence> weigh_pieces(const importer::SourceModel& source,
                                                      const importer::SourceMesh& mesh, const MeshPieces& pieces,
                                                      const std::vector<bool>& hair_bones, std::uint32_t head_node);

/// True where the form of a model alone shows that it is a head, a bust or a body without hair: nearly all of its
/// surface are closed, full forms, like a head and unlike any strip, sheet or shell of hair; or its largest part is a
/// closed figure that stands on the ground. A ball of hair in one closed form looks the same, so callers look for names
/// first.
[[nodiscard]] bool is_bare_body(const importer::SourceModel& source, double weld_distance);

/// The model reaches from the ground to well above its depth, as bodies do; hair alone lies where a head would be.
[[nodiscard]] bool stands_on_ground(const importer::SourceModel& source);

/// The first node that has a hair name but no content: exporters leave one for curves or particles that they do not
/// write. Empty where there is none.
[[nodiscard]] std::string empty_hair_node(const importer::SourceModel& source);

/// One island of a mesh: triangles that hang together in its surface and its texture.
struct SurfaceIsland {
  std::uint32_t mesh = 0;
  std::uint32_t piece = 0;  ///< Pieces hang together in the surface alone.
  PieceEvidence evidence;
  Eigen::AlignedBox3d box;
  double area = 0;
  Eigen::AlignedBox2f cell;  ///< Box in the texture.
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  bool has_color = true;
};

/// The islands of all meshes of a model, one mesh after the other.
struct SurfaceIslands {
  std::vector<SurfaceIsland> list;
  std::vector<MeshPieces> of_mesh;   ///< Per mesh: the island of each triangle, from 0 on.
  std::vector<std::uint32_t> first;  ///< Per mesh: the number in `list` of its island 0.
};

/// `head`: the head's node, or kNoIndex. `only_on_head`: cells and colours are those of islands on it alone.
[[nodiscard]] SurfaceIslands find_surface_islands(const importer::SourceModel& source, std::uint32_t head,
                                                  bool only_on_head, double weld_distance);

}  // namespace coif::cook
