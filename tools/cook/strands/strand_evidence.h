#pragma once

#include "cook/select/head.h"
#include "cook/strands/hair_strips.h"

#include <array>
#include <span>
#include <vector>

namespace coif {

/// A number that grows along the strands of one patch, from one end to the other; which end is the root is not known yet.
struct StrandAxis {
  int texture_axis = -1;          ///< 0: U, 1: V, -1: by walking over the surface.
  std::vector<float> coordinate;  ///< Per vertex of the view, 0..1.
};

/// Direction of growth of U and V over the triangle at `t`: dp/du and dp/dv, metres per texture; zero without an inverse.
[[nodiscard]] std::array<Eigen::Vector3f, 2> texture_axes(const HairMesh& mesh, std::size_t t);

/// Direction in which a coordinate per vertex grows over the triangle at `t`, per metre; zero without area.
[[nodiscard]] Eigen::Vector3f gradient(const HairMesh& mesh, std::size_t t, std::span<const float> coordinate);

/// How much longer the patch is along V than along U, -1..1; 0 where texture coordinates are of no use: most of the area
/// is in one spot of the texture, as with palettes.
[[nodiscard]] float texture_preference(const HairMesh& mesh, const PatchView& patch);

/// The coordinate along `texture_axis` (0 or 1), or for -1 the distance over the surface from one end of the patch, the
/// one that is farthest from everything else.
[[nodiscard]] StrandAxis strand_axis(const HairStrips& hair, const PatchView& patch, int texture_axis);

/// How the strands of two patches that lie beside each other run.
struct Neighbour {
  std::uint32_t patch = 0;
  float agreement = 0;  ///< 1: the same way, -1: opposite; over a patch's neighbours at most 1 in all.
};

/// For each patch the ones whose vertices are within `reach` metres of its own and whose tangents are about parallel or
/// opposite there. Looks at a bounded number of vertices per patch: near-linear.
[[nodiscard]] std::vector<std::vector<Neighbour>> find_neighbours(const HairMesh& mesh,
                                                                  const std::vector<PatchView>& views,
                                                                  std::span<const Eigen::Vector3f> tangents,
                                                                  double reach);

/// What the two ends of a patch say about which one is the root. Each from -1 (the high end of the coordinate is it) to 1
/// (the low end), 0 where it says nothing.
struct RootEvidence {
  float distance = 0;  ///< Roots are nearer to the head's surface.
  float bones = 0;     ///< Roots follow bones that are nearer to the head bone.
  float height = 0;    ///< Hair hangs.
  float taper = 0;     ///< Tips are narrower.

  /// What the patch says on its own: positive where the low end is the root.
  [[nodiscard]] float sum() const { return distance + 1.5f * bones + 0.35f * height + 0.25f * taper; }
};

/// `depth_of_node`: bones between each node of the source and the head.
[[nodiscard]] RootEvidence weigh_ends(const HairMesh& mesh, const PatchView& patch, const StrandAxis& axis,
                                      const FittedHead& head, std::span<const float> depth_of_node);

}  // namespace coif
