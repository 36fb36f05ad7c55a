#include "cook/weld.h"

#include "cook/disjoint_sets.h"
#include "payload_hash.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <unordered_map>

namespace coif {
namespace {

struct Cell {
  std::int64_t x, y, z;
  bool operator==(const Cell&) const = default;
};

struct CellHash {
  std::size_t operator()(const Cell& cell) const { return std::size_t(xxh64(std::as_bytes(std::span(&cell, 1)))); }
};

Cell cell_of(const Eigen::Vector3f& position, double size) {
  constexpr double kFarthest = 1.0e15;  // beyond, all is one cell, rather than overflow
  const auto index = [&](float v) {
    return std::int64_t(std::clamp(std::floor(double(v) / size), -kFarthest, kFarthest));
  };
  return {index(position.x()), index(position.y()), index(position.z())};
}

constexpr double kWeldShare = 2.0e-5;  ///< Far above single precision, far below what an artist models.

double diagonal_of(std::span<const Eigen::Vector3f> positions) {
  Eigen::AlignedBox3f box;
  for (const Eigen::Vector3f& p : positions) box.extend(p);
  return positions.empty() ? 0 : double(box.diagonal().norm());
}

/// The attributes of one vertex as bytes, -0 written as 0.
std::string vertex_key(const HairMesh& mesh, std::uint32_t v) {
  std::string key;
  const auto append = [&](float value) {
    value += 0.0f;
    key.append(reinterpret_cast<const char*>(&value), sizeof value);
  };
  for (int k = 0; k < 3; ++k) append(mesh.positions[v][k]);
  if (!mesh.normals.empty()) {
    for (int k = 0; k < 3; ++k) append(mesh.normals[v][k]);
  }
  if (!mesh.uvs.empty()) {
    for (int k = 0; k < 2; ++k) append(mesh.uvs[v][k]);
  }
  for (const SourceInfluence& influence : mesh.influences_of(v)) {
    key.append(reinterpret_cast<const char*>(&influence.node), sizeof influence.node);
    append(influence.weight);
  }
  return key;
}

/// Appends vertex `v` of `from` to `to`.
void copy_vertex(const HairMesh& from, std::uint32_t v, HairMesh& to) {
  to.positions.push_back(from.positions[v]);
  if (!from.normals.empty()) to.normals.push_back(from.normals[v]);
  if (!from.uvs.empty()) to.uvs.push_back(from.uvs[v]);
  const auto influences = from.influences_of(v);
  to.influences.insert(to.influences.end(), influences.begin(), influences.end());
  to.influence_begin.push_back(std::uint32_t(to.influences.size()));
}

}  // namespace

std::vector<std::uint32_t> weld_places(std::span<const Eigen::Vector3f> positions, double distance) {
  // Cells of the weld distance: neighbours within it lie in the same or an adjacent cell.
  const double size = std::max(distance > 0 ? distance : kWeldShare * diagonal_of(positions), 1.0e-7);
  const float limit = float(size * size);
  std::unordered_map<Cell, std::vector<std::uint32_t>, CellHash> cells;
  cells.reserve(positions.size());
  DisjointSets sets(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const Cell home = cell_of(positions[v], size);
    for (int n = 0; n < 27; ++n) {
      const auto found = cells.find({home.x + n % 3 - 1, home.y + n / 3 % 3 - 1, home.z + n / 9 - 1});
      if (found == cells.end()) continue;
      for (std::uint32_t other : found->second) {
        if ((positions[v] - positions[other]).squaredNorm() <= limit) sets.unite(v, other);
      }
    }
    // Exact copies add nothing that the first one does not: without them a cell stays small.
    auto& mine = cells[home];
    bool copy = false;
    for (std::uint32_t other : mine) copy = copy || positions[other] == positions[v];
    if (!copy) mine.push_back(v);
  }
  std::vector<std::uint32_t> first(positions.size(), kNoIndex), place(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    std::uint32_t& representative = first[sets.find(v)];
    if (representative == kNoIndex) representative = v;
    place[v] = representative;
  }
  return place;
}

void weld_vertices(HairMesh& mesh) {
  HairMesh welded;
  welded.material = mesh.material;
  welded.double_sided = mesh.double_sided;
  welded.mesh_of_triangle = std::move(mesh.mesh_of_triangle);
  welded.influence_begin.push_back(0);
  welded.triangles.reserve(mesh.triangles.size());
  std::unordered_map<std::string, std::uint32_t> seen;
  seen.reserve(mesh.positions.size());
  for (std::uint32_t v : mesh.triangles) {
    const auto [entry, is_new] = seen.try_emplace(vertex_key(mesh, v), std::uint32_t(welded.positions.size()));
    if (is_new) copy_vertex(mesh, v, welded);
    welded.triangles.push_back(entry->second);
  }
  mesh = std::move(welded);
}

}  // namespace coif
