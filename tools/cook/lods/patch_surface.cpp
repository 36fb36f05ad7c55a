#include "cook/lods/patch_surface.h"

#include "base/geometry.h"
#include "cook/select/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace coif::cook {
namespace {

constexpr double kTurn = 20 * kDegree;
constexpr double kLargestTurn = 120 * kDegree;

/// Simulated bones from the root of the deepest chain to its end.
int deepest_chain(const Skeleton& skeleton) {
  std::vector<int> depth(skeleton.bones.size(), 0);
  int deepest = 0;
  for (std::size_t b = 1; b < skeleton.bones.size(); ++b) {
    if (skeleton.bones[b].kind != BoneKind::kSimulated) continue;
    depth[b] = depth[skeleton.bones[b].parent] + 1;
    deepest = std::max(deepest, depth[b]);
  }
  return deepest;
}

std::vector<Eigen::Isometry3f> turned_bones(const Skeleton& skeleton, const Eigen::Vector3d& axis, double angle) {
  std::vector<Eigen::Isometry3d> from_rest(skeleton.bones.size(), Eigen::Isometry3d::Identity());
  std::vector<Eigen::Isometry3f> result(skeleton.bones.size(), Eigen::Isometry3f::Identity());
  for (std::size_t b = 1; b < skeleton.bones.size(); ++b) {
    const SkeletonBone& bone = skeleton.bones[b];
    from_rest[b] = from_rest[bone.parent];
    if (bone.kind == BoneKind::kSimulated) {
      from_rest[b] = from_rest[b] * Eigen::Translation3d(bone.start) * Eigen::AngleAxisd(angle, axis) *
                     Eigen::Translation3d(-bone.start);
    }
    result[b] = from_rest[b].cast<float>();
  }
  return result;
}

Pose posed(const HairMesh& mesh, const SkinWeights& weights, const std::vector<Eigen::Isometry3f>& bones) {
  Pose pose(mesh.positions.size(), Eigen::Vector3f::Zero());
  for (std::size_t v = 0; v < pose.size(); ++v) {
    float sum = 0;
    for (const BoneWeight& carrier : weights[v]) {
      pose[v] += float(carrier.weight) * (bones[carrier.bone] * mesh.positions[v]);
      sum += float(carrier.weight);
    }
    pose[v] = sum > 0 ? Eigen::Vector3f(pose[v] / sum) : mesh.positions[v];
  }
  return pose;
}

}  // namespace

std::vector<Pose> bent_poses(const HairMesh& mesh, const HairRig& rig) {
  std::vector<Pose> poses = {mesh.positions};
  const int deepest = deepest_chain(rig.skeleton);
  if (deepest == 0) return poses;
  const double angle = std::min(kTurn, kLargestTurn / deepest);
  for (const Eigen::Vector3d& axis : {Eigen::Vector3d::UnitX().eval(), Eigen::Vector3d::UnitZ().eval()}) {
    poses.push_back(posed(mesh, rig.weights, turned_bones(rig.skeleton, axis, angle)));
  }
  return poses;
}

