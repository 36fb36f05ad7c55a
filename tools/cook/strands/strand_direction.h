#pragma once

#include "cook/select/hair_mesh.h"
#include "cook/select/head.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace coif {

struct StrandField {
  std::vector<Eigen::Vector3f> tangent;  ///< Per vertex, unit, root to tip, perpendicular to the normal.
  std::vector<float> place;              ///< Per vertex, 0 root .. 1 tip.
  bool along_u = false;                  ///< In the texture most patches run along U, not V.
  Eigen::Vector3d mean{0, 0, 0};         ///< Of the tangents, by area; length 1 where all are the same.
  std::string reason;                    ///< How roots were told from tips, for the report.

  /// Follows the mesh when vertices equal to `originals` were appended.
  void append_copies(std::span<const std::uint32_t> originals) {
    for (std::uint32_t v : originals) {
      tangent.push_back(Eigen::Vector3f(tangent[v]));
      place.push_back(float(place[v]));
    }
  }
};

struct StrandSettings {
  std::string root = "auto";             ///< As in the recipe: the side of the texture where all roots are.
  bool trust_texture = true;             ///< False where patches are not unwrapped in one piece.
  std::span<const float> depth_of_node;  ///< Bones between each node of the source and the head bone.
  unsigned threads = 1;                  ///< The result does not depend on it.
};

/// The direction of the strands on every vertex: along the texture axis that runs down the patch's longer side, or over
/// the surface from end to end where texture coordinates say nothing. The root is the end that is nearer to the head,
/// follows bones nearer to it, is higher and wider. Where that says little, the side of the texture counts that has the
/// roots in other patches, since one artist paints them on one side, and which way the patches beside run. Vertices are
/// not shared between patches.
[[nodiscard]] StrandField find_strand_direction(const HairMesh& mesh, std::span<const std::uint32_t> place,
                                                const PatchSet& patches, const FittedHead& head,
                                                const StrandSettings& settings);

/// StrandSettings::depth_of_node for a head bone: 0 for it and whatever is not below it.
[[nodiscard]] std::vector<float> depths_below(const SourceModel& source, std::uint32_t head_node);

struct ShellSplit {
  std::uint32_t shells = 0;  ///< Patches that were too wide.
  std::uint32_t parts = 0;   ///< What they became.
  std::uint32_t left = 0;    ///< Patches that are still too wide: no edges run along them.
};

/// Cuts patches wider than `widest` metres across their strands. A patch is drawn in one place of the order, and a cap
/// that reaches round the head has none: its left half is behind where its right half is in front. Cuts follow edges
/// that run along the strands: quads in a row from root to tip stay together as a ribbon, and neighbouring ribbons join,
/// the narrowest result first, as far as the width allows. Updates `patches` only; parts are numbered behind the
/// existing ones. `place` of each vertex from weld_places().
ShellSplit split_shells(const HairMesh& mesh, std::span<const std::uint32_t> place, const StrandField& strands,
                        double widest, PatchSet& patches);

}  // namespace coif
