#include "counted.h"
#include "validate/asset_checks.h"
#include "validate/hair_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace coif {
namespace {

using Eigen::Vector3f;
using Corners = std::span<const std::uint32_t>;

constexpr float kNoArea = 1e-12f;  // square metres: a thousandth of a millimetre each way
constexpr double kSavesLittle = 0.9;

Vector3f position(const VertexRecord& vertex) { return Vector3f(vertex.position); }

struct PatchFaults {
  std::size_t flat = 0;    ///< Triangles without area.
  std::size_t turned = 0;  ///< Triangles whose normals point to their back.
};

/// Twice the area, towards the side that the corners wind around.
Vector3f area_vector(const Asset& asset, Corners corners) {
  const Vector3f a = position(asset.vertices()[corners[0]]);
  const Vector3f b = position(asset.vertices()[corners[1]]) - a;
  const Vector3f c = position(asset.vertices()[corners[2]]) - a;
  return b.cross(c);
}

bool is_turned(const Asset& asset, Corners corners, const Vector3f& area) {
  return std::ranges::all_of(corners, [&](std::uint32_t corner) {
    const auto& normal = asset.vertices()[corner].normal;
    return area.dot(Vector3f(normal[0], normal[1], normal[2])) < 0;
  });
}

PatchFaults faults_of(const Asset& asset, Corners corners) {
  PatchFaults faults;
  for (std::size_t i = 0; i < corners.size(); i += 3) {
    const Corners triangle = corners.subspan(i, 3);
    const Vector3f area = area_vector(asset, triangle);
    faults.flat += area.norm() / 2 < kNoArea ? 1 : 0;
    faults.turned += is_turned(asset, triangle, area) ? 1 : 0;
  }
  return faults;
}

void find_faulty_triangles(const Asset& asset, Issues& issues) {
  for (std::size_t i = 0; i < asset.patches().size(); ++i) {
    const PatchRecord& patch = asset.patches()[i];
    const PatchFaults faults = faults_of(asset, asset.indices().subspan(patch.first_index, patch.index_count));
    if (faults.flat > 0) {
      const std::string count = counted(faults.flat, "triangle", "triangles");
      issues.push_back(patch_issue("A231", count + " without area", i));
    }
    if (6 * faults.turned > patch.index_count) {
      issues.push_back(patch_issue("A233", "normals point to the back of its triangles", i));
    }
  }
}

void find_unused_vertices(const Asset& asset, Issues& issues) {
  std::vector<bool> used(asset.vertices().size(), false);
  for (const std::uint32_t vertex : asset.indices()) used[vertex] = true;
  const auto unused = std::size_t(std::ranges::count(used, false));
  if (unused == 0) return;
  issues.push_back(make_issue("A232", counted(unused, "vertex", "vertices") + " in no triangle", "chunk VERT"));
}

void check_size(const Asset& asset, Issues& issues) {
  Eigen::AlignedBox3f box;
  for (const VertexRecord& vertex : asset.vertices()) box.extend(position(vertex));
  if (is_hair_sized(largest_side(box))) return;
  issues.push_back(make_issue("A234", fmt::format("{:.3g} m large; hair has 0.05 .. 3 m", largest_side(box))));
}

void find_equal_levels(const Asset& asset, Issues& issues) {
  for (std::uint32_t lod = 1; lod < asset.lod_count(); ++lod) {
    const double share = double(asset.lod_indices(lod).size()) / double(asset.lod_indices(lod - 1).size());
    if (share <= kSavesLittle) continue;
    issues.push_back(make_issue("A235", fmt::format("{:.0f} % of the triangles of the finer level", 100 * share),
                                fmt::format("level of detail {}", lod)));
  }
}

}  // namespace

Issue patch_issue(std::string_view code, std::string message, std::size_t patch) {
  Issue issue = make_issue(code, std::move(message), fmt::format("patch {}", patch));
  issue.patch = std::uint32_t(patch);
  return issue;
}

void check_geometry(const Asset& asset, Issues& issues) {
  if (asset.vertices().empty()) {
    issues.push_back(make_issue("A201", "no mesh: it can be simulated but not drawn"));
    return;
  }
  find_faulty_triangles(asset, issues);
  find_unused_vertices(asset, issues);
  find_equal_levels(asset, issues);
  check_size(asset, issues);
}

}  // namespace coif
