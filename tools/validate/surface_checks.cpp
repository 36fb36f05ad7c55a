#include "base/text.h"
#include "cook/select/mesh_topology.h"
#include "validate/asset_checks.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>
#include <set>
#include <utility>

namespace coif::validate {
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

void find_faulty_triangles(const Asset& asset, Diagnostics& issues) {
  for (std::size_t i = 0; i < asset.patches().size(); ++i) {
    const PatchRecord& patch = asset.patches()[i];
    const PatchFaults faults = faults_of(asset, asset.indices().subspan(patch.first_index, patch.index_count));
    if (faults.flat > 0) {
      add_patch_issue(issues, "A231", i, "{} without area", counted(faults.flat, "triangle", "triangles"));
    }
    if (6 * faults.turned > patch.index_count) {
      add_patch_issue(issues, "A233", i, "normals point to the back of its triangles");
    }
  }
}

void find_unused_vertices(const Asset& asset, Diagnostics& issues) {
  std::vector<bool> used(asset.vertices().size(), false);
  for (const std::uint32_t vertex : asset.indices()) used[vertex] = true;
  const auto unused = std::size_t(std::ranges::count(used, false));
  if (unused == 0) return;
  add_issue(issues, "A232", "chunk VERT", "{} in no triangle", counted(unused, "vertex", "vertices"));
}

void check_size(const Asset& asset, Diagnostics& issues) {
  Eigen::AlignedBox3f box;
  for (const VertexRecord& vertex : asset.vertices()) box.extend(position(vertex));
  if (cook::is_hair_sized(cook::largest_side(box))) return;
  add_issue(issues, "A234", "", "{:.3g} m large; hair has 0.05 .. 3 m", cook::largest_side(box));
}

void find_equal_levels(const Asset& asset, Diagnostics& issues) {
  for (std::uint32_t lod = 1; lod < asset.lod_count(); ++lod) {
    const double share = double(asset.lod_indices(lod).size()) / double(asset.lod_indices(lod - 1).size());
    if (share <= kSavesLittle) continue;
    add_issue(issues, "A235", fmt::format("level of detail {}", lod), "{:.0f} % of the triangles of the finer level",
              100 * share);
  }
}

}  // namespace

void check_geometry(const Asset& asset, Diagnostics& issues) {
  if (asset.vertices().empty()) return add_issue(issues, "A201", "", "no mesh: it can be simulated but not drawn");
  find_faulty_triangles(asset, issues);
  find_unused_vertices(asset, issues);
  find_equal_levels(asset, issues);
  check_size(asset, issues);
}

namespace {

constexpr float kTooWide = 1.5f;     // Share of the head's radius: the cook cuts patches wider than 0.75.
constexpr float kHeadRadius = 0.1f;  // Metres, where no collider gives one.
constexpr std::size_t kSections = 8;

/// Groups of triangles that share a place.
std::size_t pieces_of(const Asset& asset, Corners corners) {
  std::map<std::array<float, 3>, std::uint32_t> places;
  cook::DisjointSets sets(corners.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    const float(&at)[3] = asset.vertices()[corners[i]].position;
    sets.unite(i, places.try_emplace({at[0], at[1], at[2]}, i).first->second);
    if (i % 3 != 0) sets.unite(i, i - 1);
  }
  std::set<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < corners.size(); ++i) roots.insert(sets.find(i));
  return roots.size();
}

std::size_t section_of(const VertexRecord& vertex) {
  const auto place = std::size_t(std::max<int>(0, vertex.tangent[3]));
  return std::min(kSections - 1, place * kSections / 32767);
}

/// Mean extent of the sections from root to tip across the strands, metres.
float width_of(const Asset& asset, Corners corners) {
  std::array<Vector3f, kSections> along;
  along.fill(Vector3f::Zero());
  for (const std::uint32_t corner : corners) {
    const VertexRecord& vertex = asset.vertices()[corner];
    along[section_of(vertex)] += Vector3f(vertex.tangent[0], vertex.tangent[1], vertex.tangent[2]);
  }
  std::array<Eigen::AlignedBox3f, kSections> boxes;
  for (const std::uint32_t corner : corners) {
    const VertexRecord& vertex = asset.vertices()[corner];
    const Vector3f direction = along[section_of(vertex)].stableNormalized();
    const Vector3f at(vertex.position);
    boxes[section_of(vertex)].extend(Vector3f(at - direction * direction.dot(at)));
  }
  float sum = 0, count = 0;
  for (const Eigen::AlignedBox3f& box : boxes) {
    if (box.isEmpty()) continue;
    sum += box.diagonal().norm();
    count += 1;
  }
  return count > 0 ? sum / count : 0;
}

float head_radius(const Asset& asset) {
  float radius = 0;
  for (const ColliderRecord& collider : asset.colliders()) {
    const bool keeps_out = (collider.flags & kColliderKeepsInside) == 0;
    if (keeps_out) radius = std::max({radius, collider.radii[0], collider.radii[1], collider.radii[2]});
  }
  return radius > 0 ? radius : kHeadRadius;
}

void find_unsortable(const Asset& asset, Diagnostics& issues) {
  const float widest = kTooWide * head_radius(asset);
  for (std::size_t i = 0; i < asset.lod_patches(0).size(); ++i) {
    const PatchRecord& patch = asset.lod_patches(0)[i];
    const Corners corners = asset.indices().subspan(patch.first_index, patch.index_count);
    const std::size_t pieces = pieces_of(asset, corners);
    if (pieces > 1) add_patch_issue(issues, "A241", i, "{} pieces that do not touch", pieces);
    const float width = width_of(asset, corners);
    if (width <= widest) continue;
    add_patch_issue(issues, "A242", i, "{:.2g} m wide across its strands, above {:.2g} m", width, widest);
  }
}

}  // namespace

void check_patches(const Asset& asset, Diagnostics& issues) {
  const std::size_t patches = asset.lod_patches(0).size();
  const std::size_t triangles = asset.lod_indices(0).size() / 3;
  if (cook::is_shattered(triangles, patches))
    add_issue(issues, "A243", "", "{} triangles in {} patches", triangles, patches);
  find_unsortable(asset, issues);
}

void check_orders(const Asset& asset, Diagnostics& issues) {
  if (asset.orders().empty()) return;
  // Order 0 is that of the triangles themselves and costs nothing.
  for (std::uint32_t i = 1; i < asset.order_count(); ++i) {
    if (std::ranges::find(asset.order_views(), i) != asset.order_views().end()) continue;
    add_issue(issues, "A253", fmt::format("draw order {}", i), "no direction uses it");
  }
  if (asset.material() == nullptr || blends(*asset.material())) return;
  add_issue(issues, "A251", "chunk ORDR", "nothing is blended; {} bytes of orders have no effect",
            asset.orders().size_bytes());
}

}  // namespace coif::validate
