#pragma once
// What tests of the sample files ask of meshes.

#include "mannequin/head_shape.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace coif::research {

/// Empty where there is no such file.
[[nodiscard]] std::vector<std::uint8_t> read_bytes(const std::string& path);

[[nodiscard]] Eigen::Vector3d corner(const mannequin::SurfaceMesh& mesh, std::size_t triangle, std::size_t k);

/// Vertices and triangle centres.
[[nodiscard]] std::vector<Eigen::Vector3d> points_of(const mannequin::SurfaceMesh& mesh);

/// One number per vertex: the smallest vertex that triangles connect it to.
[[nodiscard]] std::vector<std::uint32_t> connected_groups(const mannequin::SurfaceMesh& mesh);

/// Vertices that lie where one of another connected group lies, as exactly as the file stores places.
[[nodiscard]] std::size_t groups_that_touch(const mannequin::SurfaceMesh& mesh);

/// The ellipsoid that a recipe declares for the head.
struct DeclaredHead {
  Eigen::Vector3d center, radii;

  explicit DeclaredHead(const std::string& recipe);
  /// 1 on the surface, more outside.
  [[nodiscard]] double level(const Eigen::Vector3d& point) const;
};

}  // namespace coif::research
