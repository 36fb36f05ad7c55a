#include "cook/strand_direction.h"

#include "cook/parallel_for.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>

namespace coif {
namespace {

using Eigen::Vector2f;
using Eigen::Vector3f;

struct PatchView {
  std::vector<std::size_t> triangles;   ///< First index of each.
  std::vector<std::uint32_t> vertices;  ///< Ascending, each once.
};

std::vector<PatchView> split(const HairMesh& mesh, const PatchSet& patches) {
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

/// Direction of growth of U and V over one triangle: dp/du and dp/dv, metres per texture; zero without an inverse.
std::array<Vector3f, 2> texture_axes(const HairMesh& mesh, std::size_t t) {
  const std::uint32_t a = mesh.triangles[t], b = mesh.triangles[t + 1], c = mesh.triangles[t + 2];
  const Vector3f e1 = mesh.positions[b] - mesh.positions[a], e2 = mesh.positions[c] - mesh.positions[a];
  const Vector2f d1 = mesh.uvs[b] - mesh.uvs[a], d2 = mesh.uvs[c] - mesh.uvs[a];
  const float determinant = d1.x() * d2.y() - d2.x() * d1.y();
  if (std::abs(determinant) < 1.0e-12f) return {Vector3f::Zero(), Vector3f::Zero()};
  return {(e1 * d2.y() - e2 * d1.y()) / determinant, (e2 * d1.x() - e1 * d2.x()) / determinant};
}

float area(const HairMesh& mesh, std::size_t t) {
  const Vector3f& a = mesh.positions[mesh.triangles[t]];
  return (mesh.positions[mesh.triangles[t + 1]] - a).cross(mesh.positions[mesh.triangles[t + 2]] - a).norm();
}

/// The patch's longest direction through its vertices.
Vector3f principal_axis(const HairMesh& mesh, const PatchView& patch) {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (std::uint32_t v : patch.vertices) mean += mesh.positions[v].cast<double>() / double(patch.vertices.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (std::uint32_t v : patch.vertices) {
    const Eigen::Vector3d d = mesh.positions[v].cast<double>() - mean;
    covariance += d * d.transpose();
  }
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(covariance).eigenvectors().col(2).cast<float>();
}

/// 0 or 1: the texture axis along which the patch is longer, in metres; -1 where texture coordinates are of no use.
int texture_axis_of_strands(const HairMesh& mesh, const PatchView& patch) {
  if (mesh.uvs.empty()) return -1;
  Eigen::AlignedBox2f range;
  for (std::uint32_t v : patch.vertices) range.extend(mesh.uvs[v]);
  float length[2] = {0, 0}, total = 0;
  for (std::size_t t : patch.triangles) {
    const auto axes = texture_axes(mesh, t);
    if (axes[0].isZero() && axes[1].isZero()) continue;
    for (int k = 0; k < 2; ++k) length[k] += axes[std::size_t(k)].norm() * range.sizes()[k] * area(mesh, t);
    total += area(mesh, t);
  }
  if (total <= 0) return -1;
  return length[1] >= length[0] ? 1 : 0;
}

/// +1 where the root is at the low end of `coordinate`, -1 where it is at the high end.
float root_sign(const HairMesh& mesh, const PatchView& patch, std::span<const float> coordinate,
                const FittedHead& head) {
  const auto [low, high] = std::ranges::minmax(coordinate);
  const float quarter = 0.25f * (high - low);
  struct End {
    float distance = 0, height = 0, count = 0;
  } ends[2];
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    if (coordinate[i] > low + quarter && coordinate[i] < high - quarter) continue;
    End& end = ends[coordinate[i] <= low + quarter ? 0 : 1];
    end.distance += float(head.distance(mesh.positions[patch.vertices[i]].cast<double>()));
    end.height += mesh.positions[patch.vertices[i]].y();
    end.count += 1;
  }
  for (End& end : ends) {
    end.distance /= std::max(end.count, 1.0f);
    end.height /= std::max(end.count, 1.0f);
  }
  const float difference = ends[1].distance - ends[0].distance;
  // Hair that follows the skull is everywhere as near to it; there the upper end is the root.
  const float size = float(head.radii.mean());
  if (std::abs(difference) > 0.1f * size) return difference > 0 ? 1.0f : -1.0f;
  return ends[0].height >= ends[1].height ? 1.0f : -1.0f;
}

void write_tangents(const HairMesh& mesh, const PatchView& patch, int texture_axis, const Vector3f& fallback,
                    float sign, StrandField& field) {
  for (std::size_t t : patch.triangles) {
    const Vector3f along = texture_axis < 0 ? Vector3f(fallback * sign)
                                            : Vector3f(texture_axes(mesh, t)[std::size_t(texture_axis)] * sign);
    if (along.isZero()) continue;
    for (std::size_t k = 0; k < 3; ++k) field.tangent[mesh.triangles[t + k]] += along.normalized() * area(mesh, t);
  }
  for (std::uint32_t v : patch.vertices) {
    const Vector3f& normal = mesh.normals[v];
    Vector3f tangent = field.tangent[v].isZero() ? Vector3f(fallback * sign) : field.tangent[v].normalized();
    tangent -= normal * normal.dot(tangent);
    field.tangent[v] = tangent.norm() > 1.0e-4f ? Vector3f(tangent.normalized()) : Vector3f(normal.unitOrthogonal());
  }
}

/// `axis` or its opposite: the one along which `coordinate` grows.
Vector3f oriented_along(const HairMesh& mesh, const PatchView& patch, std::span<const float> coordinate,
                        const Vector3f& axis) {
  const float first = coordinate.front(), origin = axis.dot(mesh.positions[patch.vertices.front()]);
  float sum = 0;
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    sum += (coordinate[i] - first) * (axis.dot(mesh.positions[patch.vertices[i]]) - origin);
  }
  return sum >= 0 ? axis : Vector3f(-axis);
}

/// Returns the texture axis that was used, or -1.
int find_in_patch(const HairMesh& mesh, const PatchView& patch, const FittedHead& head, StrandField& field) {
  const int axis = texture_axis_of_strands(mesh, patch);
  Vector3f principal = principal_axis(mesh, patch);
  std::vector<float> coordinate;
  for (std::uint32_t v : patch.vertices) {
    coordinate.push_back(axis < 0 ? principal.dot(mesh.positions[v]) : mesh.uvs[v][axis]);
  }
  principal = oriented_along(mesh, patch, coordinate, principal);
  const float sign = root_sign(mesh, patch, coordinate, head);
  const auto [low, high] = std::ranges::minmax(coordinate);
  const float range = std::max(high - low, 1.0e-12f);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
    field.place[patch.vertices[i]] = sign > 0 ? (coordinate[i] - low) / range : (high - coordinate[i]) / range;
  }
  write_tangents(mesh, patch, axis, principal, sign, field);
  return axis;
}

}  // namespace

StrandField find_strand_direction(const HairMesh& mesh, const PatchSet& patches, const FittedHead& head,
                                  unsigned threads) {
  StrandField field;
  field.tangent.assign(mesh.positions.size(), Vector3f::Zero());
  field.place.assign(mesh.positions.size(), 0.0f);
  const std::vector<PatchView> views = split(mesh, patches);
  std::vector<int> axis(views.size());
  parallel_for(views.size(), threads, [&](std::size_t p) { axis[p] = find_in_patch(mesh, views[p], head, field); });
  field.along_u = std::ranges::count(axis, 0) > std::ranges::count(axis, 1);
  return field;
}

}  // namespace coif
