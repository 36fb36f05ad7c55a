#pragma once
// Meshes, images and fields that heads are made of, and the bust of the mannequin.

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace coif::mannequin {

/// Up to four joints of one vertex. Unused places have weight zero; the weights add up to one.
struct SkinInfluences {
  std::array<std::uint16_t, 4> joints{};
  std::array<double, 4> weights{};
};

/// Arrays per vertex are either empty or as long as `positions`.
struct SurfaceMesh {
  std::vector<Eigen::Vector3d> positions;  ///< Model space, metres, Y up, face towards +Z.
  std::vector<Eigen::Vector3d> normals;    ///< Unit, outwards.
  std::vector<Eigen::Vector2d> uvs;        ///< V grows downwards in the image.
  std::vector<SkinInfluences> skin;
  std::vector<std::uint32_t> triangles;  ///< Three indices each, counter-clockwise seen from outside.
};

/// RGBA, sRGB, straight alpha, rows top to bottom.
struct PaintedImage {
  std::uint32_t width = 0, height = 0;
  std::vector<std::uint8_t> rgba;
};

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

/// The mesh with one vertex, the mean, for all in a cubic cell. `cell`: a cell's edge at a point, metres, one of a few
/// values; 0 keeps the vertex. Triangles that lose an edge or are turned round are gone. For meshes without weights.
[[nodiscard]] SurfaceMesh thinned(const SurfaceMesh& mesh, const Field& cell);

// The mannequin's bust as a signed distance field: the bust's mesh is cut from it, and the hair keeps clear of it.

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

/// A hair-coloured cap just above the scalp, so that no skin shows between two strips; by default the bust's.
/// `distance` and `normal`: of a head about as large, in the same place.
[[nodiscard]] SurfaceMesh make_scalp_cap(const Field& distance = head_distance, const Gradient& normal = head_normal);

}  // namespace coif::mannequin
