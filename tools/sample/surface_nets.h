#pragma once

#include "sample/surface_mesh.h"

#include <Eigen/Core>

#include <array>
#include <functional>
#include <vector>

namespace coif::sample {

/// Corners of the boxes in which a field is sampled: ascending coordinates per axis, metres. Closer where the surface
/// has more detail. The surface must stay inside.
using SamplingGrid = std::array<std::vector<double>, 3>;

/// Coordinates from `from` to at least `to`, `coarse` apart, but `fine` apart between `fine_from` and `fine_to`.
[[nodiscard]] std::vector<double> graded_axis(double from, double to, double coarse, double fine_from, double fine_to,
                                              double fine);

using Field = std::function<double(const Eigen::Vector3d&)>;
using Gradient = std::function<Eigen::Vector3d(const Eigen::Vector3d&)>;

/// The zero surface of a signed distance field, one vertex per box that the surface crosses, moved onto the surface.
/// Source: Gibson, "Constrained Elastic Surface Nets", 1998, without the relaxation.
[[nodiscard]] SurfaceMesh extract_surface(const SamplingGrid& grid, const Field& distance, const Gradient& normal);

}  // namespace coif::sample
