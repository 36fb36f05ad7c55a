#pragma once

// The hair alone, cut out of its source: the data that the passes of a cook hand on.

#include "import/source_model.h"

#include <Eigen/Geometry>

#include <cstdint>
#include <span>
#include <vector>

namespace coif::cook {

/// A triangle mesh, model space, metres. Per-vertex arrays have the size of `positions`, or are empty.
struct HairMesh {
  std::vector<Eigen::Vector3f> positions;
  std::vector<Eigen::Vector3f> normals;
  std::vector<Eigen::Vector2f> uvs;
  std::vector<Eigen::Vector4f> colors;                ///< Linear RGBA, until a texture or a factor has them.
  std::vector<std::uint32_t> influence_begin;         ///< positions.size() + 1 entries.
  std::vector<importer::SourceInfluence> influences;  ///< Nodes of the source; each vertex's weights add up to one.
  std::vector<std::uint32_t> triangles;               ///< Three vertices each.
  std::vector<std::uint32_t> mesh_of_triangle;        ///< The source mesh that each triangle comes from.
  bool double_sided = false;                          ///< Both sides of every triangle are hair.
  std::vector<std::uint32_t> source_meshes;           ///< The meshes that gave triangles.
  std::uint32_t material = importer::kNoIndex;        ///< The source's material with most triangles.

  [[nodiscard]] std::size_t triangle_count() const { return triangles.size() / 3; }
  [[nodiscard]] Eigen::AlignedBox3d box() const {
    Eigen::AlignedBox3d box;
    for (const Eigen::Vector3f& p : positions) box.extend(p.cast<double>());
    return box;
  }
  /// Position of a triangle's corner, 0..2.
  [[nodiscard]] const Eigen::Vector3f& corner(std::size_t triangle, std::size_t k) const {
    return positions[triangles[3 * triangle + k]];
  }
  /// Appends a vertex like one of a mesh with the same attributes, which may be this one. Returns its index.
  std::uint32_t append_vertex(const HairMesh& from, std::uint32_t vertex) {
    positions.push_back(Eigen::Vector3f(from.positions[vertex]));
    if (!from.normals.empty()) normals.push_back(Eigen::Vector3f(from.normals[vertex]));
    if (!from.uvs.empty()) uvs.push_back(Eigen::Vector2f(from.uvs[vertex]));
    if (!from.colors.empty()) colors.push_back(Eigen::Vector4f(from.colors[vertex]));
    for (std::uint32_t k = from.influence_begin[vertex]; k < from.influence_begin[vertex + 1]; ++k) {
      influences.push_back(importer::SourceInfluence(from.influences[k]));
    }
    influence_begin.push_back(std::uint32_t(influences.size()));
    return std::uint32_t(positions.size() - 1);
  }

  [[nodiscard]] std::span<const importer::SourceInfluence> influences_of(std::uint32_t vertex) const {
    return std::span(influences)
        .subspan(influence_begin[vertex], influence_begin[vertex + 1] - influence_begin[vertex]);
  }
};

/// The patches of the triangles: `patch_of[t]` for each triangle, numbered by first appearance.
struct PatchSet {
  std::vector<std::uint32_t> patch_of;
  std::uint32_t count = 0;
  std::vector<std::uint32_t> first_number{};  ///< Per patch, see number_of(); empty: numbers are indices.
  /// The last patches are drawn only by coarser levels of detail: for each, the patch of the finest level that it
  /// replaces.
  std::vector<std::uint32_t> stands_for{};

  /// A patch's number for people: its index before patches were left out or cut.
  [[nodiscard]] std::uint32_t number_of(std::uint32_t patch) const {
    return first_number.empty() ? patch : first_number[patch];
  }
  /// Appends a patch that is a part of another one. Returns its index.
  std::uint32_t add_part_of(std::uint32_t patch) {
    if (first_number.empty()) {
      for (std::uint32_t p = 0; p < count; ++p) first_number.push_back(p);
    }
    first_number.push_back(std::uint32_t(first_number[patch]));
    return count++;
  }
  /// Cuts patches. `part_of` has for each triangle its part, a number below the count of triangles, and no part spans
  /// two patches; kNoIndex: its patch stays whole. The first part of each patch keeps its index, the others get new
  /// ones.
  void cut(std::span<const std::uint32_t> part_of) {
    std::vector<std::uint32_t> index(patch_of.size(), importer::kNoIndex);
    std::vector<bool> kept(count, false);
    for (std::size_t t = 0; t < patch_of.size(); ++t) {
      if (part_of[t] == importer::kNoIndex) continue;
      std::uint32_t& patch = patch_of[t];
      std::uint32_t& part = index[part_of[t]];
      if (part == importer::kNoIndex) {
        part = kept[patch] ? add_part_of(patch) : patch;
        if (part == patch) kept[patch] = true;
      }
      patch = part;
    }
  }
};

}  // namespace coif::cook
