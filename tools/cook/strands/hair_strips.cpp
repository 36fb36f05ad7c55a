#include "cook/strands/hair_strips.h"

#include "base/text.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace coif::cook {

std::string patches_text(std::span<const std::uint32_t> numbers) {
  return fmt::format("{} {}", numbers.size() == 1 ? "patch" : "patches", numbers_text(numbers));
}

std::vector<PatchView> HairStrips::views() const {
  std::vector<PatchView> views(patches.count);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) views[patches.patch_of[t]].triangles.push_back(3 * t);
  for (PatchView& view : views) {
    for (std::size_t t : view.triangles) {
      for (std::size_t k = 0; k < 3; ++k) view.vertices.push_back(mesh.triangles[t + k]);
    }
    std::ranges::sort(view.vertices);
    view.vertices.erase(std::ranges::unique(view.vertices).begin(), view.vertices.end());
  }
  return views;
}

namespace {

using Eigen::Vector3f;

Vector3f face_vector(const HairMesh& mesh, std::size_t t) {
  const Vector3f& a = mesh.positions[mesh.triangles[t]];
  return (mesh.positions[mesh.triangles[t + 1]] - a).cross(mesh.positions[mesh.triangles[t + 2]] - a);
}

bool is_unit(const Vector3f& n) { return std::abs(n.squaredNorm() - 1.0f) < 0.02f; }

}  // namespace

float doubled_area(const HairMesh& mesh, std::size_t t) { return face_vector(mesh, t).norm(); }

void HairStrips::append_copy(std::uint32_t vertex) {
  mesh.append_vertex(mesh, vertex);
  if (!welded.empty()) welded.push_back(std::uint32_t(welded[vertex]));
  if (strands.place.empty()) return;
  strands.tangent.push_back(Vector3f(strands.tangent[vertex]));
  strands.place.push_back(float(strands.place[vertex]));
}

void HairStrips::drop(const std::vector<bool>& dropped) {
  std::vector<bool> used(mesh.positions.size(), false);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    if (!dropped[patches.patch_of[i / 3]]) used[mesh.triangles[i]] = true;
  }
  HairMesh kept;
  kept.influence_begin = {0};
  kept.double_sided = mesh.double_sided;
  kept.source_meshes = mesh.source_meshes;
  kept.material = mesh.material;
  std::vector<std::uint32_t> new_index(used.size(), importer::kNoIndex), place(used.size(), importer::kNoIndex),
      new_welded;
  for (std::uint32_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    new_index[v] = kept.append_vertex(mesh, v);
    if (welded.empty()) continue;
    std::uint32_t& first = place[welded[v]];  // The first vertex that stays at this place.
    if (first == importer::kNoIndex) first = new_index[v];
    new_welded.push_back(first);
  }
  PatchSet left;
  std::vector<std::uint32_t> new_patch(patches.count, importer::kNoIndex);
  for (std::uint32_t t = 0; t < patches.patch_of.size(); ++t) {
    const std::uint32_t patch = patches.patch_of[t];
    if (dropped[patch]) continue;
    if (new_patch[patch] == importer::kNoIndex) {
      new_patch[patch] = left.count++;
      left.first_number.push_back(patches.number_of(patch));
    }
    left.patch_of.push_back(new_patch[patch]);
    kept.mesh_of_triangle.push_back(mesh.mesh_of_triangle[t]);
    for (std::size_t k = 0; k < 3; ++k) kept.triangles.push_back(new_index[mesh.triangles[3 * t + k]]);
  }
  is_part = true;
  mesh = std::move(kept);
  welded = std::move(new_welded);
  patches = std::move(left);
}

std::vector<std::uint32_t> HairStrips::separate_patches() {
  std::vector<std::uint32_t> owner(mesh.positions.size(), importer::kNoIndex);
  // A vertex's copies for other patches; most vertices have none.
  std::vector<std::pair<std::uint64_t, std::size_t>> foreign;  ///< Patch and vertex, corner.
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::uint32_t patch = patches.patch_of[i / 3], v = mesh.triangles[i];
    if (owner[v] == importer::kNoIndex) owner[v] = patch;
    if (owner[v] != patch) foreign.emplace_back(std::uint64_t(patch) << 32 | v, i);
  }
  std::ranges::sort(foreign);
  std::vector<std::uint32_t> originals;
  for (std::size_t i = 0; i < foreign.size(); ++i) {
    const auto& [key, corner] = foreign[i];
    const bool is_new = i == 0 || foreign[i - 1].first != key;
    if (is_new) {
      append_copy(std::uint32_t(key));
      originals.push_back(std::uint32_t(key));
    }
    mesh.triangles[corner] = std::uint32_t(mesh.positions.size() - 1);
  }
  return originals;
}

std::size_t HairStrips::complete_normals() {
  mesh.normals.resize(mesh.positions.size(), Vector3f::Zero());
  std::size_t missing = 0;
  for (const Vector3f& n : mesh.normals) missing += is_unit(n) ? 0 : 1;
  if (missing == 0) return 0;

  std::vector<Vector3f> own(mesh.positions.size(), Vector3f::Zero()), mean = own;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    for (std::size_t k = 0; k < 3; ++k) own[mesh.triangles[t + k]] += face_vector(mesh, t);
  }
  // Each corner adds its face to every side of the place that has a similar normal; a side is named by its first
  // vertex.
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (own[v].dot(own[welded[v]]) >= 0) mean[welded[v]] += own[v];
  }
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (is_unit(mesh.normals[v])) continue;
    const Vector3f& around = mean[welded[v]];
    const bool same_side = own[v].dot(around) > 0;
    const Vector3f normal = same_side ? around : own[v];
    mesh.normals[v] = normal.norm() > 0 ? Vector3f(normal.normalized()) : Vector3f(Vector3f::UnitY());
  }
  return missing;
}

}  // namespace coif::cook
