#include "research/sample_meshes.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <numeric>
#include <tuple>

namespace coif::research {

using Eigen::Vector3d;

std::vector<std::uint8_t> read_bytes(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
}

Vector3d corner(const mannequin::SurfaceMesh& mesh, std::size_t triangle, std::size_t k) {
  return mesh.positions[mesh.triangles[3 * triangle + k]];
}

std::vector<Vector3d> points_of(const mannequin::SurfaceMesh& mesh) {
  std::vector<Vector3d> points = mesh.positions;
  for (std::size_t t = 0; t < mesh.triangles.size() / 3; ++t)
    points.push_back((corner(mesh, t, 0) + corner(mesh, t, 1) + corner(mesh, t, 2)) / 3.0);
  return points;
}

std::vector<std::uint32_t> connected_groups(const mannequin::SurfaceMesh& mesh) {
  std::vector<std::uint32_t> group(mesh.positions.size());
  std::iota(group.begin(), group.end(), 0u);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
      const std::uint32_t* t = &mesh.triangles[i];
      const std::uint32_t low = std::min({group[t[0]], group[t[1]], group[t[2]]});
      for (int k = 0; k < 3; ++k) {
        changed |= group[t[k]] != low;
        group[t[k]] = low;
      }
    }
  }
  return group;
}

std::size_t groups_that_touch(const mannequin::SurfaceMesh& mesh) {
  const std::vector<std::uint32_t> group = connected_groups(mesh);
  const auto stored = [](double value) { return std::round(value * 65536.0); };
  std::map<std::tuple<double, double, double>, std::uint32_t> owner;
  std::size_t shared = 0;
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vector3d& p = mesh.positions[i];
    const auto [found, added] = owner.try_emplace({stored(p.x()), stored(p.y()), stored(p.z())}, group[i]);
    shared += found->second != group[i] ? 1 : 0;
  }
  return shared;
}

DeclaredHead::DeclaredHead(const std::string& recipe) {
  std::ifstream in(recipe);
  const nlohmann::json head = nlohmann::json::parse(in, nullptr, true, true).at("head");
  const auto vector = [&head](const char* key) {
    const nlohmann::json& v = head.at(key);
    return Vector3d(v.at(0).get<double>(), v.at(1).get<double>(), v.at(2).get<double>());
  };
  center = vector("center");
  radii = vector("radii");
}

double DeclaredHead::level(const Vector3d& point) const { return (point - center).cwiseQuotient(radii).norm(); }

}  // namespace coif::research
