#include "cook/strands/strand_evidence.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <unordered_map>

namespace coif::cook {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

constexpr float kMostFlat = 0.3f;  ///< Share of a patch's area that may be in one spot of the texture.

/// The patch's places joined by the sides of its triangles.
class SurfaceGraph {
 public:
  SurfaceGraph(const HairStrips& hair, const PatchView& patch) {
    for (std::uint32_t v : patch.vertices) {
      const auto [entry, is_new] = node_of_place_.try_emplace(hair.welded[v], std::uint32_t(points_.size()));
      if (is_new) points_.push_back(hair.mesh.positions[v]);
      node_of_vertex_.push_back(entry->second);
    }
    neighbours_.resize(points_.size());
    for (std::size_t t : patch.triangles) {
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t a = node_of_place_.at(hair.welded[hair.mesh.triangles[t + k]]);
        const std::uint32_t b = node_of_place_.at(hair.welded[hair.mesh.triangles[t + (k + 1) % 3]]);
        neighbours_[a].push_back(b);
        neighbours_[b].push_back(a);
      }
    }
  }

  [[nodiscard]] std::vector<float> distances_from(std::uint32_t start) const {
    return distances_from(std::vector<std::uint32_t>{start});
  }

  /// Shortest way along sides from any of `starts` to each node, metres (Dijkstra).
  [[nodiscard]] std::vector<float> distances_from(const std::vector<std::uint32_t>& starts) const {
    std::vector<float> distance(points_.size(), std::numeric_limits<float>::infinity());
    using Entry = std::pair<float, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    for (const std::uint32_t start : starts) {
      distance[start] = 0;
      open.emplace(0.0f, start);
    }
    while (!open.empty()) {
      const auto [at, node] = open.top();
      open.pop();
      if (at > distance[node]) continue;
      for (std::uint32_t next : neighbours_[node]) {
        const float further = at + (points_[next] - points_[node]).norm();
        if (further >= distance[next]) continue;
        distance[next] = further;
        open.emplace(further, next);
      }
    }
    // A patch by position may hold pieces that only share a place with each other through others.
    for (float& d : distance) d = std::isfinite(d) ? d : 0;
    return distance;
  }

  /// The highest `share` of the patch's height.
  [[nodiscard]] std::vector<std::uint32_t> top(float share) const {
    const auto height = [](const Vector3f& p) { return p.y(); };
    const auto [low, high] = std::ranges::minmax(points_, {}, height);
    std::vector<std::uint32_t> nodes;
    for (std::uint32_t n = 0; n < points_.size(); ++n) {
      if (points_[n].y() >= high.y() - share * (high.y() - low.y())) nodes.push_back(n);
    }
    return nodes;
  }

  [[nodiscard]] std::uint32_t node_of(std::size_t vertex_in_view) const { return node_of_vertex_[vertex_in_view]; }

 private:
  std::unordered_map<std::uint32_t, std::uint32_t> node_of_place_;
  std::vector<std::uint32_t> node_of_vertex_;
  std::vector<Vector3f> points_;
  std::vector<std::vector<std::uint32_t>> neighbours_;
};

std::uint32_t farthest(std::span<const float> distances) {
  return std::uint32_t(std::ranges::max_element(distances) - distances.begin());
}

/// Between the two ends that are farthest apart: how much nearer to the first than to the second.
std::vector<float> walked_coordinate(const HairStrips& hair, const PatchView& patch) {
  const SurfaceGraph graph(hair, patch);
  const std::uint32_t first = farthest(graph.distances_from(0));
  const std::vector<float> from_first = graph.distances_from(first);
  const std::vector<float> from_last = graph.distances_from(farthest(from_first));
  std::vector<float> coordinate;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    coordinate.push_back(from_first[graph.node_of(i)] - from_last[graph.node_of(i)]);
  }
  return coordinate;
}

/// Mean position of the vertices in each of `count` equal ranges of the coordinate; ranges without any are left out.
std::vector<Vector3f> centre_line(const HairMesh& mesh, const PatchView& patch, std::span<const float> coordinate,
                                  std::size_t count) {
  const auto [low, high] = std::ranges::minmax(coordinate);
  const float scale = float(count) / std::max(high - low, 1.0e-12f);
  std::vector<Vector3f> sums(count, Vector3f::Zero());
  std::vector<float> counts(count, 0.0f);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    const std::size_t bin = std::min(count - 1, std::size_t((coordinate[i] - low) * scale));
    sums[bin] += mesh.positions[patch.vertices[i]];
    counts[bin] += 1;
  }
  std::vector<Vector3f> line;
  for (std::size_t bin = 0; bin < count; ++bin) {
    if (counts[bin] > 0) line.push_back(sums[bin] / counts[bin]);
  }
  return line;
}

