#include "cook/rig/skeleton.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>

namespace coif::cook {
namespace {

/// A chain in its new order. Parents count from the chain's first bone; kNone: the rigid bone that carries it.
struct OrderedChain {
  ChainRecord record;
  std::vector<std::uint32_t> bones;    ///< Old indices.
  std::vector<std::uint32_t> parents;  ///< The chain's shape.
};

/// The tree that each bone is the root of: its bones, and a number that equal trees share in whatever order their
/// children are listed.
struct Subtrees {
  std::vector<std::uint32_t> bones;
  std::vector<std::uint32_t> shape;
};

Subtrees find_subtrees(const std::vector<SkeletonBone>& bones) {
  Subtrees subtrees{std::vector<std::uint32_t>(bones.size(), 1), std::vector<std::uint32_t>(bones.size(), 0)};
  std::vector<std::vector<std::uint32_t>> shapes_below(bones.size());
  std::map<std::vector<std::uint32_t>, std::uint32_t> number_of;
  for (std::size_t b = bones.size(); b-- > 1;) {
    std::ranges::sort(shapes_below[b]);
    subtrees.shape[b] = number_of.try_emplace(shapes_below[b], std::uint32_t(number_of.size())).first->second;
    subtrees.bones[bones[b].parent] += subtrees.bones[b];
    shapes_below[bones[b].parent].push_back(subtrees.shape[b]);
  }
  return subtrees;
}

class DepthFirst {
 public:
  explicit DepthFirst(const std::vector<SkeletonBone>& bones) : bones_(bones), subtrees_(find_subtrees(bones)) {}

  OrderedChain operator()(const ChainRecord& record) const {
    OrderedChain chain{record, {}, {}};
    std::vector<Visit> waiting = visits_of(record, record.root, kNone);
    while (!waiting.empty()) {
      const Visit next = waiting.back();
      waiting.pop_back();
      const auto place = std::uint32_t(chain.bones.size());
      chain.bones.push_back(next.bone);
      chain.parents.push_back(next.parent_place);
      const std::vector<Visit> children = visits_of(record, next.bone, place);
      waiting.insert(waiting.end(), children.begin(), children.end());
    }
    return chain;
  }

 private:
  struct Visit {
    std::uint32_t bone;
    std::uint32_t parent_place;
  };

  /// Children of a bone inside the chain; the last is visited first.
  [[nodiscard]] std::vector<Visit> visits_of(const ChainRecord& record, std::uint32_t parent,
                                             std::uint32_t place) const {
    std::vector<Visit> visits;
    for (std::uint32_t b = record.first_bone; b < record.first_bone + record.bone_count; ++b) {
      if (bones_[b].parent == parent) visits.push_back({b, place});
    }
    std::ranges::stable_sort(visits, std::less<>{}, [&](const Visit& visit) {
      return std::pair(subtrees_.bones[visit.bone], subtrees_.shape[visit.bone]);
    });
    std::ranges::reverse(visits);
    return visits;
  }

  const std::vector<SkeletonBone>& bones_;
  Subtrees subtrees_;
};

/// Stores the chains one behind the other after the rigid bones.
std::vector<std::uint32_t> store(const std::vector<OrderedChain>& chains, Skeleton& skeleton) {
  std::vector<std::uint32_t> moved_to(skeleton.bones.size());
  std::iota(moved_to.begin(), moved_to.end(), 0u);
  const std::vector<SkeletonBone> bones = skeleton.bones;
  skeleton.chains.clear();
  std::uint32_t next = std::uint32_t(bones.size() - skeleton.simulated_count());
  for (const OrderedChain& chain : chains) {
    const auto index = std::uint32_t(skeleton.chains.size());
    skeleton.chains.push_back({next, chain.record.bone_count, chain.record.root, {}});
    for (std::size_t i = 0; i < chain.bones.size(); ++i) {
      SkeletonBone& bone = skeleton.bones[next + i] = bones[chain.bones[i]];
      bone.chain = index;
      if (chain.parents[i] != kNone) bone.parent = next + chain.parents[i];
      moved_to[chain.bones[i]] = next + std::uint32_t(i);
    }
    next += chain.record.bone_count;
  }
  for (std::uint32_t& bone : skeleton.bone_of_node) {
    if (bone != kNone) bone = moved_to[bone];
  }
  return moved_to;
}

}  // namespace

std::vector<std::uint32_t> order_bones(Skeleton& skeleton) {
  const DepthFirst depth_first(skeleton.bones);
  std::vector<OrderedChain> chains;
  for (const ChainRecord& record : skeleton.chains) chains.push_back(depth_first(record));
  std::ranges::stable_sort(chains, [](const OrderedChain& a, const OrderedChain& b) {
    return std::tie(a.record.bone_count, a.parents) < std::tie(b.record.bone_count, b.parents);
  });
  return store(chains, skeleton);
}

}  // namespace coif::cook
