#include "cook/merge_back_faces.h"

#include "cook/disjoint_sets.h"
#include "cook/mesh_edges.h"

#include <array>

namespace coif {
namespace {

constexpr double kNearlyAll = 0.95;

struct Face {
  std::array<std::uint32_t, 3> places{};  ///< Ascending.
  std::uint32_t triangle = 0;
  bool turned = false;  ///< Winds round against the ascending order.
};

Face face_of(const HairMesh& mesh, std::span<const std::uint32_t> place, std::size_t t) {
  Face face;
  face.triangle = std::uint32_t(t);
  for (std::size_t k = 0; k < 3; ++k) face.places[k] = place[mesh.triangles[3 * t + k]];
  // Rotating keeps the winding; swapping the last two turns it.
  std::ranges::rotate(face.places, std::ranges::min_element(face.places));
  face.turned = face.places[1] > face.places[2];
  if (face.turned) std::swap(face.places[1], face.places[2]);
  return face;
}

std::vector<Face> sorted_faces(const HairMesh& mesh, std::span<const std::uint32_t> place) {
  std::vector<Face> faces;
  faces.reserve(mesh.triangle_count());
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) faces.push_back(face_of(mesh, place, t));
  std::ranges::stable_sort(faces, {}, &Face::places);
  return faces;
}

void keep_triangles(const std::vector<bool>& keep, HairMesh& mesh) {
  std::size_t kept = 0;
  for (std::size_t t = 0; t < keep.size(); ++t) {
    if (!keep[t]) continue;
    for (std::size_t k = 0; k < 3; ++k) mesh.triangles[3 * kept + k] = mesh.triangles[3 * t + k];
    if (!mesh.mesh_of_triangle.empty()) mesh.mesh_of_triangle[kept] = mesh.mesh_of_triangle[t];
    ++kept;
  }
  mesh.triangles.resize(3 * kept);
  if (!mesh.mesh_of_triangle.empty()) mesh.mesh_of_triangle.resize(kept);
}

}  // namespace

MergedFaces merge_back_faces(HairMesh& mesh, std::span<const std::uint32_t> place) {
  const std::vector<Face> faces = sorted_faces(mesh, place);
  std::vector<bool> keep(faces.size(), true);
  MergedFaces merged;
  for (std::size_t first = 0, i = 1; i < faces.size(); ++i) {
    if (faces[i].places != faces[first].places) {
      first = i;
      continue;
    }
    keep[faces[i].triangle] = false;
    ++(faces[i].turned != faces[first].turned ? merged.back_faces : merged.copies);
  }
  if (merged.back_faces + merged.copies > 0) keep_triangles(keep, mesh);
  if (merged.back_faces > 0) mesh.double_sided = true;
  return merged;
}

bool is_closed(const HairMesh& mesh, std::span<const std::uint32_t> place) {
  DisjointSets pieces(mesh.triangle_count());
  std::vector<bool> at_border(mesh.triangle_count(), false);
  for_each_edge(sorted_edges(mesh.triangles, place), [&](std::span<const EdgeUse> uses) {
    for (const EdgeUse& use : uses) pieces.unite(uses.front().triangle, use.triangle);
    if (uses.size() == 1) at_border[uses.front().triangle] = true;
  });
  std::vector<bool> open(mesh.triangle_count(), false);
  for (std::uint32_t t = 0; t < at_border.size(); ++t) {
    if (at_border[t]) open[pieces.find(t)] = true;
  }
  std::size_t closed = 0;
  for (std::uint32_t t = 0; t < at_border.size(); ++t) closed += open[pieces.find(t)] ? 0 : 1;
  return double(closed) >= kNearlyAll * double(mesh.triangle_count());
}

}  // namespace coif
