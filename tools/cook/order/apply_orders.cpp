#include "cook/order/choose_order.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace coif::cook {
namespace {

/// For each patch the number of others that begin before it in the file. Pieces of cut patches have numbers after all
/// others, so numbers do not tell. Patches of coarser levels take the places of those that they replace.
std::vector<std::uint32_t> places_in_file(const PatchSet& patches) {
  std::vector<std::uint32_t> place(patches.count, importer::kNoIndex);
  std::uint32_t next = 0;
  for (const std::uint32_t patch : patches.patch_of) {
    if (place[patch] == importer::kNoIndex) place[patch] = next++;
  }
  const std::size_t finest = patches.count - patches.stands_for.size();
  for (std::size_t p = finest; p < place.size(); ++p) place[p] = place[patches.stands_for[p - finest]];
  return place;
}

}  // namespace

PatchOrder sort_patches(const HairStrips& hair, const Eigen::Vector3d& head_center) {
  const HairMesh& mesh = hair.mesh;
  const PatchSet& patches = hair.patches;
  std::vector<Eigen::Vector3d> moment(patches.count, Eigen::Vector3d::Zero());
  std::vector<double> area(patches.count, 0.0);
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    const Eigen::Vector3d a = mesh.corner(t, 0).cast<double>();
    const Eigen::Vector3d b = mesh.corner(t, 1).cast<double>();
    const Eigen::Vector3d c = mesh.corner(t, 2).cast<double>();
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

namespace {

std::vector<LodRecord> levels_of(const AssetContents& contents) {
  if (!contents.lods.empty()) return contents.lods;
  return {{0, std::uint32_t(contents.patches.size()), 0, 0}};
}

/// Sorts a level's patches by key, lowest first; equal ones keep their order.
template <typename Key>
std::vector<std::uint32_t> sorted_patches(const LodRecord& level, const Key& key) {
  std::vector<std::uint32_t> patches(level.patch_count);
  std::iota(patches.begin(), patches.end(), level.first_patch);
  std::ranges::stable_sort(patches, {}, key);
  return patches;
}

/// Per place in the file a number that sorts patches of any level.
using Keys = std::unordered_map<std::uint32_t, double>;

class Reorder {
 public:
  explicit Reorder(AssetContents& contents)
      : contents_(contents), levels_(levels_of(contents)), old_(contents.patches), old_indices_(contents.indices) {}

  /// `order`: of the finest level's patches.
  void stored(const visibility::UnitOrder& order) {
    Keys place;
    for (std::size_t i = 0; i < order.size(); ++i) place[old_[order[i]].file_place] = double(i);
    moved_to_.resize(old_indices_.size() / 3);
    contents_.patches.clear();
    contents_.indices.clear();
    for (const LodRecord& level : levels_) {
      for (const std::uint32_t p : sorted_patches(level, [&](std::uint32_t q) { return key(place, q); })) move(p);
    }
  }

  /// Appends an order by direction, after stored(). `order`: of the finest level's triangles, in their old numbers.
  void append(const visibility::UnitOrder& order) {
    for (const std::uint32_t triangle : order) contents_.orders.push_back(moved_to_[triangle]);
    const Keys place = mean_places(order, levels_.front());
    for (const LodRecord& level : std::span(levels_).subspan(1)) {
      for (const std::uint32_t p : sorted_patches(level, [&](std::uint32_t q) { return key(place, q); })) {
        const std::uint32_t first = old_[p].first_index / 3;
        for (std::uint32_t t = 0; t < old_[p].index_count / 3; ++t) contents_.orders.push_back(moved_to_[first + t]);
      }
    }
  }

 private:
  [[nodiscard]] double key(const Keys& keys, std::uint32_t patch) const {
    const auto found = keys.find(old_[patch].file_place);
    return found == keys.end() ? 0 : found->second;
  }

  void move(std::uint32_t p) {
    PatchRecord patch = old_[p];
    const auto first = std::uint32_t(contents_.indices.size());
    for (std::uint32_t t = 0; t < patch.index_count / 3; ++t) moved_to_[patch.first_index / 3 + t] = first / 3 + t;
    const auto indices = old_indices_.begin() + patch.first_index;
    contents_.indices.insert(contents_.indices.end(), indices, indices + patch.index_count);
    patch.first_index = first;
    contents_.patches.push_back(patch);
  }

  [[nodiscard]] Keys mean_places(const visibility::UnitOrder& order, const LodRecord& finest) const {
    std::vector<double> place(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) place[order[i]] = double(i);
    Keys means;
    for (std::uint32_t p = 0; p < finest.patch_count; ++p) {
      const auto first = place.begin() + old_[p].first_index / 3;
      const std::uint32_t count = old_[p].index_count / 3;
      means[old_[p].file_place] = std::accumulate(first, first + count, 0.0) / count;
    }
    return means;
  }

  AssetContents& contents_;
  std::vector<LodRecord> levels_;
  std::vector<PatchRecord> old_;
  std::vector<std::uint32_t> old_indices_;
  std::vector<std::uint32_t> moved_to_;  ///< Per triangle before: its new number.
};

}  // namespace

void apply_orders(const visibility::FoundOrders& found, AssetContents& contents) {
  Reorder reorder(contents);
  reorder.stored(found.patches);
  for (const visibility::UnitOrder& order : found.by_view.orders) reorder.append(order);
  if (!found.by_view.orders.empty()) {
    for (const std::uint8_t order : found.by_view.order_of) contents.order_views.push_back(std::uint8_t(order + 1));
  }
  MaterialRecord& material = contents.material.front();
  material.opaque_threshold = found.rule.opaque_threshold;
  material.discard_threshold = std::min(material.discard_threshold, material.opaque_threshold);
  if (found.rule.faces_together) material.flags |= kMaterialFacesTogether;
}

}  // namespace coif::cook