/// Length along the line to its nearest point to `p`; beyond its ends the line continues straight.
float length_along(std::span<const Vector3f> line, const Vector3f& p) {
  float best = std::numeric_limits<float>::infinity(), result = 0, before = 0;
  for (std::size_t k = 0; k + 1 < line.size(); ++k) {
    const Vector3f way = line[k + 1] - line[k];
    const float length = way.norm();
    float at = length > 0 ? way.dot(p - line[k]) / length : 0;
    if (k > 0) at = std::max(at, 0.0f);
    if (k + 2 < line.size()) at = std::min(at, length);
    const float distance = (p - line[k] - way * (length > 0 ? at / length : 0)).squaredNorm();
    if (distance < best) {
      best = distance;
      result = before + at;
    }
    before += length;
  }
  return result;
}

/// Ways along sides follow the diagonals of quads. Measured along the line through the middles of points at equal
/// distance, the rows of a strip are level.
void level_rows(const HairMesh& mesh, const PatchView& patch, std::vector<float>& coordinate) {
  constexpr std::size_t kFewest = 2, kMost = 16, kPerBin = 6;
  constexpr int kRounds = 4;
  const std::size_t bins = std::clamp(patch.vertices.size() / kPerBin, kFewest, kMost);
  for (int round = 0; round < kRounds; ++round) {
    const std::vector<Vector3f> line = centre_line(mesh, patch, coordinate, bins);
    if (line.size() < 2) return;
    for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
      coordinate[i] = length_along(line, mesh.positions[patch.vertices[i]]);
    }
  }
}

void scale_to_unit(std::vector<float>& values) {
  const auto [low, high] = std::ranges::minmax(values);
  const float range = std::max(high - low, 1.0e-12f);
  for (float& value : values) value = (value - low) / range;
}

}  // namespace

StrandAxis falling_axis(const HairStrips& hair, const PatchView& patch) {
  constexpr float kTop = 0.08f;
  const SurfaceGraph graph(hair, patch);
  const std::vector<float> from_top = graph.distances_from(graph.top(kTop));
  StrandAxis axis;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) axis.coordinate.push_back(from_top[graph.node_of(i)]);
  scale_to_unit(axis.coordinate);
  return axis;
}

std::array<Vector3f, 2> texture_axes(const HairMesh& mesh, std::size_t t) {
  const std::uint32_t a = mesh.triangles[t], b = mesh.triangles[t + 1], c = mesh.triangles[t + 2];
  const Vector3f e1 = mesh.positions[b] - mesh.positions[a], e2 = mesh.positions[c] - mesh.positions[a];
  const Vector2f d1 = mesh.uvs[b] - mesh.uvs[a], d2 = mesh.uvs[c] - mesh.uvs[a];
  const float determinant = d1.x() * d2.y() - d2.x() * d1.y();
  if (std::abs(determinant) < 1.0e-12f) return {Vector3f::Zero(), Vector3f::Zero()};
  return {(e1 * d2.y() - e2 * d1.y()) / determinant, (e2 * d1.x() - e1 * d2.x()) / determinant};
}

float texture_preference(const HairMesh& mesh, const PatchView& patch) {
  if (mesh.uvs.empty()) return 0;
  Eigen::AlignedBox2f range;
  for (std::uint32_t v : patch.vertices) range.extend(mesh.uvs[v]);
  std::array<float, 2> length{0, 0};
  float mapped = 0, flat = 0;
  for (std::size_t t : patch.triangles) {
    const auto axes = texture_axes(mesh, t);
    const float area = doubled_area(mesh, t);
    if (axes[0].isZero() && axes[1].isZero()) {
      flat += area;
      continue;
    }
    for (std::size_t k = 0; k < 2; ++k) length[k] += axes[k].norm() * range.sizes()[Eigen::Index(k)] * area;
    mapped += area;
  }
  if (mapped <= 0 || flat > kMostFlat * (mapped + flat)) return 0;
  // Never quite zero, which would mean that there are no coordinates.
  const float difference = (length[1] - length[0]) / (length[1] + length[0]);
  return difference >= 0 ? std::max(difference, 1.0e-6f) : difference;
}

Vector3f gradient(const HairMesh& mesh, std::size_t t, std::span<const float> coordinate) {
  const Vector3f& a = mesh.positions[mesh.triangles[t]];
  const Vector3f e1 = mesh.positions[mesh.triangles[t + 1]] - a, e2 = mesh.positions[mesh.triangles[t + 2]] - a;
  const Vector3f normal = e1.cross(e2);
  const float square = normal.squaredNorm();
  if (!(square > 0)) return Vector3f::Zero();
  const float d1 = coordinate[mesh.triangles[t + 1]] - coordinate[mesh.triangles[t]];
  const float d2 = coordinate[mesh.triangles[t + 2]] - coordinate[mesh.triangles[t]];
  return (e2.cross(normal) * d1 + normal.cross(e1) * d2) / square;
}

StrandAxis strand_axis(const HairStrips& hair, const PatchView& patch, int texture_axis) {
  StrandAxis axis;
  axis.texture_axis = texture_axis;
  if (texture_axis < 0) {
    axis.coordinate = walked_coordinate(hair, patch);
    level_rows(hair.mesh, patch, axis.coordinate);
  } else {
    for (std::uint32_t v : patch.vertices) axis.coordinate.push_back(hair.mesh.uvs[v][texture_axis]);
  }
  scale_to_unit(axis.coordinate);
  return axis;
}

}  // namespace coif::cook
