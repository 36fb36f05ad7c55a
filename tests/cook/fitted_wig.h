#pragma once
// Strips on a round head, with chains fitted to them.

#include "cook/built_models.h"
#include "cook/recipe/recipe.h"
#include "cook/rig/fit_chains.h"

namespace coif::cook {

/// Radius 0.1 m around (0, 1.6, 0).
[[nodiscard]] FittedHead round_head();

struct FittedWig {
  importer::SourceModel source;
  HairMesh hair;  ///< The strips one after the other, their vertices in order.
  HairRig rig;
  Findings findings;

  /// First bone and joints of a chain: its start, then each tail.
  [[nodiscard]] std::vector<Eigen::Vector3d> joints(std::uint32_t chain) const;
  [[nodiscard]] double length(std::uint32_t chain) const;
  /// Weight of a vertex on a bone.
  [[nodiscard]] double weight(std::uint32_t vertex, std::uint32_t bone) const;
  /// Half the sum over all bones of the difference between two vertices: 0 the same, 1 nothing in common.
  [[nodiscard]] double weight_difference(std::uint32_t a, std::uint32_t b) const;
};

/// Each strip of two vertices per row, root first, is one source mesh.
[[nodiscard]] FittedWig fit_wig(const std::vector<importer::SourceMesh>& strips,
                                const Recipe& recipe = default_recipe());

/// A strip that hangs down from beside the head, `degrees` around it: 0 at the front (+Z), 90 at the left (+X).
[[nodiscard]] importer::SourceMesh make_tail(double degrees, float length, std::uint32_t rows = 60);

/// A strip that lies on the head from its top down to its equator.
[[nodiscard]] importer::SourceMesh make_scalp_strip(double degrees);

/// The model with X turned round, triangles wound the other way.
[[nodiscard]] std::vector<importer::SourceMesh> mirrored(std::vector<importer::SourceMesh> strips);

}  // namespace coif::cook