namespace {

/// For each of the patch's vertices (by its place in PatchView::vertices) its point and its corner.
struct Numbering {
  std::vector<std::uint32_t> point, corner;
  std::vector<std::uint32_t> vertex_of_point, vertex_of_corner;
};

Numbering number_vertices(const HairStrips& hair, const PatchView& view) {
  const HairMesh& mesh = hair.mesh;
  const std::vector<std::uint32_t>& place = hair.welded;
  const auto uv = [&](std::uint32_t v) {
    return mesh.uvs.empty() ? std::pair(0.0f, 0.0f) : std::pair(mesh.uvs[v].x(), mesh.uvs[v].y());
  };
  const auto key = [&](std::uint32_t i) { return std::pair(place[view.vertices[i]], uv(view.vertices[i])); };
  std::vector<std::uint32_t> order(view.vertices.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::stable_sort(order, {}, key);
  Numbering numbering;
  numbering.point.resize(order.size());
  numbering.corner.resize(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) {
    const std::uint32_t i = order[k], v = view.vertices[i];
    const bool new_point = k == 0 || place[v] != place[view.vertices[order[k - 1]]];
    const bool new_corner = new_point || uv(v) != uv(view.vertices[order[k - 1]]);
    if (new_point) numbering.vertex_of_point.push_back(v);
    if (new_corner) numbering.vertex_of_corner.push_back(v);
    numbering.point[i] = std::uint32_t(numbering.vertex_of_point.size() - 1);
    numbering.corner[i] = std::uint32_t(numbering.vertex_of_corner.size() - 1);
  }
  return numbering;
}

}  // namespace

PatchSurface make_patch_surface(const HairStrips& hair, const PatchView& view, std::span<const Pose> poses) {
  const Numbering numbering = number_vertices(hair, view);
  PatchSurface surface;
  surface.poses = poses.size();
  surface.vertex_of_corner = numbering.vertex_of_corner;
  for (const Pose& pose : poses) {
    for (std::uint32_t v : numbering.vertex_of_point) surface.positions.push_back(pose[v].cast<double>());
  }
  surface.triangles.resize(view.triangles.size());
  for (std::size_t t = 0; t < view.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t vertex = hair.mesh.triangles[view.triangles[t] + k];
      const auto i = std::size_t(std::ranges::lower_bound(view.vertices, vertex) - view.vertices.begin());
      surface.triangles[t].point[k] = numbering.point[i];
      surface.triangles[t].corner[k] = numbering.corner[i];
    }
  }
  return surface;
}

namespace {

constexpr double kCornerTurn = 50 * kDegree;

std::vector<EdgeUse> edges_by_point(const PatchSurface& surface) {
  std::vector<std::uint32_t> corners, same(surface.points());
  for (const auto& triangle : surface.triangles)
    corners.insert(corners.end(), triangle.point.begin(), triangle.point.end());
  std::iota(same.begin(), same.end(), 0u);
  return sorted_edges(corners, same);
}

/// Fixes the corners of the border: points at which it turns.
void fix_corners(const PatchSurface& surface, PatchOutline& outline) {
  std::vector<Eigen::Vector3d> arriving(surface.points(), Eigen::Vector3d::Zero()), leaving = arriving;
  std::vector<int> starts(surface.points(), 0), ends = starts;
  for (const PatchOutline::Edge& edge : outline.edges) {
    const Eigen::Vector3d along = (surface.at(0, edge.b) - surface.at(0, edge.a)).normalized();
    leaving[edge.a] = along;
    arriving[edge.b] = along;
    ++starts[edge.a];
    ++ends[edge.b];
  }
  for (std::uint32_t p = 0; p < surface.points(); ++p) {
    if (!outline.on_border[p]) continue;
    const bool simple = starts[p] == 1 && ends[p] == 1;
    if (!simple || arriving[p].dot(leaving[p]) < std::cos(kCornerTurn)) outline.fixed[p] = true;
  }
}

}  // namespace

PatchOutline find_outline(const PatchSurface& surface) {
  PatchOutline outline;
  outline.on_border.assign(surface.points(), false);
  outline.fixed.assign(surface.points(), false);
  for_each_edge(edges_by_point(surface), [&](std::span<const EdgeUse> uses) {
    const auto& points = surface.triangles[uses[0].triangle].point;
    const std::uint32_t a = points[uses[0].side], b = points[(uses[0].side + 1) % 3];
    if (uses.size() > 2) outline.fixed[a] = outline.fixed[b] = true;
    if (uses.size() != 1) return;
    outline.on_border[a] = outline.on_border[b] = true;
    outline.edges.push_back({a, b, uses[0].triangle});
  });
  fix_corners(surface, outline);
  return outline;
}

}  // namespace coif::cook
