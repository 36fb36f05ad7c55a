#include "cook/select/mesh_topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <map>
#include <tuple>
#include <unordered_map>

namespace coif::cook {
namespace {

struct Cell {
  std::int64_t x, y, z;
  bool operator==(const Cell&) const = default;
};

Cell cell_of(const Eigen::Vector3d& position, double size) {
  constexpr double kFarthest = 1.0e15;  // beyond, all is one cell, rather than overflow
  const auto index = [&](double v) { return std::int64_t(std::clamp(std::floor(v / size), -kFarthest, kFarthest)); };
  return {index(position.x()), index(position.y()), index(position.z())};
}

/// The vertices of each cell: a linked list for each, in a table with open addressing. A cook welds every vertex
/// several times, and most cells hold one.
class CellTable {
 public:
  explicit CellTable(std::size_t vertices)
      : slots_(std::bit_ceil(2 * vertices + 1)), next_(vertices, importer::kNoIndex), mask_(slots_.size() - 1) {}

  void add(const Cell& cell, std::uint32_t vertex) {
    Slot& slot = slots_[slot_of(cell)];
    slot.cell = cell;
    next_[vertex] = slot.first;
    slot.first = vertex;
  }

  template <typename Visit>
  void for_each_in(const Cell& cell, const Visit& visit) const {
    for (std::uint32_t v = slots_[slot_of(cell)].first; v != importer::kNoIndex; v = next_[v]) visit(v);
  }

 private:
  struct Slot {
    Cell cell{};
    std::uint32_t first = importer::kNoIndex;
  };

  [[nodiscard]] std::size_t slot_of(const Cell& cell) const {
    std::uint64_t hash = 0;
    for (std::int64_t k : {cell.x, cell.y, cell.z}) {
      hash = (hash ^ std::uint64_t(k)) * 0x9E3779B97F4A7C15u;
      hash ^= hash >> 32;
    }
    std::size_t slot = hash & mask_;
    while (slots_[slot].first != importer::kNoIndex && slots_[slot].cell != cell) slot = (slot + 1) & mask_;
    return slot;
  }

  std::vector<Slot> slots_;
  std::vector<std::uint32_t> next_;
  std::size_t mask_;
};

constexpr double kWeldShare = 2.0e-5;  ///< Far above single precision, far below what artists model.

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
  if (!mesh.colors.empty()) {
    for (int k = 0; k < 4; ++k) append(mesh.colors[v][k]);
  }
  for (const importer::SourceInfluence& influence : mesh.influences_of(v)) {
    key.append(reinterpret_cast<const char*>(&influence.node), sizeof influence.node);
    append(influence.weight);
  }
  return key;
}

}  // namespace

std::vector<std::uint32_t> weld_places(std::span<const Eigen::Vector3f> positions, double distance) {
  const double diagonal = diagonal_of(positions);
  const double reach = std::max(distance > 0 ? distance : kWeldShare * diagonal, 1.0e-7);
  const auto limit = float(reach * reach);
  // Cells wide enough that neighbours mostly lie in one, and too small to hold many vertices of a surface.
  const double spacing = diagonal / std::sqrt(double(positions.size()) + 1);
  const double side = std::max(reach, std::min(8 * reach, spacing / 4));
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(1.0001 * reach);  // more than the distance's rounding
  CellTable cells(positions.size());
  DisjointSets sets(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    const Eigen::Vector3d at = positions[v].cast<double>();
    const Cell low = cell_of(at - margin, side), high = cell_of(at + margin, side);
    bool is_copy = false;
    const auto join = [&](std::uint32_t other) {
      if ((positions[v] - positions[other]).squaredNorm() <= limit) sets.unite(v, other);
      is_copy = is_copy || positions[v] == positions[other];
    };
    for (Cell c = low; c.x <= high.x; ++c.x) {
      for (c.y = low.y; c.y <= high.y; ++c.y) {
        for (c.z = low.z; c.z <= high.z; ++c.z) cells.for_each_in(c, join);
      }
    }
    // Exact copies add nothing that the first one does not: without them a cell stays small.
    if (!is_copy) cells.add(cell_of(at, side), v);
  }
  std::vector<std::uint32_t> first(positions.size(), importer::kNoIndex), place(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v) {
    std::uint32_t& representative = first[sets.find(v)];
    if (representative == importer::kNoIndex) representative = v;
    place[v] = representative;
  }
  return place;
}

void weld_vertices(HairMesh& mesh) {
  HairMesh welded;
  welded.material = mesh.material;
  welded.double_sided = mesh.double_sided;
  welded.mesh_of_triangle = std::move(mesh.mesh_of_triangle);
  welded.source_meshes = std::move(mesh.source_meshes);
  welded.influence_begin.push_back(0);
  welded.triangles.reserve(mesh.triangles.size());
  std::unordered_map<std::string, std::uint32_t> seen;
  seen.reserve(mesh.positions.size());
  for (std::uint32_t v : mesh.triangles) {
    const auto [entry, is_new] = seen.try_emplace(vertex_key(mesh, v), std::uint32_t(welded.positions.size()));
    if (is_new) welded.append_vertex(mesh, v);
    welded.triangles.push_back(entry->second);
  }
  mesh = std::move(welded);
}

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

namespace {

/// Triangles that share an id at a corner.
MeshPieces joined_by(const importer::SourceMesh& mesh, std::span<const std::uint32_t> id_of) {
  DisjointSets sets(mesh.positions.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    sets.unite(id_of[mesh.triangles[t]], id_of[mesh.triangles[t + 1]]);
    sets.unite(id_of[mesh.triangles[t]], id_of[mesh.triangles[t + 2]]);
  }
  MeshPieces pieces;
  std::vector<std::uint32_t> number(mesh.positions.size(), importer::kNoIndex);
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 3) {
    std::uint32_t& piece = number[sets.find(id_of[mesh.triangles[t]])];
    if (piece == importer::kNoIndex) piece = pieces.count++;
    pieces.piece_of.push_back(piece);
  }
  return pieces;
}

}  // namespace

MeshPieces find_pieces(const importer::SourceMesh& mesh, double weld_distance) {
  return joined_by(mesh, weld_places(mesh.positions, weld_distance));
}

MeshPieces find_islands(const importer::SourceMesh& mesh, double weld_distance) {
  std::vector<std::uint32_t> id_of = weld_places(mesh.positions, weld_distance);
  std::map<std::tuple<std::uint32_t, float, float>, std::uint32_t> first_at;
  for (std::uint32_t v = 0; v < mesh.uvs.size(); ++v) {
    id_of[v] = first_at.try_emplace({id_of[v], mesh.uvs[v].x(), mesh.uvs[v].y()}, v).first->second;
  }
  return joined_by(mesh, id_of);
}

}  // namespace coif::cook
