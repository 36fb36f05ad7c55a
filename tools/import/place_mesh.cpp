#include "import/raw_mesh.h"

#include "base/text.h"
#include "import/source_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

namespace coif::importer {
namespace {

// Metres. A vertex farther out is damage (assimp reads past short arrays of a COLLADA file), not a model. Assets allow
// ten times that, so every distance between vertices fits.
constexpr float kFarthestVertex = 1e4f;
// Repeats of a texture. A strip with that many has no texels left between two of its vertices. Also rejects NaN.
constexpr float kFarthestUv = 1e4f;

bool usable(const Eigen::Vector3f& position) {
  return position.allFinite() && position.cwiseAbs().maxCoeff() <= kFarthestVertex;
}

struct PlacedVertices {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;  // zero where the file's is unusable
  std::vector<bool> mirrored;            // the vertex's transform turns the surface inside out
};

// Normals are transformed by the inverse transpose. The cofactor matrix is that times the determinant, and exists even
// if that is zero.
Eigen::Vector3f place_normal(const Eigen::Matrix3d& linear, const Eigen::Vector3d& normal) {
  Eigen::Matrix3d cofactor;
  cofactor << linear.col(1).cross(linear.col(2)), linear.col(2).cross(linear.col(0)),
      linear.col(0).cross(linear.col(1));
  const double sign = linear.determinant() < 0 ? -1.0 : 1.0;
  const Eigen::Vector3d placed = sign * (cofactor * normal);
  const double length = placed.norm();
  if (!(length > 0) || !std::isfinite(length)) return Eigen::Vector3f::Zero();
  return (placed / length).cast<float>();
}

PlacedVertices place_vertices(const RawMesh& mesh, const SkinBinding& binding) {
  PlacedVertices out;
  out.positions.reserve(mesh.positions.size());
  out.mirrored.reserve(mesh.positions.size());
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Eigen::Affine3d model_from_mesh = binding.model_from_mesh(v);
    out.positions.push_back((model_from_mesh * mesh.positions[v].cast<double>()).cast<float>());
    out.mirrored.push_back(model_from_mesh.linear().determinant() < 0);
    if (!mesh.normals.empty())
      out.normals.push_back(place_normal(model_from_mesh.linear(), mesh.normals[v].cast<double>()));
  }
  return out;
}

// The file's triangles that can be used, wound counter-clockwise after placement.
std::vector<std::uint32_t> usable_triangles(const RawMesh& mesh, const PlacedVertices& placed, const std::string& label,
                                            Diagnostics& warnings) {
  std::vector<std::uint32_t> triangles;
  std::size_t out_of_range = 0;
  std::size_t misplaced = 0;
  std::uint32_t first_misplaced = kNoIndex;
  for (std::size_t i = 0; i + 2 < mesh.triangles.size(); i += 3) {
    std::uint32_t corner[3] = {mesh.triangles[i], mesh.triangles[i + 1], mesh.triangles[i + 2]};
    if (std::ranges::any_of(corner, [&](std::uint32_t v) { return v >= placed.positions.size(); })) {
      ++out_of_range;
    } else if (const auto* const bad =
                   std::ranges::find_if(corner, [&](std::uint32_t v) { return !usable(placed.positions[v]); });
               bad != std::end(corner)) {
      if (misplaced++ == 0) first_misplaced = *bad;
    } else {
      const auto mirrored = std::ranges::count_if(corner, [&](std::uint32_t v) { return placed.mirrored[v]; });
      if (mirrored >= 2) std::swap(corner[1], corner[2]);
      triangles.insert(triangles.end(), corner, corner + 3);
    }
  }
  warn_count(warnings, source_code::kRepaired, out_of_range, label, "triangles dropped: vertex index out of range");
  if (misplaced != 0) {
    const Eigen::Vector3f& at = placed.positions[first_misplaced];
    warn(warnings, source_code::kRepaired,
         "{}: {} triangles dropped: vertex {} stands at ({:g}, {:g}, {:g}) m, and {:g} m is the "
         "farthest; move or delete it and export again",
         label, misplaced, first_misplaced, at.x(), at.y(), at.z(), kFarthestVertex);
  }
  return triangles;
}

// Files share one vertex buffer between primitives; only the vertices that the triangles use belong to this mesh.
// Rewrites `triangles` to the new numbers and returns the old number of each kept vertex, in ascending order.
std::vector<std::uint32_t> keep_used_vertices(std::vector<std::uint32_t>& triangles, std::size_t vertex_count) {
  std::vector<std::uint32_t> renumbered(vertex_count, kNoIndex);
  for (const std::uint32_t v : triangles) renumbered[v] = 0;
  std::vector<std::uint32_t> kept;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    if (renumbered[v] == kNoIndex) continue;
    renumbered[v] = static_cast<std::uint32_t>(kept.size());
    kept.push_back(v);
  }
  for (std::uint32_t& v : triangles) v = renumbered[v];
  return kept;
}

