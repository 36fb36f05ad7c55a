#include "cook/sort_patches.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace coif {

namespace {

/// For each patch how many others begin before it in the file. Patches that were cut are numbered after all others, so
/// their numbers do not tell.
std::vector<std::uint32_t> places_in_file(const PatchSet& patches) {
  std::vector<std::uint32_t> place(patches.count, kNoIndex);
  std::uint32_t next = 0;
  for (const std::uint32_t patch : patches.patch_of) {
    if (place[patch] == kNoIndex) place[patch] = next++;
  }
  return place;
}

}  // namespace

PatchOrder sort_patches(const HairMesh& mesh, const PatchSet& patches, const Eigen::Vector3d& head_center) {
  std::vector<Eigen::Vector3d> moment(patches.count, Eigen::Vector3d::Zero());
  std::vector<double> area(patches.count, 0.0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d a = mesh.positions[mesh.triangles[3 * t]].cast<double>();
    const Eigen::Vector3d b = mesh.positions[mesh.triangles[3 * t + 1]].cast<double>();
    const Eigen::Vector3d c = mesh.positions[mesh.triangles[3 * t + 2]].cast<double>();
    const double twice_area = (b - a).cross(c - a).norm();
    moment[patches.patch_of[t]] += (a + b + c) * (twice_area / 3);
    area[patches.patch_of[t]] += twice_area;
  }
  std::vector<double> distance(patches.count);
  for (std::uint32_t p = 0; p < patches.count; ++p) distance[p] = (moment[p] / area[p] - head_center).norm();

  PatchOrder order;
  order.patch.resize(patches.count);
  std::iota(order.patch.begin(), order.patch.end(), 0u);
  std::ranges::stable_sort(order.patch, [&](std::uint32_t a, std::uint32_t b) { return distance[a] < distance[b]; });
  const std::vector<std::uint32_t> place = places_in_file(patches);
  for (std::uint32_t p : order.patch) {
    order.distance.push_back(distance[p]);
    order.file_place.push_back(place[p]);
  }
  return order;
}

}  // namespace coif
