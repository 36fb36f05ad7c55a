#pragma once

#include "write/asset_writer.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

namespace coif::cook {

/// The finest level of packed hair while its edges are split. Vertices at the same place count as one, so that no gap
/// opens beside an edge, also where texture coordinates or patches end. A split changes the picture at rest by less
/// than rounding: positions, texture coordinates, normals, tangents, light and weights of a new vertex lie between
/// those of the edge's ends.
class SplitMesh {
 public:
  explicit SplitMesh(const AssetContents& contents);

  struct Triangle {
    std::array<std::uint32_t, 3> vertex;
    std::uint32_t patch;
    std::uint32_t origin;  ///< The triangle of the contents that it is a part of.
  };

  [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }
  /// Rest pose, head space, metres.
  [[nodiscard]] Eigen::Vector3f position(std::uint32_t vertex) const {
    return Eigen::Map<const Eigen::Vector3f>(vertices_[vertex].position);
  }
  /// Number of triangles at the edge between two vertices; splitting it adds as many.
  [[nodiscard]] std::size_t count_at(std::uint32_t from, std::uint32_t to) const;

  /// A triangle that was split.
  struct Halves {
    std::uint32_t kept;    ///< Index of the first half, which is the triangle's own.
    std::uint32_t added;   ///< Index of the other half, higher than all before.
    std::uint32_t tip;     ///< The vertex that both halves share besides the new one.
    std::uint32_t middle;  ///< the new one.
  };
  /// Puts a vertex on the edge, at `share` of the way (0 < share < 1), into every triangle of that edge.
  std::vector<Halves> split_edge(std::uint32_t from, std::uint32_t to, float share);

  /// Writes vertices, skin, indices and patches of the contents that this was made of; orders by direction must be none
  /// yet. Pieces of a triangle follow each other in its place. Returns for each triangle of the finest level which one
  /// it is a piece of.
  std::vector<std::uint32_t> write_to(AssetContents& contents) const;

 private:
  using Edge = std::uint64_t;  ///< Two places.

  [[nodiscard]] Edge edge_between(std::uint32_t from, std::uint32_t to) const;
  std::uint32_t place_of(const VertexRecord& vertex);
  std::uint32_t add_between(std::uint32_t from, std::uint32_t to, float share);
  void join(std::uint32_t triangle);
  void leave(std::uint32_t triangle);

  std::vector<VertexRecord> vertices_;
  std::vector<SkinRecord> skin_;
  std::vector<Triangle> triangles_;
  std::map<std::array<float, 3>, std::uint32_t> places_;
  std::vector<std::uint32_t> place_;                              ///< Place of each vertex.
  std::unordered_map<Edge, std::vector<std::uint32_t>> at_edge_;  ///< Triangles.
};

/// The patches of the finest level of detail: the first ones.
[[nodiscard]] std::size_t finest_patch_count(const AssetContents& contents);
[[nodiscard]] std::size_t finest_triangle_count(const AssetContents& contents);

}  // namespace coif::cook
