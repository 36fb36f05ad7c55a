#include "cook/lod_surfaces.h"

#include "cook/triangle_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif {

SourceMesh make_card(const CardDesc& desc) {
  SourceMesh mesh;
  mesh.name = "hair";
  for (std::uint32_t row = 0; row <= desc.rows; ++row) {
    for (std::uint32_t column = 0; column <= desc.columns; ++column) {
      const float u = float(column) / float(desc.columns), v = float(row) / float(desc.rows);
      const float angle = desc.bend_radius > 0 ? v * desc.length / desc.bend_radius : 0;
      const float down = desc.bend_radius > 0 ? desc.bend_radius * std::sin(angle) : v * desc.length;
      const float out = desc.bend_radius > 0 ? desc.bend_radius * (1 - std::cos(angle)) : 0;
      mesh.positions.push_back(desc.root + Eigen::Vector3f((u - 0.5f) * desc.width, -down, -out));
      mesh.uvs.emplace_back(u, v);
    }
  }
  const std::uint32_t stride = desc.columns + 1;
  for (std::uint32_t row = 0; row < desc.rows; ++row) {
    for (std::uint32_t column = 0; column < desc.columns; ++column) {
      const std::uint32_t a = row * stride + column;
      mesh.triangles.insert(mesh.triangles.end(), {a, a + stride, a + 1, a + 1, a + stride, a + stride + 1});
    }
  }
  return mesh;
}

void append_card(const SourceMesh& card, SourceMesh& mesh) {
  const auto first = std::uint32_t(mesh.positions.size());
  mesh.name = card.name;
  mesh.positions.insert(mesh.positions.end(), card.positions.begin(), card.positions.end());
  mesh.uvs.insert(mesh.uvs.end(), card.uvs.begin(), card.uvs.end());
  for (std::uint32_t v : card.triangles) mesh.triangles.push_back(first + v);
}

PatchSurface surface_of(const HairMesh& mesh, std::span<const Pose> poses) {
  const PatchSet patches{std::vector<std::uint32_t>(mesh.triangle_count(), 0), 1};
  return make_patch_surface(mesh, weld_places(mesh.positions, 1.0e-6), view_patches(mesh, patches)[0], poses);
}

std::vector<std::uint32_t> after(const HairMesh& mesh, const PatchSurface& surface, const CollapseSequence& sequence,
                                 std::size_t steps) {
  return collapsed_triangles(surface, sequence, steps, mesh.triangles);
}

double distance_from(const HairMesh& mesh, std::span<const std::uint32_t> triangles, const Eigen::Vector3f& point) {
  const auto corner = [&](std::size_t i) -> Eigen::Vector3d { return mesh.positions[triangles[i]].cast<double>(); };
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < triangles.size(); i += 3) {
    nearest = std::min(nearest, squared_distance(point.cast<double>(), corner(i), corner(i + 1), corner(i + 2)));
  }
  return std::sqrt(nearest);
}

}  // namespace coif