void copy_uvs(const RawMesh& mesh, std::span<const std::uint32_t> kept, const std::string& label, SourceMesh& out,
              Diagnostics& warnings) {
  if (mesh.uvs.empty()) return;
  std::size_t unusable = 0;
  std::string first;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    Eigen::Vector2f uv = mesh.uvs[kept[i]];
    // Not the maximum, which Eigen may take of a number and NaN as the number.
    if (!uv.allFinite() || uv.cwiseAbs().maxCoeff() > kFarthestUv) {
      const Eigen::Vector3f& at = out.positions[i];
      if (unusable++ == 0) {
        first = fmt::format("vertex {} at ({:.4g}, {:.4g}, {:.4g}) m has ({:g}, {:g}), V from the top", kept[i], at.x(),
                            at.y(), at.z(), uv.x(), uv.y());
      }
      uv.setZero();
    }
    out.uvs.push_back(uv);
  }
  if (unusable != 0) {
    warn(warnings, source_code::kUvs,
         "{}: {} UVs set to (0, 0): {}, and {:g} repeats are the most; unwrap it anew and export "
         "again",
         label, unusable, first, kFarthestUv);
  }
}

// Colours that are all white and opaque carry no information.
void copy_colors(const RawMesh& mesh, std::span<const std::uint32_t> kept, const std::string& label, SourceMesh& out,
                 Diagnostics& warnings) {
  if (mesh.colors.empty()) return;
  std::size_t unusable = 0;
  for (const std::uint32_t v : kept) {
    const Eigen::Vector4f& color = mesh.colors[v];
    unusable += color.allFinite() ? 0 : 1;
    out.colors.push_back(color.allFinite() ? Eigen::Vector4f(color.cwiseMax(0.0f)) : Eigen::Vector4f::Ones());
  }
  warn_count(warnings, source_code::kRepaired, unusable, label, "vertex colours that are no numbers taken for white");
  if (std::ranges::all_of(out.colors, [](const Eigen::Vector4f& color) { return color == Eigen::Vector4f::Ones(); }))
    out.colors.clear();
}

void copy_influences(const SkinBinding& binding, std::span<const std::uint32_t> kept, SourceMesh& out) {
  if (!binding.skinned()) return;
  out.influence_begin.push_back(0);
  for (const std::uint32_t v : kept) {
    const auto influences = binding.influences(v);
    out.influences.insert(out.influences.end(), influences.begin(), influences.end());
    out.influence_begin.push_back(static_cast<std::uint32_t>(out.influences.size()));
  }
}

// Unusable normals are taken from the surface, or point up where that has none.
void repair_normals(SourceMesh& mesh, const std::string& label, Diagnostics& warnings) {
  std::vector<Eigen::Vector3f> surface(mesh.normals.size(), Eigen::Vector3f::Zero());
  for (std::size_t i = 0; i < mesh.triangles.size() && !surface.empty(); i += 3) {
    const std::uint32_t* corner = &mesh.triangles[i];
    const Eigen::Vector3f& origin = mesh.positions[corner[0]];
    const Eigen::Vector3f area = (mesh.positions[corner[1]] - origin).cross(mesh.positions[corner[2]] - origin);
    for (int k = 0; k < 3; ++k) surface[corner[k]] += area;
  }
  std::size_t repaired = 0;
  for (std::size_t v = 0; v < mesh.normals.size(); ++v) {
    if (!mesh.normals[v].isZero(0)) continue;
    const float length = surface[v].stableNorm();
    mesh.normals[v] = std::isnormal(length) ? Eigen::Vector3f(surface[v] / length) : Eigen::Vector3f::UnitY();
    ++repaired;
  }
  warn_count(warnings, source_code::kRepaired, repaired, label, "unusable normals replaced");
}

}  // namespace

SourceMesh place_mesh(const RawMesh& mesh, std::uint32_t node, std::span<const SourceNode> nodes,
                      Diagnostics& warnings) {
  SourceMesh out;
  out.name = mesh.name.empty() ? nodes[node].name : mesh.name;
  out.node = node;
  out.material = mesh.material;
  const std::string label = fmt::format("mesh '{}'", out.name);
  const SkinBinding binding(mesh, node, nodes, label, warnings);
  const PlacedVertices placed = place_vertices(mesh, binding);
  out.triangles = usable_triangles(mesh, placed, label, warnings);
  const std::vector<std::uint32_t> kept = keep_used_vertices(out.triangles, placed.positions.size());
  for (const std::uint32_t v : kept) {
    out.positions.push_back(placed.positions[v]);
    if (!placed.normals.empty()) out.normals.push_back(placed.normals[v]);
  }
  copy_uvs(mesh, kept, label, out, warnings);
  copy_colors(mesh, kept, label, out, warnings);
  copy_influences(binding, kept, out);
  repair_normals(out, label, warnings);
  measure_pose(mesh, nodes, out);
  return out;
}

void keep_mesh(const RawMesh& raw, SourceMesh placed, std::vector<SourceMesh>& meshes, Diagnostics& warnings) {
  if (raw.points_and_lines != 0) {
    warn(warnings, source_code::kLoose, "mesh '{}': {} points or lines left out", placed.name, raw.points_and_lines);
  }
  if (!placed.triangles.empty())
    meshes.push_back(std::move(placed));
  else if (raw.points_and_lines == 0)
    warn(warnings, source_code::kRepaired, "mesh '{}' left out: it has no triangles", placed.name);
}

}  // namespace coif::importer
