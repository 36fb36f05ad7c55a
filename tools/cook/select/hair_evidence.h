#pragma once
// What in a source says that something is hair: names, bones, transparency, place.

#include "cook/select/mesh_topology.h"
#include "import/source_model.h"

#include <string>
#include <string_view>
#include <vector>

namespace coif::cook {

/// True for names of hair in the languages that artists name things in ("hair", "Fringe_L", "pony tail", "kami"), and
/// not for what is worn in it ("hairband") or only spelt like it ("chair").
[[nodiscard]] bool is_called_hair(std::string_view name);

/// Worn in hair ("hairband"), and not hair, though the name has the word.
[[nodiscard]] bool is_called_adornment(std::string_view name);

/// "opacity", "alpha", "transparent": what exporters call the one material with soft edges.
[[nodiscard]] bool is_called_transparent(std::string_view name);

/// Per node, true for hair's own bones: called hair or moved by a spring, and below the head where there is one. The
/// node of a mesh is no bone, whatever it is called.
[[nodiscard]] std::vector<bool> find_hair_bones(const importer::SourceModel& source);

/// True where hands, feet, arms or legs move a good part of some mesh: the model is, or has, a body.
[[nodiscard]] bool moves_limbs(const importer::SourceModel& source);

/// The head bone as far as names tell: declared by the file, else the node called head with most nodes below it.
/// kNoIndex without one.
[[nodiscard]] std::uint32_t guess_head_node(const importer::SourceModel& source);

/// Per node, false for what below a head carries something else than hair: eyes, lids, lips, jaw. Where the file has
/// hair bones, only those, what is above them and what is below them carry hair.
[[nodiscard]] std::vector<bool> find_carriers(const importer::SourceModel& source);

/// What is known of one connected piece.
struct PieceEvidence {
  std::size_t triangles = 0;
  double hair_bone_share = 0;         ///< Of its skin weight, 0..1.
  double largest_triangle_share = 0;  ///< Of hair bones, at the triangle where it is largest, 0..1.
  double largest_hair_bone = 0;       ///< Share of hair bones at the vertex where it is largest, 0..1.
  double eye_bone_share = 0;          ///< Of lids, lashes, brows and eyes, 0..1.
  double head_share = 0;              ///< Of the head and everything below it, 0..1.
  double height = 0;                  ///< Of its highest vertex, metres.
};

inline constexpr double kMovedByEyes = 0.15;  ///< Of a piece's weight: then it is a lash, a brow or a lid.
inline constexpr double kOnHead = 0.3;        ///< Of a piece's weight: long hair reaches the shoulders.

/// One entry per piece of `mesh`.
[[nodiscard]] std::vector<PieceEvidence> weigh_pieces(const importer::SourceModel& source,
                                                      const importer::SourceMesh& mesh, const MeshPieces& pieces,
                                                      const std::vector<bool>& hair_bones, std::uint32_t head_node);

/// True where the form of a model alone says that it is a head, a bust or a body, and nothing on it hair: nearly all of
/// its surface are closed, full forms, as a head is and no strip, sheet or shell of hair; or the largest part is a
/// closed figure that stands on the ground. A ball of hair in one closed form looks the same: whoever asks this has
/// looked for names before.
[[nodiscard]] bool is_bare_body(const importer::SourceModel& source, double weld_distance);

/// The first node that is called hair and holds nothing: what an exporter leaves of curves or particles that it does
/// not write. Empty where there is none.
[[nodiscard]] std::string empty_hair_node(const importer::SourceModel& source);

}  // namespace coif::cook
