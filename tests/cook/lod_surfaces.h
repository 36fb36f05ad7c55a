#pragma once
// Surfaces and levels of detail of them for tests, small enough to know every number of.

#include "cook/built_models.h"
#include "cook/make_lods.h"
#include "cook/weld.h"

namespace coif {

struct CardDesc {
  std::uint32_t columns = 4, rows = 12;
  float width = 0.06f, length = 0.3f;
  float bend_radius = 0;  ///< Of the cylinder that the card is part of, along its length; 0: flat.
  Eigen::Vector3f root{0, 1.6f, -0.1f};
};

/// A grid that hangs down from its root, U across, V 0 at the root and 1 at the tip.
[[nodiscard]] SourceMesh make_card(const CardDesc& desc);

/// Appends `card` to `mesh`.
void append_card(const SourceMesh& card, SourceMesh& mesh);

/// All of the mesh as one patch, in one pose.
[[nodiscard]] PatchSurface surface_of(const HairMesh& mesh, std::span<const Pose> poses);

/// The patch after so many steps, as vertices of the mesh.
[[nodiscard]] std::vector<std::uint32_t> after(const HairMesh& mesh, const PatchSurface& surface,
                                               const CollapseSequence& sequence, std::size_t steps);

/// Distance of a point from the nearest of these triangles, by looking at all of them.
[[nodiscard]] double distance_from(const HairMesh& mesh, std::span<const std::uint32_t> triangles,
                                   const Eigen::Vector3f& point);

}  // namespace coif
