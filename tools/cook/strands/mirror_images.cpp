#include "cook/strands/strand_evidence.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>

namespace coif::cook {
namespace {

using Eigen::Vector3f;

constexpr std::size_t kMostTriangles = 256;  ///< Looked at for directions, of each patch.
constexpr std::size_t kMostVertices = 64;    ///< Looked for in the other patch, of each patch.

Vector3f image_of(const Vector3f& p, float middle) { return {2 * middle - p.x(), p.y(), p.z()}; }

/// Middle and direction of some of the patch's triangles.
std::vector<std::array<Vector3f, 2>> directions_along(const HairMesh& mesh, const PatchView& patch,
                                                      const StrandAxis& axis) {
  std::vector<float> coordinate(mesh.positions.size(), 0.0f);
  for (std::size_t i = 0; i < patch.vertices.size(); ++i) coordinate[patch.vertices[i]] = axis.coordinate[i];
  std::vector<std::array<Vector3f, 2>> samples;
  const std::size_t step = std::max<std::size_t>(1, patch.triangles.size() / kMostTriangles);
  for (std::size_t i = 0; i < patch.triangles.size(); i += step) {
    const std::size_t t = patch.triangles[i];
    const Vector3f along = gradient(mesh, t, coordinate);
    if (!(along.norm() > 0)) continue;
    const Vector3f sum = mesh.positions[mesh.triangles[t]] + mesh.positions[mesh.triangles[t + 1]] +
                         mesh.positions[mesh.triangles[t + 2]];
    samples.push_back({sum / 3, along.normalized()});
  }
  return samples;
}

/// What the patches that may be twins are compared by first.
struct Outline {
  Eigen::AlignedBox3f box;
  Vector3f mean = Vector3f::Zero();
};

Outline outline_of(const HairMesh& mesh, const PatchView& patch) {
  Outline outline;
  for (const std::uint32_t v : patch.vertices) {
    outline.box.extend(mesh.positions[v]);
    outline.mean += mesh.positions[v] / float(patch.vertices.size());
  }
  return outline;
}

/// Whether each vertex of `patch` that is looked at has its image within `reach` of a vertex of `other`.
bool is_covered(const HairMesh& mesh, const PatchView& patch, const PatchView& other, float middle, float reach) {
  const std::size_t step = std::max<std::size_t>(1, patch.vertices.size() / kMostVertices);
  for (std::size_t i = 0; i < patch.vertices.size(); i += step) {
    const Vector3f image = image_of(mesh.positions[patch.vertices[i]], middle);
    const auto is_near = [&](std::uint32_t v) { return (mesh.positions[v] - image).squaredNorm() < reach * reach; };
    if (std::ranges::none_of(other.vertices, is_near)) return false;
  }
  return true;
}

}  // namespace

float mirror_agreement(const HairMesh& mesh, const PatchView& patch, const StrandAxis& axis, const PatchView& other,
                       const StrandAxis& other_axis, float middle, float reach) {
  const auto samples = directions_along(mesh, patch, axis), others = directions_along(mesh, other, other_axis);
  if (samples.empty() || others.empty()) return 0;
  float agreement = 0;
  for (const auto& [place, along] : samples) {
    const Vector3f image = image_of(place, middle);
    const auto distance = [&](const auto& sample) { return (sample[0] - image).squaredNorm(); };
    const auto& nearest = *std::ranges::min_element(others, {}, distance);
    if (distance(nearest) < reach * reach) agreement += nearest[1].dot(Vector3f(-along.x(), along.y(), along.z()));
  }
  return agreement / float(samples.size());
}

std::vector<std::uint32_t> find_twins(const HairMesh& mesh, const std::vector<PatchView>& views, float middle,
                                      float reach) {
  std::vector<Outline> outlines;
  for (const PatchView& view : views) outlines.push_back(outline_of(mesh, view));
  std::vector<std::uint32_t> twins(views.size()), by_height(views.size());
  std::iota(twins.begin(), twins.end(), 0u);
  by_height = twins;
  const auto lowest = [&](std::uint32_t p) { return outlines[p].box.min().y(); };
  std::ranges::stable_sort(by_height, {}, lowest);
  const auto are_images = [&](std::uint32_t p, std::uint32_t q) {
    const Eigen::AlignedBox3f &a = outlines[p].box, &b = outlines[q].box;
    const Vector3f low(2 * middle - a.max().x(), a.min().y(), a.min().z());
    const Vector3f high(2 * middle - a.min().x(), a.max().y(), a.max().z());
    return (low - b.min()).cwiseAbs().maxCoeff() < reach && (high - b.max()).cwiseAbs().maxCoeff() < reach &&
           is_covered(mesh, views[p], views[q], middle, reach) && is_covered(mesh, views[q], views[p], middle, reach);
  };
  for (std::size_t i = 0; i < by_height.size(); ++i) {
    const std::uint32_t p = by_height[i];
    if (twins[p] != p || are_images(p, p)) continue;
    float best = std::numeric_limits<float>::infinity();
    std::uint32_t twin = p;
    for (std::size_t k = i + 1; k < by_height.size() && lowest(by_height[k]) < lowest(p) + reach; ++k) {
      const std::uint32_t q = by_height[k];
      const float apart = (outlines[q].mean - image_of(outlines[p].mean, middle)).norm();
      if (twins[q] != q || apart >= std::min(best, reach) || !are_images(p, q) || are_images(q, q)) continue;
      best = apart;
      twin = q;
    }
    twins[p] = twin;
    twins[twin] = p;
  }
  return twins;
}

}  // namespace coif::cook
