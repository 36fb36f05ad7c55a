#include "cook/dynamics/bake_links.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

namespace coif::cook {
namespace {

constexpr double kTouching = 1.0e-4;  // metres: such a link would have no direction

/// Indices of a chain's bones, by depth.
using Depths = std::vector<std::vector<std::uint32_t>>;

std::vector<Depths> depths_of_chains(const AssetContents& contents) {
  std::vector<Depths> chains(contents.chains.size());
  std::vector<std::size_t> depth(contents.bones.size(), 0);
  for (std::uint32_t b = 0; b < contents.bones.size(); ++b) {
    const BoneRecord& bone = contents.bones[b];
    if (bone.kind != BoneKind::kSimulated) continue;
    const bool is_first = contents.bones[bone.parent].kind != BoneKind::kSimulated;
    depth[b] = is_first ? 0 : depth[bone.parent] + 1;
    Depths& depths = chains[bone.chain];
    if (depths.size() <= depth[b]) depths.resize(depth[b] + 1);
    depths[depth[b]].push_back(b);
  }
  return chains;
}

/// The bone's particle at rest, head space.
Eigen::Vector3d resting_tail(const BoneRecord& bone) {
  const auto vector = [](const float(&v)[3]) { return Eigen::Vector3d(double(v[0]), double(v[1]), double(v[2])); };
  return vector(bone.joint) + double(bone.length) * vector(bone.rest_direction);
}

double gap(const AssetContents& contents, std::uint32_t a, std::uint32_t b) {
  return (resting_tail(contents.bones[a]) - resting_tail(contents.bones[b])).norm();
}

std::uint32_t nearest(const AssetContents& contents, std::uint32_t bone, const std::vector<std::uint32_t>& others) {
  return *std::ranges::min_element(others, {}, [&](std::uint32_t other) { return gap(contents, bone, other); });
}

/// Mean distance over so many depths, between the nearest bones of each depth.
double mean_gap(const AssetContents& contents, const Depths& one, const Depths& other, std::size_t depths) {
  double sum = 0;
  for (std::size_t d = 0; d < depths; ++d) {
    double least = gap(contents, one[d].front(), nearest(contents, one[d].front(), other[d]));
    for (const std::uint32_t bone : one[d])
      least = std::min(least, gap(contents, bone, nearest(contents, bone, other[d])));
    sum += least;
  }
  return sum / double(depths);
}

struct Candidate {
  double gap;  ///< Metres at rest, the mean.
  ChainPair pair;
  std::size_t depths;  ///< Number of depths that it can link.

