#pragma once
// The mannequin's bust as a signed distance field: what the bust's mesh is cut from, and what the hair keeps clear of.

#include "sample/surface_mesh.h"

#include <Eigen/Core>

namespace coif::sample {

/// The skull without the face, in model space and metres. The hair is laid around this ellipsoid.
inline const Eigen::Vector3d kCraniumCenter{0.0, 1.628, -0.010};
inline const Eigen::Vector3d kCraniumRadii{0.0765, 0.092, 0.0965};

/// Distance to the bust's surface, metres, negative inside; exact near the surface up to a few percent.
[[nodiscard]] double head_distance(const Eigen::Vector3d& point);

/// Unit gradient of head_distance(): outwards.
[[nodiscard]] Eigen::Vector3d head_normal(const Eigen::Vector3d& point);

/// The whole bust, closed, with smooth normals.
[[nodiscard]] SurfaceMesh make_bust();

/// The same head on a neck without shoulders, for hair that would rest on them.
[[nodiscard]] double bare_head_distance(const Eigen::Vector3d& point);

/// Unit gradient of bare_head_distance(): outwards.
[[nodiscard]] Eigen::Vector3d bare_head_normal(const Eigen::Vector3d& point);

/// The whole bare head, closed, with smooth normals.
[[nodiscard]] SurfaceMesh make_bare_head();

/// A hair-coloured cap just above the scalp, so that no skin shows between two strips.
[[nodiscard]] SurfaceMesh make_scalp_cap();

}  // namespace coif::sample
