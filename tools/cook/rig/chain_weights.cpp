#include "cook/rig/fit_chains.h"

#include <algorithm>
#include <queue>

namespace coif::cook {
namespace {

constexpr std::size_t kMostLocks = 4;  ///< Most locks that can meet in one cell.

struct LockShare {
  std::uint32_t lock = 0;
  double share = 0;  ///< While measuring: metres from the lock.
};

using LockShares = std::vector<LockShare>;

struct Front {
  double distance;
  std::uint32_t cell;
  std::uint32_t lock;
  auto operator<=>(const Front&) const = default;
};

/// The nearest locks of each cell over connected hair, nearest first: those within `blend` of the nearest.
class NearLocks {
 public:
  NearLocks(const HairCells& cells, std::span<const HairLock> locks, double blend)
      : cells_(cells), blend_(blend), near_(cells.count()) {
    for (std::uint32_t l = 0; l < locks.size(); ++l) {
      for (std::uint32_t c : locks[l].cells) settle({0, c, l});
      for (std::uint32_t c : locks[l].ways) settle({0, c, l});
    }
    for (std::uint32_t c = 0; c < cells.count(); ++c) {
      for (const LockShare& own : near_[c]) spread({0, c, own.lock});
    }
    while (!queue_.empty()) {
      const Front front = queue_.top();
      queue_.pop();
      if (settle(front)) spread(front);
    }
  }

  std::vector<LockShares> take() && { return std::move(near_); }

 private:
  /// Whether a lock at this distance still counts in a cell.
  [[nodiscard]] bool is_wanted(const Front& front) const {
    const LockShares& here = near_[front.cell];
    if (front.distance > blend_ + (here.empty() ? 0 : here.front().share) || here.size() >= kMostLocks) return false;
    return std::ranges::find(here, front.lock, &LockShare::lock) == here.end();
  }

  bool settle(const Front& front) {
    if (!is_wanted(front)) return false;
    near_[front.cell].push_back({front.lock, front.distance});
    return true;
  }

  void spread(const Front& front) {
    for (const CellLink& link : cells_.links_of(front.cell)) {
      const Front next{front.distance + link.length, link.to, front.lock};
      if (next.distance <= blend_ && is_wanted(next)) queue_.push(next);
    }
  }

  const HairCells& cells_;
  double blend_;
  std::vector<LockShares> near_;
  std::priority_queue<Front, std::vector<Front>, std::greater<>> queue_;
};

void normalize(LockShares& shares) {
  double sum = 0;
  for (const LockShare& s : shares) sum += s.share;
  for (LockShare& s : shares) s.share /= sum;
}

std::vector<LockShares> lock_shares(const HairCells& cells, std::span<const HairLock> locks, double blend) {
  std::vector<LockShares> shares = NearLocks(cells, locks, blend).take();
  for (LockShares& here : shares) {
    if (here.empty()) continue;
    const double nearest = here.front().share;
    for (LockShare& s : here) s.share = 1 - (s.share - nearest) / blend;
    normalize(here);
  }
  return shares;
}

/// Two locks with two bones each fill a vertex. The third one's share is subtracted from all: so weights stay
/// continuous where the second and the third change places.
void keep_two(LockShares& shares) {
  std::ranges::stable_sort(shares, std::greater<>{}, &LockShare::share);
  if (shares.size() <= 2) return;
  const double third = shares[2].share;
  shares.resize(2);
  if (shares[0].share > third) {
    for (LockShare& s : shares) s.share -= third;
  }
}

/// Each bone has the full weight at its middle, and its neighbour takes over towards the next one's middle; at the
/// scalp, the head does.
void add_lock(const HairLock& lock, double depth, double share, std::vector<BoneWeight>& weights) {
  const std::size_t count = lock.joint_depth.empty() ? 0 : lock.joint_depth.size() - 1;
  double middle_before = 0;
  std::uint32_t before = 0;
  for (std::size_t b = 0; b < count; ++b) {
    const double middle = 0.5 * (lock.joint_depth[b] + lock.joint_depth[b + 1]);
    const auto bone = std::uint32_t(lock.first_bone + b);
    if (depth < middle) {
      const double on = std::max(0.0, (depth - middle_before) / (middle - middle_before));
      add_weight(weights, before, share * (1 - on));
      add_weight(weights, bone, share * on);
      return;
    }
    middle_before = middle;
    before = bone;
  }
  add_weight(weights, before, share);
}

class WeightBlender {
 public:
  WeightBlender(const HangingHair& hair, std::span<const HairLock> locks, double blend)
      : hair_(hair), locks_(locks), shares_(lock_shares(hair.cells, locks, blend)) {}

  [[nodiscard]] std::vector<BoneWeight> at(std::uint32_t home, const Eigen::Vector3d& point) const {
    double depth = 0, sum = 0;
    LockShares locks;
    const auto add = [&](std::uint32_t cell) {
      const double share = hair_.cells.share_at(cell, point);
      depth += share * hair_.depth[cell];
      sum += share;
      for (const LockShare& of_cell : shares_[cell]) {
        const auto same = std::ranges::find(locks, of_cell.lock, &LockShare::lock);
        if (same != locks.end()) {
          same->share += share * of_cell.share;
        } else {
          locks.push_back({of_cell.lock, share * of_cell.share});
        }
      }
    };
    add(home);
    for (const CellLink& link : hair_.cells.links_of(home)) add(link.to);
    std::erase_if(locks, [](const LockShare& lock) { return !(lock.share > 0); });
    if (locks.empty()) return {{0, 1.0}};
    keep_two(locks);
    normalize(locks);
    std::vector<BoneWeight> weights;
    for (const LockShare& lock : locks) add_lock(locks_[lock.lock], depth / sum, lock.share, weights);
    return weights;
  }

 private:
  const HangingHair& hair_;
  std::span<const HairLock> locks_;
  std::vector<LockShares> shares_;
};

}  // namespace

SkinWeights blend_chain_weights(const HairStrips& strips, const HangingHair& hair, std::span<const HairLock> locks,
                                const std::vector<bool>& rigid, double blend) {
  const WeightBlender blender(hair, locks, blend);
  SkinWeights weights(strips.mesh.positions.size());
  for (std::uint32_t v = 0; v < weights.size(); ++v) {
    const std::uint32_t cell = hair.cells.of_vertex[v];
    if (const std::uint32_t first = strips.welded[v]; first != v) {
      weights[v] = weights[first];
    } else if (rigid[v] || cell == importer::kNoIndex) {
      weights[v] = {{0, 1.0}};
    } else {
      weights[v] = blender.at(cell, strips.mesh.positions[v].cast<double>());
    }
  }
  return weights;
}

}  // namespace coif::cook
