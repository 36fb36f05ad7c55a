#include "compare/rig_difference.h"

#include <fmt/format.h>
#include <Eigen/Core>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <unordered_map>

namespace coif::compare {
namespace {

using Eigen::Vector3d;

constexpr double kReach = 2 * kSameSurface;  ///< Farther vertices count as this far apart.
/// Metres that the texture's whole width counts as: it decides only between vertices at one place.
constexpr double kTextureMetres = 1.0e-5;

Vector3d position(const Asset& asset, std::uint32_t vertex) {
  const float* p = asset.vertices()[vertex].position;
  const float* origin = asset.skeleton().head_joint;
  return {double(p[0]) + origin[0], double(p[1]) + origin[1], double(p[2]) + origin[2]};
}

using Cube = std::array<std::int64_t, 3>;

struct CubeHash {
  std::size_t operator()(const Cube& cube) const {
    std::uint64_t hash = 0;
    for (std::int64_t k : cube) hash = (hash ^ std::uint64_t(k)) * 0x9E3779B97F4A7C15u;
    return std::size_t(hash ^ (hash >> 32));
  }
};

Cube cube_of(const Vector3d& p) {
  Cube cube;
  for (int k = 0; k < 3; ++k) cube[std::size_t(k)] = std::int64_t(std::floor(p[k] / kReach));
  return cube;
}

std::vector<std::uint32_t> drawn_vertices(const Asset& asset) {
  const auto indices = asset.lod_indices(0);
  std::vector<std::uint32_t> vertices(indices.begin(), indices.end());
  std::ranges::sort(vertices);
  vertices.erase(std::ranges::unique(vertices).begin(), vertices.end());
  return vertices;
}

/// Vertices by the cube of kReach that they lie in: neighbours within it are in the 27 cubes around.
class VertexGrid {
 public:
  explicit VertexGrid(const Asset& asset) : asset_(asset) {
    for (std::uint32_t v : drawn_vertices(asset)) vertices_[cube_of(position(asset, v))].push_back(v);
  }

  struct Found {
    std::uint32_t vertex = kNone;
    double distance = kReach;  ///< Metres.
  };

  [[nodiscard]] Found nearest(const Vector3d& point, const float* uv) const {
    Found found;
    double least = std::numeric_limits<double>::max();
    const Cube home = cube_of(point);
    for (int n = 0; n < 27; ++n) {
      const auto cube = vertices_.find({home[0] + n % 3 - 1, home[1] + n / 3 % 3 - 1, home[2] + n / 9 - 1});
      if (cube == vertices_.end()) continue;
      for (std::uint32_t v : cube->second) {
        const double distance = (position(asset_, v) - point).norm();
        const float* other = asset_.vertices()[v].uv;
        const double texture = std::hypot(double(uv[0] - other[0]), double(uv[1] - other[1]));
        const double cost = distance + kTextureMetres * std::min(texture, 1.0);
        if (distance > kReach || cost >= least) continue;
        least = cost;
        found = {v, distance};
      }
    }
    return found;
  }

 private:
  const Asset& asset_;
  std::unordered_map<Cube, std::vector<std::uint32_t>, CubeHash> vertices_;
};

/// A third of the area of its triangles for each vertex of the asset.
std::vector<double> vertex_areas(const Asset& asset) {
  std::vector<double> area(asset.vertices().size(), 0);
  const auto indices = asset.lod_indices(0);
  for (std::size_t i = 0; i + 2 < indices.size(); i += 3) {
    const Vector3d p = position(asset, indices[i]);
    const double doubled = (position(asset, indices[i + 1]) - p).cross(position(asset, indices[i + 2]) - p).norm();
    for (std::size_t k = 0; k < 3; ++k) area[indices[i + k]] += doubled / 6;
  }
  return area;
}

bool has_skinned_mesh(const Asset& asset) {
  return !asset.lod_indices(0).empty() && asset.skin().size() == asset.vertices().size();
}

tl::unexpected<ToolError> not_the_same(double rms, double far_share) {
  return tl::unexpected(ToolError{
      ToolError::Kind::kBadInput,
      fmt::format("the two surfaces differ at rest by {:.1f} mm RMS or more ({:.0f} % of the vertices have none of the "
                  "other within {:.0f} mm); compare assets that are cooked from the same source and hair",
                  1000 * rms, 100 * far_share, 1000 * kReach)});
}

}  // namespace

tl::expected<SurfaceMatch, ToolError> match_surfaces(const Asset& a, const Asset& b) {
  if (!has_skinned_mesh(a) || !has_skinned_mesh(b)) {
    return tl::unexpected(
        ToolError{ToolError::Kind::kUnsupported, "an asset without a skinned mesh has no surface to compare"});
  }
  const VertexGrid grid(b);
  const std::vector<double> areas = vertex_areas(a);
  SurfaceMatch match;
  double squares = 0, far = 0;
  for (std::uint32_t v : drawn_vertices(a)) {
    const auto found = grid.nearest(position(a, v), a.vertices()[v].uv);
    squares += found.distance * found.distance;
    far += found.vertex == kNone ? 1 : 0;
    match.vertex_a.push_back(v);
    match.vertex_b.push_back(found.vertex);
    match.area.push_back(areas[v]);
  }
  const auto count = double(match.vertex_a.size());
  match.rest_rms = std::sqrt(squares / count);
  if (match.rest_rms > kSameSurface || far > 0.5 * count) return not_the_same(match.rest_rms, far / count);
  // Vertices without a partner stay out of the figures.
  for (std::size_t i = 0; i < match.area.size(); ++i) {
    if (match.vertex_b[i] != kNone) continue;
    match.vertex_b[i] = 0;
    match.area[i] = 0;
  }
  const double total = std::accumulate(match.area.begin(), match.area.end(), 0.0);
  for (double& share : match.area) share = total > 0 ? share / total : 1 / count;
  return match;
}

}  // namespace coif::compare
