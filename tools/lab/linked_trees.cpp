#include "lab/passive_model.h"
#include "lab/reference_links.h"
#include "lab/reference_model.h"

#include <algorithm>
#include <numeric>

namespace coif::lab {
namespace {

/// The final root of each bone; linked bones have the root of the first of them.
class Roots {
 public:
  explicit Roots(std::size_t count) : up_(count) { std::iota(up_.begin(), up_.end(), std::size_t{0}); }
  std::size_t of(std::size_t bone) {
    while (up_[bone] != bone) bone = up_[bone] = up_[up_[bone]];
    return bone;
  }
  void join(std::size_t a, std::size_t b) {
    const std::size_t first = of(a), second = of(b);
    up_[std::max(first, second)] = std::min(first, second);
  }

 private:
  std::vector<std::size_t> up_;
};

}  // namespace

std::vector<std::vector<std::uint32_t>> trees_of(const Rig& rig) {
  Roots roots(rig.bones.size());
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    if (rig.bones[i].parent >= 0) roots.join(i, std::size_t(rig.bones[i].parent));
  }
  for (const RigLink& link : rig.links) roots.join(link.bone, link.to);
  std::vector<std::vector<std::uint32_t>> trees;
  std::vector<std::size_t> tree_of(rig.bones.size());
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    const std::size_t root = roots.of(i);
    tree_of[i] = root == i ? trees.size() : tree_of[root];
    if (root == i) trees.emplace_back();
    trees[tree_of[i]].push_back(std::uint32_t(i));
  }
  const std::vector<int> depths = depths_of(rig.bones);
  for (const RigLink& link : rig.links) {
    auto& tree = trees[tree_of[link.bone]];
    const auto depth = [&](std::uint32_t bone) { return depths[bone]; };
    if (!std::ranges::is_sorted(tree, {}, depth)) std::ranges::stable_sort(tree, {}, depth);
  }
  return trees;
}

void ReferenceTree::find_links(const Rig& rig, std::span<const int> place) {
  std::vector<RigLink> links = links_among(rig, place);
  if (links.empty()) return;
  is_free_ = false;
  const std::vector<int> depths = depths_of(bones_);
  for (std::size_t i = 1; i < depths.size(); ++i) {
    if (depths[i] > depths[i - 1]) level_ends_.push_back(i);
  }
  level_ends_.push_back(bones_.size());
  links_ = std::make_unique<ReferenceLinks>(std::move(links), bones_);
}

}  // namespace coif::lab
