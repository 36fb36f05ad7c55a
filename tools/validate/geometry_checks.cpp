#include "validate/asset_checks.h"
#include "validate/hair_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>

namespace coif {
namespace {

constexpr float kNoArea = 1e-12f;  // square metres: a thousandth of a millimetre each way

Eigen::Vector3f position(const VertexRecord& vertex) { return Eigen::Vector3f(vertex.position); }

bool is_zero(const std::int16_t (&direction)[4]) { return direction[0] == 0 && direction[1] == 0 && direction[2] == 0; }

struct PatchFaults {
  std::size_t flat = 0;  ///< Triangles.
  std::size_t dark = 0;  ///< Corners.
  std::size_t bald = 0;
};

bool is_flat(const Asset& asset, std::span<const std::uint32_t> corners) {
  const Eigen::Vector3f a = position(asset.vertices()[corners[0]]);
  const Eigen::Vector3f b = position(asset.vertices()[corners[1]]) - a;
  const Eigen::Vector3f c = position(asset.vertices()[corners[2]]) - a;
  return b.cross(c).norm() / 2 < kNoArea;
}

/// Vertices that several triangles share are counted once.
PatchFaults faults_of(const Asset& asset, const PatchRecord& patch, std::vector<bool>& seen) {
  PatchFaults faults;
  const auto corners = asset.indices().subspan(patch.first_index, patch.index_count);
  for (std::size_t i = 0; i < corners.size(); i += 3) faults.flat += is_flat(asset, corners.subspan(i, 3)) ? 1 : 0;
  for (const std::uint32_t vertex : corners) {
    if (seen[vertex]) continue;
    seen[vertex] = true;
    faults.dark += is_zero(asset.vertices()[vertex].normal) ? 1 : 0;
    faults.bald += is_zero(asset.vertices()[vertex].tangent) ? 1 : 0;
  }
  return faults;
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return fmt::format("{} {}", count, count == 1 ? one : many);
}

void find_faulty_vertices(const Asset& asset, Issues& issues) {
  std::vector<bool> seen(asset.vertices().size(), false);
  for (std::size_t i = 0; i < asset.patches().size(); ++i) {
    const PatchFaults faults = faults_of(asset, asset.patches()[i], seen);
    const auto add = [&](const char* code, std::size_t count, const char* one, const char* many) {
      if (count > 0) issues.push_back(make_issue(code, counted(count, one, many), patch_place(i)));
    };
    add("A206", faults.dark, "vertex without a normal is lit wrongly", "vertices without a normal are lit wrongly");
    add("A231", faults.flat, "triangle without area", "triangles without area");
    add("A233", faults.bald, "vertex without a strand direction", "vertices without a strand direction");
  }
  const auto unused = std::ranges::count(seen, false);
  if (unused > 0) {
    issues.push_back(
        make_issue("A232", counted(std::size_t(unused), "vertex", "vertices") + " in no triangle", "chunk VERT"));
  }
}

void check_size(const Asset& asset, Issues& issues) {
  Eigen::AlignedBox3f box;
  for (const VertexRecord& vertex : asset.vertices()) box.extend(position(vertex));
  if (is_hair_sized(largest_side(box))) return;
  issues.push_back(make_issue("A234", fmt::format("{:.3g} m large; hair has 0.05 .. 3 m", largest_side(box))));
}

}  // namespace

std::string patch_place(std::size_t patch) { return fmt::format("patch {}", patch); }

void check_geometry(const Asset& asset, Issues& issues) {
  if (asset.vertices().empty()) {
    issues.push_back(make_issue("A201", "no mesh: it can be simulated but not drawn"));
    return;
  }
  find_faulty_vertices(asset, issues);
  check_size(asset, issues);
}

}  // namespace coif
