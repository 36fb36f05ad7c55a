#include "cook/smooth_normals.h"

#include <Eigen/Geometry>

namespace coif {
namespace {

using Eigen::Vector3f;

Vector3f face_vector(const HairMesh& mesh, std::size_t t) {
  const Vector3f& a = mesh.positions[mesh.triangles[t]];
  return (mesh.positions[mesh.triangles[t + 1]] - a).cross(mesh.positions[mesh.triangles[t + 2]] - a);
}

bool is_unit(const Vector3f& n) { return std::abs(n.squaredNorm() - 1.0f) < 0.02f; }

}  // namespace

std::size_t complete_normals(HairMesh& mesh, std::span<const std::uint32_t> place) {
  mesh.normals.resize(mesh.positions.size(), Vector3f::Zero());
  std::size_t missing = 0;
  for (const Vector3f& n : mesh.normals) missing += is_unit(n) ? 0 : 1;
  if (missing == 0) return 0;

  std::vector<Vector3f> own(mesh.positions.size(), Vector3f::Zero()), mean = own;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    for (int k = 0; k < 3; ++k) own[mesh.triangles[t + std::size_t(k)]] += face_vector(mesh, t);
  }
  // Each corner adds its face to every side of the place that looks the same way; a side is known by its first vertex.
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (own[v].dot(own[place[v]]) >= 0) mean[place[v]] += own[v];
  }
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (is_unit(mesh.normals[v])) continue;
    const Vector3f& around = mean[place[v]];
    const bool same_side = own[v].dot(around) > 0;
    const Vector3f normal = same_side ? around : own[v];
    mesh.normals[v] = normal.norm() > 0 ? Vector3f(normal.normalized()) : Vector3f(Vector3f::UnitY());
  }
  return missing;
}

}  // namespace coif
