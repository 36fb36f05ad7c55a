#include "cook/strand_direction.h"

#include "cook/parallel_for.h"
#include "cook/strand_axis.h"
#include "cook/strand_root.h"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>

namespace coif {
namespace {

using Eigen::Vector3f;

constexpr float kSure = 0.5f;             ///< Of RootEvidence::sum(): half a radius nearer, or a bone.
constexpr float kLonger = 0.33f;          ///< A patch twice as long along one texture axis has its strands along it.
constexpr float kMuchLonger = 0.6f;       ///< Four times as long: nothing else is asked.
constexpr float kCommonAxis = 0.3f;       ///< What it counts that the other patches have the same axis.
constexpr float kConsensusWeight = 1.0f;  ///< What it counts where the others have their roots.

struct PatchStrands {
  float preference = 0;  ///< texture_preference().
  float area = 0;
  StrandAxis axis;
  RootEvidence evidence;
  float sign = 1;  ///< 1: the low end of the coordinate is the root.
};

float total_area(const HairMesh& mesh, const PatchView& view) {
  float sum = 0;
  for (std::size_t t : view.triangles) sum += doubled_area(mesh, t);
  return sum;
}

/// The texture axis of most of the area, by the patches that are clearly longer along one.
int common_texture_axis(std::span<const PatchStrands> patches) {
  float sum = 0;
  for (const PatchStrands& patch : patches) {
    if (std::abs(patch.preference) > kLonger) sum += patch.area * (patch.preference > 0 ? 1.0f : -1.0f);
  }
  return sum >= 0 ? 1 : 0;
}

/// Along which texture axis the strands run: the one the patch is longer along, whose ends differ more as roots and tips
/// do, and which the other patches have; -1 where texture coordinates say nothing. Fills axis and evidence.
void choose_axis(const HairMesh& mesh, std::span<const std::uint32_t> place, const PatchView& view,
                 const FittedHead& head, std::span<const float> depth_of_node, int common, PatchStrands& patch) {
  const int only = patch.preference == 0 ? -1 : std::abs(patch.preference) > kMuchLonger ? (patch.preference > 0) : 2;
  float best = -1;
  for (int candidate = -1; candidate < 2; ++candidate) {
    if (only == 2 ? candidate < 0 : candidate != only) continue;
    StrandAxis axis = strand_axis(mesh, place, view, candidate);
    const RootEvidence evidence = weigh_ends(mesh, view, axis, head, depth_of_node);
    const float longer = candidate == 1 ? patch.preference : -patch.preference;
    const float score = 1 + longer + std::abs(evidence.sum()) + (candidate == common ? kCommonAxis : 0.0f);
    if (score <= best) continue;
    best = score;
    patch.axis = std::move(axis);
    patch.evidence = evidence;
  }
}

/// Where the sure patches have their roots in the texture, per axis: -1 at the high end .. 1 at the low end.
std::array<float, 2> root_consensus(std::span<const PatchStrands> patches) {
  std::array<float, 2> sum{0, 0}, area{0, 0};
  for (const PatchStrands& patch : patches) {
    if (patch.axis.texture_axis < 0 || std::abs(patch.evidence.sum()) < kSure) continue;
    const auto axis = std::size_t(patch.axis.texture_axis);
    sum[axis] += patch.area * (patch.evidence.sum() > 0 ? 1.0f : -1.0f);
    area[axis] += patch.area;
  }
  for (std::size_t k = 0; k < 2; ++k) sum[k] = area[k] > 0 ? sum[k] / area[k] : 0;
  return sum;
}

struct RootCounts {
  std::size_t sure = 0, by_others = 0;
};

RootCounts decide_roots(std::span<PatchStrands> patches) {
  const std::array<float, 2> consensus = root_consensus(patches);
  RootCounts counts;
  for (PatchStrands& patch : patches) {
    float score = patch.evidence.sum();
    if (std::abs(score) >= kSure) {
      ++counts.sure;
    } else if (patch.axis.texture_axis >= 0) {
      const float others = kConsensusWeight * consensus[std::size_t(patch.axis.texture_axis)];
      counts.by_others += std::abs(others) > std::abs(score) ? 1 : 0;
      score += others;
    }
    patch.sign = score >= 0 ? 1.0f : -1.0f;
  }
  return counts;
}

/// Direction in which the coordinate grows over one triangle.
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

/// Where the strands run on the whole: from the middle of its first half to that of its second.
Vector3f overall_direction(const HairMesh& mesh, const PatchView& view, std::span<const float> place) {
  Vector3f sum = Vector3f::Zero(), mean = Vector3f::Zero();
  for (std::uint32_t v : view.vertices) mean += mesh.positions[v] / float(view.vertices.size());
  for (std::uint32_t v : view.vertices) sum += (mesh.positions[v] - mean) * (place[v] - 0.5f);
  return sum.norm() > 0 ? Vector3f(sum.normalized()) : Vector3f(0, -1, 0);
}

/// Tangents of one patch from StrandField::place.
void write_tangents(const HairMesh& mesh, const PatchView& view, const PatchStrands& strands, StrandField& field) {
  for (std::size_t t : view.triangles) {
    // Along the texture's own axis where there is one: painted strands are parallel to it even where it is sheared.
    Vector3f along = gradient(mesh, t, field.place);
    if (strands.axis.texture_axis >= 0) {
      along = texture_axes(mesh, t)[std::size_t(strands.axis.texture_axis)] * strands.sign;
    }
    if (!(along.norm() > 0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      field.tangent[mesh.triangles[t + k]] += along.normalized() * doubled_area(mesh, t);
    }
  }
  const Vector3f fallback = overall_direction(mesh, view, field.place);
  for (std::uint32_t v : view.vertices) {
    const Vector3f& normal = mesh.normals[v];
    Vector3f tangent = field.tangent[v].isZero() ? fallback : Vector3f(field.tangent[v].normalized());
    tangent -= normal * normal.dot(tangent);
    field.tangent[v] = tangent.norm() > 1.0e-4f ? Vector3f(tangent.normalized()) : Vector3f(normal.unitOrthogonal());
  }
}

void write_patch(const HairMesh& mesh, const PatchView& view, const PatchStrands& strands, StrandField& field) {
  for (std::size_t i = 0; i < view.vertices.size(); ++i) {
    const float at = strands.axis.coordinate[i];
    field.place[view.vertices[i]] = strands.sign > 0 ? at : 1 - at;
  }
  write_tangents(mesh, view, strands, field);
}

}  // namespace

StrandField find_strand_direction(const HairMesh& mesh, std::span<const std::uint32_t> place, const PatchSet& patches,
                                  const FittedHead& head, const StrandSettings& settings) {
  StrandField field;
  field.tangent.assign(mesh.positions.size(), Vector3f::Zero());
  field.place.assign(mesh.positions.size(), 0.0f);
  const std::vector<PatchView> views = view_patches(mesh, patches);
  std::vector<PatchStrands> strands(views.size());
  parallel_for(views.size(), settings.threads, [&](std::size_t p) {
    strands[p].area = total_area(mesh, views[p]);
    strands[p].preference = settings.trust_texture ? texture_preference(mesh, views[p]) : 0;
  });
  const int common = common_texture_axis(strands);
  parallel_for(views.size(), settings.threads, [&](std::size_t p) {
    choose_axis(mesh, place, views[p], head, settings.depth_of_node, common, strands[p]);
  });
  const RootCounts counts = decide_roots(strands);
  parallel_for(views.size(), settings.threads, [&](std::size_t p) { write_patch(mesh, views[p], strands[p], field); });
  field.along_u = common == 0 && !mesh.uvs.empty();
  field.reason =
      fmt::format("roots: {} of {} patches by their own ends, {} by where the others have theirs in the texture",
                  counts.sure, views.size(), counts.by_others);
  return field;
}

std::vector<float> depths_below(const SourceModel& source, std::uint32_t head_node) {
  std::vector<float> depth(source.nodes.size(), -1.0f);
  if (head_node != kNoIndex) depth[head_node] = 0;
  for (std::uint32_t n = 0; n < source.nodes.size(); ++n) {
    const std::uint32_t parent = source.nodes[n].parent;
    if (n != head_node && parent != kNoIndex && depth[parent] >= 0) depth[n] = depth[parent] + 1;
  }
  for (float& d : depth) d = std::max(d, 0.0f);
  return depth;
}

}  // namespace coif
