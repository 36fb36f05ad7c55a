#include "mannequin/head_shape.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace coif::mannequin {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr std::uint32_t kNoVertex = 0xFFFFFFFFu;

class SurfaceNets {
 public:
  SurfaceNets(const SamplingGrid& grid, const Field& distance) : grid_(grid) {
    for (std::size_t axis = 0; axis < 3; ++axis) corners_[static_cast<int>(axis)] = static_cast<int>(grid[axis].size());
    const auto count = static_cast<std::size_t>(corners_.prod());
    values_.reserve(count);
    for (int z = 0; z < corners_.z(); ++z)
      for (int y = 0; y < corners_.y(); ++y)
        for (int x = 0; x < corners_.x(); ++x) values_.push_back(distance(position({x, y, z})));
    vertex_of_box_.assign(count, kNoVertex);
  }

  SurfaceMesh run() {
    for_each_box([this](const Vector3i& box) { place_vertex(box); });
    for_each_box([this](const Vector3i& box) { connect(box); });
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::size_t index(const Vector3i& c) const {
    return static_cast<std::size_t>((c.z() * corners_.y() + c.y()) * corners_.x() + c.x());
  }
  [[nodiscard]] Vector3d position(const Vector3i& c) const {
    const auto at = [&](int axis) { return grid_[static_cast<std::size_t>(axis)][static_cast<std::size_t>(c[axis])]; };
    return {at(0), at(1), at(2)};
  }
  [[nodiscard]] double value(const Vector3i& c) const { return values_[index(c)]; }

  template <class Visit>
  void for_each_box(Visit visit) const {
    for (int z = 0; z + 1 < corners_.z(); ++z)
      for (int y = 0; y + 1 < corners_.y(); ++y)
        for (int x = 0; x + 1 < corners_.x(); ++x) visit(Vector3i{x, y, z});
  }

  /// The mean of the points where the surface cuts the box's twelve edges.
  void place_vertex(const Vector3i& box) {
    Vector3d sum = Vector3d::Zero();
    int cuts = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3i side_a = Vector3i::Unit((axis + 1) % 3), side_b = Vector3i::Unit((axis + 2) % 3);
      for (int side = 0; side < 4; ++side) {
        const Vector3i from = box + (side & 1) * side_a + (side >> 1) * side_b;
        const Vector3i to = from + Vector3i::Unit(axis);
        const double a = value(from), b = value(to);
        if ((a < 0) == (b < 0)) continue;
        sum += position(from) + a / (a - b) * (position(to) - position(from));
        ++cuts;
      }
    }
    if (cuts == 0) return;
    vertex_of_box_[index(box)] = static_cast<std::uint32_t>(mesh_.positions.size());
    mesh_.positions.push_back(sum / cuts);
  }

  /// A quad around each of the three edges that start at the box's lowest corner and cross the surface. An edge on the
  /// grid's own side has no box behind it: there the surface ends.
  void connect(const Vector3i& box) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3i side_a = Vector3i::Unit((axis + 1) % 3), side_b = Vector3i::Unit((axis + 2) % 3);
      if (box[(axis + 1) % 3] == 0 || box[(axis + 2) % 3] == 0) continue;
      const bool inside = value(box) < 0;
      if (inside == (value(box + Vector3i::Unit(axis)) < 0)) continue;
      const std::uint32_t a = vertex_of_box_[index(box - side_a - side_b)];
      const std::uint32_t b = vertex_of_box_[index(box - side_b)];
      const std::uint32_t c = vertex_of_box_[index(box)];
      const std::uint32_t d = vertex_of_box_[index(box - side_a)];
      if (inside)
        mesh_.triangles.insert(mesh_.triangles.end(), {a, b, c, a, c, d});
      else
        mesh_.triangles.insert(mesh_.triangles.end(), {a, c, b, a, d, c});
    }
  }

  const SamplingGrid& grid_;
  Vector3i corners_;
  std::vector<double> values_;
  std::vector<std::uint32_t> vertex_of_box_;
  SurfaceMesh mesh_;
};

}  // namespace

std::vector<double> graded_axis(double from, double to, double coarse, double fine_from, double fine_to, double fine) {
  std::vector<double> axis{from};
  while (axis.back() < to) {
    // Steps shrink gradually towards the fine stretch, so that neighbouring triangles stay of similar size.
    const double outside = std::max({fine_from - axis.back(), axis.back() - fine_to, 0.0});
    axis.push_back(axis.back() + std::min(coarse, fine + 0.22 * outside));
  }
  return axis;
}

SurfaceMesh extract_surface(const SamplingGrid& grid, const Field& distance, const Gradient& normal) {
  SurfaceMesh mesh = SurfaceNets(grid, distance).run();
  for (Vector3d& p : mesh.positions) {
    for (int i = 0; i < 3; ++i) p -= distance(p) * normal(p);
    mesh.normals.push_back(normal(p));
  }
  return mesh;
}

SurfaceMesh thinned(const SurfaceMesh& mesh, const Field& cell) {
  std::map<std::array<long, 4>, std::uint32_t> vertex_in;
  std::vector<std::uint32_t> place_of;
  std::vector<double> count;
  SurfaceMesh result;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const double edge = cell(mesh.positions[i]);
    auto place = static_cast<std::uint32_t>(count.size());
    if (edge > 0) {
      // Cells are centred on 0, so that no plane of symmetry is on a border, where the last bit of a sum decides.
      std::array<long, 4> key{std::lround(edge * 1e6)};
      for (int axis = 0; axis < 3; ++axis) key[std::size_t(axis) + 1] = std::lround(mesh.positions[i][axis] / edge);
      place = vertex_in.try_emplace(key, place).first->second;
    }
    place_of.push_back(place);
    if (place == count.size()) {
      count.push_back(0);
      result.positions.emplace_back(Vector3d::Zero());
      result.normals.emplace_back(Vector3d::Zero());
      result.uvs.emplace_back(Eigen::Vector2d::Zero());
    }
    count[place] += 1;
    result.positions[place] += mesh.positions[i];
    result.normals[place] += mesh.normals[i];
    if (!mesh.uvs.empty()) result.uvs[place] += mesh.uvs[i];
  }
  for (std::size_t i = 0; i < count.size(); ++i) {
    result.positions[i] /= count[i];
    result.normals[i].normalize();
    result.uvs[i] /= count[i];
  }
  if (mesh.uvs.empty()) result.uvs.clear();
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    const std::uint32_t a = place_of[mesh.triangles[i]], b = place_of[mesh.triangles[i + 1]],
                        c = place_of[mesh.triangles[i + 2]];
    if (a == b || b == c || c == a) continue;
    // Where cells fold the surface, a triangle that is turned round lies between two others that are not.
    const std::vector<Vector3d>&p = result.positions, &n = result.normals;
    if ((p[b] - p[a]).cross(p[c] - p[a]).dot(n[a] + n[b] + n[c]) > 0)
      result.triangles.insert(result.triangles.end(), {a, b, c});
  }
  return result;
}

}  // namespace coif::mannequin