  bool operator<(const Candidate& other) const { return std::tie(gap, pair) < std::tie(other.gap, other.pair); }
};

/// The closest pair first.
std::vector<Candidate> candidates(const AssetContents& contents, const std::vector<Depths>& chains,
                                  const LinkedDepths& pairs) {
  std::vector<Candidate> sorted;
  for (const auto& [pair, most] : pairs) {
    const Depths &one = chains[pair.first], &other = chains[pair.second];
    const std::size_t depths = std::min({one.size(), other.size(), std::size_t(most)});
    sorted.push_back({mean_gap(contents, one, other, depths), pair, depths});
  }
  std::ranges::sort(sorted, std::less<>{});
  return sorted;
}

/// Chains that are linked directly.
using Neighbours = std::vector<std::vector<std::uint32_t>>;

/// Kruskal's: the closest pairs that hold all chains of this depth together which any of the pairs do.
Neighbours closest_forest(const std::vector<Candidate>& sorted, std::size_t chain_count, std::size_t depth) {
  std::vector<std::uint32_t> group(chain_count);
  std::iota(group.begin(), group.end(), 0u);
  Neighbours neighbours(chain_count);
  for (const Candidate& next : sorted) {
    const auto [one, other] = next.pair;
    const std::uint32_t joins = group[one], joined = group[other];
    if (joins == joined || depth >= next.depths) continue;
    std::ranges::replace(group, joined, joins);
    neighbours[one].push_back(other);
    neighbours[other].push_back(one);
  }
  return neighbours;
}

/// A chain of a tree, after the one that it is linked to.
struct Visit {
  std::uint32_t chain;
  std::uint32_t above;  ///< kNone: the tree's root.
  std::uint32_t level;  ///< Links up to the root.
};

/// The whole tree from this chain on, level by level.
std::vector<Visit> visit_from(const Neighbours& neighbours, std::uint32_t root) {
  std::vector<Visit> visits = {{root, kNone, 0}};
  for (std::size_t i = 0; i < visits.size(); ++i) {
    const Visit at = visits[i];
    for (const std::uint32_t next : neighbours[at.chain]) {
      if (next != at.above) visits.push_back({next, at.chain, at.level + 1});
    }
  }
  return visits;
}

/// The chain whose farthest chain is nearest; among equals the longest, then the first. It lies halfway between the
/// ends of the longest way through the tree.
std::uint32_t middle_of(const Neighbours& neighbours, const std::vector<Depths>& chains, std::uint32_t member) {
  const std::uint32_t one_end = visit_from(neighbours, member).back().chain;
  const std::vector<Visit> across = visit_from(neighbours, one_end);
  std::vector<std::uint32_t> above(chains.size(), kNone);
  for (const Visit& visit : across) above[visit.chain] = visit.above;
  std::uint32_t middle = across.back().chain;
  for (std::uint32_t i = 0; i < across.back().level / 2; ++i) middle = above[middle];
  if (across.back().level % 2 == 0) return middle;
  const std::uint32_t other = above[middle];
  const auto rank = [&](std::uint32_t chain) { return std::tuple(-std::ptrdiff_t(chains[chain].size()), chain); };
  return std::min(middle, other, [&](std::uint32_t a, std::uint32_t b) { return rank(a) < rank(b); });
}

/// Every tree, from its middle on; chains without links are left out.
std::vector<Visit> visit_trees(const Neighbours& neighbours, const std::vector<Depths>& chains) {
  std::vector<Visit> all;
  std::vector<bool> seen(chains.size(), false);
  for (std::uint32_t chain = 0; chain < chains.size(); ++chain) {
    if (seen[chain] || neighbours[chain].empty()) continue;
    for (const Visit& visit : visit_from(neighbours, middle_of(neighbours, chains, chain))) {
      seen[visit.chain] = true;
      all.push_back(visit);
    }
  }
  return all;
}

LinkRecord link_between(const AssetContents& contents, std::uint32_t bone, std::uint32_t to, const LinkRoom& room) {
  const double width = gap(contents, bone, to);
  return {bone, to, float(width * (1 - room.shrink)), float(width * (1 + room.stretch))};
}

}  // namespace

LinkForest link_chains(const AssetContents& contents, const LinkedDepths& pairs, const LinkRoom& room) {
  LinkForest forest;
  const std::vector<Depths> chains = depths_of_chains(contents);
  const std::vector<Candidate> sorted = candidates(contents, chains, pairs);
  std::set<ChainPair> linked, left_out;
  for (const Candidate& candidate : sorted) left_out.insert(candidate.pair);
  for (std::size_t depth = 0;; ++depth) {
    const std::vector<Visit> trees = visit_trees(closest_forest(sorted, chains.size(), depth), chains);
    if (trees.empty()) break;
    for (const Visit& visit : trees) {
      if (visit.above == kNone) continue;
      const ChainPair pair = std::minmax(visit.chain, visit.above);
      left_out.erase(pair);
      for (const std::uint32_t bone : chains[visit.chain][depth]) {
        const std::uint32_t to = nearest(contents, bone, chains[visit.above][depth]);
        const bool is_touching = gap(contents, bone, to) < kTouching;
        (is_touching ? forest.touching : forest.links).push_back(link_between(contents, bone, to, room));
        if (!is_touching) linked.insert(pair);
      }
    }
  }
  forest.linked.assign(linked.begin(), linked.end());
  forest.roundabout.assign(left_out.begin(), left_out.end());
  return forest;
}

}  // namespace coif::cook
