#pragma once

#include "cook/select/head.h"

#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace coif::cook {

/// What of a head shows without its hair: joints and the mesh of the head itself. Metres, model space.
struct HeadLandmarks {
  std::optional<Eigen::Vector3d> joint;                ///< The head turns about it; at the end of a spine.
  std::optional<Eigen::Vector3d> neck;                 ///< The joint below.
  std::optional<Eigen::Vector3d> end;                  ///< The marker of the head bone's end, near the crown.
  std::optional<std::array<Eigen::Vector3d, 2>> eyes;  ///< Middles of the eyeballs.
  std::optional<Eigen::AlignedBox3d> mesh;             ///< What follows the head bone; the skull may be cut away.
  std::size_t mesh_vertices = 0;
  double forwards = 0;  ///< 1: it looks along +Z, -1: along -Z, 0: nothing shows it.

  /// Enough to say how large the head is and where.
  [[nodiscard]] bool show_size() const { return mesh || (joint && (eyes || neck || end)); }

  /// The mesh is higher than wide, so that its skull is not cut away under the hair.
  [[nodiscard]] bool has_whole_mesh() const { return mesh && mesh->sizes().y() > 1.1 * mesh->sizes().x(); }

  /// "a joint, its neck, two eyes and 650 vertices"
  [[nodiscard]] std::string text() const;
};

/// What joints show of the head that turns about the node `head`, without its mesh; none for kNoIndex.
[[nodiscard]] HeadLandmarks find_joint_landmarks(const importer::SourceModel& source, std::uint32_t head);

/// The same with the head's own mesh, which is no part of `hair`.
[[nodiscard]] HeadLandmarks find_landmarks(const importer::SourceModel& source, const HairMesh& hair,
                                           const HeadBone& head_bone);

/// How unlikely a head is that has these landmarks: squared deviations from the proportions of heads, each of which
/// counts for nine at most, since a rig or a mesh may be unusual in one thing.
[[nodiscard]] double surprise(const HeadEllipsoid& head, const HeadLandmarks& landmarks);

/// The likeliest head by landmarks that show_size().
[[nodiscard]] HeadEllipsoid likeliest_head(const HeadLandmarks& landmarks);

}  // namespace coif::cook
