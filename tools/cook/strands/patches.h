#pragma once

#include "cook/recipe/findings.h"
#include "cook/select/hair_mesh.h"
#include "cook/strands/hair_strips.h"

#include <cstddef>
#include <span>
#include <string>

namespace coif::cook {

enum class Connectivity;

/// The recipe's word for it.
[[nodiscard]] const char* word_of(Connectivity connectivity);

struct ExtractedPatches {
  PatchSet patches;
  std::uint32_t by_index = 0;     ///< Groups of triangles that share vertices.
  std::uint32_t by_position = 0;  ///< Groups of triangles that share places.
  std::uint32_t by_island = 0;    ///< Groups of triangles that share an edge and its texture coordinates.
  Connectivity chosen{};          ///< Not kAuto.
  std::string reason;             ///< Why, for the report.
};

/// Algorithm 2 of the thesis, where connected triangles are one patch, by union-find: near-linear, while the published
/// form compares each triangle with each group. `connectivity` says which triangles are connected:
/// - kIndex: shared vertices, as published. Exporters split vertices at hard edges and seams, so patches may shatter.
/// - kPosition: shared places. Strips whose roots touch, or that lie on each other, become one patch.
/// - kIsland: a shared edge with the same texture coordinates at both ends, whatever its normals. A strip is unwrapped
///   in one piece, and two strips that touch are not.
/// - kAuto: islands (indices without texture coordinates), unless more than a quarter of the triangles are then in
///   fragments of fewer than 8 whose place has more: such a file is unwrapped face by face, and positions decide.
/// `welded` as in HairStrips.
[[nodiscard]] ExtractedPatches extract_patches(const HairMesh& mesh, std::span<const std::uint32_t> welded,
                                               Connectivity connectivity);

/// Extracts the patches of hair whose places are known and separates them. Notes how they are connected.
ExtractedPatches find_patches(HairStrips& hair, Connectivity connectivity, Findings& findings);

/// Cuts patches where their texture turns back. Modellers unwrap a strip that runs from ear to ear over the parting, or
/// from the parting to a band, half by half onto the same strands, so that one of its texture's ends is in the middle.
/// Each half has its own root and tip, and is sorted by itself. A fold is an edge across the strands on both sides of
/// which the texture runs in the same direction. Parts keep their patch's number. Returns the number of new patches.
std::uint32_t split_folds(HairStrips& hair, Findings& findings);

/// From a doll's tuft to a wig to the ankles: hair outside this range was written in another unit than the one read.
constexpr bool is_hair_sized(float metres) { return metres >= 0.05f && metres <= 3.0f; }

/// Hair with hardly any triangles per patch: its strips fell apart when patches were separated.
constexpr bool is_shattered(std::size_t triangles, std::size_t patches) {
  return patches > 8 && triangles < 4 * patches;
}

/// Metres; 0 for a box without a point.
[[nodiscard]] inline float largest_side(const Eigen::AlignedBox3f& box) {
  return box.isEmpty() ? 0.0f : box.sizes().maxCoeff();
}

/// Warns of hair that is not of a head's size.
void warn_of_odd_size(const HairMesh& hair, Findings& findings);

/// Warns of hair in fragments. `by`: the condition for triangles to be one patch.
void warn_of_fragments(const HairMesh& hair, std::size_t patches, Connectivity by, Findings& findings);

}  // namespace coif::cook
