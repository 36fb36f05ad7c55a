#include "cook/recipe/rig_recipe.h"
#include "cook/rig/fit_chains.h"
#include "cook/rig/hair_cells.h"
#include "cook/select/mesh_topology.h"
#include "platform/stop.h"

#include <algorithm>
#include <array>
#include <limits>

namespace coif::cook {
namespace {

using Eigen::Vector3d;

constexpr std::size_t kMostTips = 400;  ///< Pairs of strands are compared, so that there must not be many.
constexpr double kTipsApart = 0.25;     ///< Share of the head's radius: nearer ripples of one edge count as one tip.
/// Share of the head's radius: strands up to this mean distance form one lock.
constexpr double kLockWidth = 0.8;
/// The same as a share of their common length, if that is more: long hair is thicker.
constexpr double kSlenderness = 0.25;
/// Weight of distances at the root: a pony tail fans out but stays one lock.
constexpr double kRootShare = 0.5;
constexpr double kGap = 1.5;         ///< Extra distance of strands with a gap between them all the way, as a share.
constexpr std::size_t kLevels = 24;  ///< Steps of depth at which strands are compared.

/// The way of one tip to the scalp, at equal steps of depth.
struct Strand {
  std::array<Vector3d, kLevels> at;
  std::array<std::uint32_t, kLevels> piece;  ///< The piece of the hair at each level; gaps cut hair into pieces.
  std::size_t levels = 0;                    ///< Filled of the two above, at least one.
};

/// For each cell, the connected piece of hair within its level of depth.
std::vector<std::uint32_t> pieces_of_levels(const HangingHair& hair, double step) {
  const auto level = [&](std::uint32_t c) { return std::size_t(hair.depth[c] / step); };
  DisjointSets sets(hair.cells.count());
  for (std::uint32_t c = 0; c < hair.cells.count(); ++c) {
    if (hair.depth[c] <= 0) continue;
    for (const CellLink& link : hair.cells.links_of(c)) {
      if (hair.depth[link.to] > 0 && level(link.to) == level(c)) sets.unite(c, link.to);
    }
  }
  std::vector<std::uint32_t> piece(hair.cells.count());
  for (std::uint32_t c = 0; c < hair.cells.count(); ++c) piece[c] = sets.find(c);
  return piece;
}

Strand strand_of(const HangingHair& hair, const std::vector<std::uint32_t>& piece, std::uint32_t tip, double step) {
  Strand strand;
  std::size_t lowest = kLevels;
  for (std::uint32_t c = tip; c != importer::kNoIndex && hair.depth[c] > 0; c = hair.from[c]) {
    const auto level = std::min(std::size_t(hair.depth[c] / step), kLevels - 1);
    if (strand.levels == 0) strand.levels = level + 1;
    // Levels that no cell of the way falls into take the one below.
    for (std::size_t l = level; l < std::min(lowest, strand.levels); ++l) {
      strand.at[l] = hair.cells.middle[c];
      strand.piece[l] = piece[c];
    }
    lowest = level;
  }
  for (std::size_t l = 0; l < std::min(lowest, strand.levels); ++l) {
    strand.at[l] = strand.at[lowest];
    strand.piece[l] = strand.piece[lowest];
  }
  return strand;
}

/// Distance of two strands, at most 1 within a lock. `step`: metres of depth between levels.
double distance_of(const Strand& a, const Strand& b, double head_radius, double step) {
  const std::size_t levels = std::min(a.levels, b.levels);
  double sum = 0, together = 0;
  for (std::size_t l = 0; l < levels; ++l) {
    sum += (a.at[l] - b.at[l]).norm();
    together += a.piece[l] == b.piece[l] ? 1 : 0;
  }
  const double mean = sum / double(levels), at_root = (a.at[0] - b.at[0]).norm();
  const double gaps = 1 - together / double(levels);
  const double distance = (kRootShare * at_root + (1 - kRootShare) * mean) * (1 + kGap * gaps);
  return distance / std::max(kLockWidth * head_radius, kSlenderness * double(levels) * step);
}

/// Complete linkage: the distance of two groups is that of their two farthest strands, so groups stay narrow.
class StrandGroups {
 public:
  template <typename Distance>
  StrandGroups(std::vector<double> length, const Distance& distance, const std::stop_token& stop)
      : stop_(stop), length_(std::move(length)), group_(length_.size()), distance_(length_.size() * length_.size(), 0) {
    for (std::size_t i = 0; i < length_.size(); ++i) {
      group_[i] = i;
      for (std::size_t j = 0; j < i; ++j) at(i, j) = at(j, i) = distance(i, j);
    }
  }

  void merge_up_to(double limit) {
    const auto distance = [&](std::size_t i, std::size_t j) { return at(i, j); };
    while (merge_best(distance, limit, 0)) platform::throw_if_stopped(stop_);
  }

  /// Merges near and short groups first, until at most `most` groups are longer than `shortest`.
  void merge_down_to(std::size_t most, double shortest) {
    const auto loss = [&](std::size_t i, std::size_t j) { return at(i, j) * std::min(length_[i], length_[j]); };
    while (count_longer(shortest) > most && merge_best(loss, std::numeric_limits<double>::max(), shortest))
      platform::throw_if_stopped(stop_);
  }

  [[nodiscard]] std::size_t group_of(std::size_t strand) const { return group_[strand]; }

 private:
  double& at(std::size_t i, std::size_t j) { return distance_[i * group_.size() + j]; }
  [[nodiscard]] bool is_group(std::size_t i) const { return group_[i] == i; }

  [[nodiscard]] std::size_t count_longer(double shortest) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < group_.size(); ++i) count += is_group(i) && length_[i] >= shortest ? 1 : 0;
    return count;
  }

  /// Merges the cheapest pair of groups that are longer than `shortest`, if its cost is at most `limit`.
  template <typename Cost>
  bool merge_best(const Cost& cost, double limit, double shortest) {
    std::size_t best_i = 0, best_j = 0;
    double least = limit;
    for (std::size_t i = 0; i < group_.size(); ++i) {
      if (!is_group(i) || length_[i] < shortest) continue;
      for (std::size_t j = 0; j < i; ++j) {
        if (!is_group(j) || length_[j] < shortest || cost(i, j) > least) continue;
        if (cost(i, j) == least && best_i != best_j) continue;
        least = cost(i, j);
        best_i = i;
        best_j = j;
      }
    }
    if (best_i == best_j) return false;
    merge(best_j, best_i);
    return true;
  }

  void merge(std::size_t into, std::size_t from) {
    for (std::size_t k = 0; k < group_.size(); ++k) {
      if (group_[k] == from) group_[k] = into;
      at(into, k) = at(k, into) = std::max(at(into, k), at(from, k));
    }
    length_[into] = std::max(length_[into], length_[from]);
  }

  const std::stop_token& stop_;
  std::vector<double> length_;
  std::vector<std::size_t> group_;  ///< For each strand, its group's first strand.
  std::vector<double> distance_;
};

/// Tips with their groups as locks, in the order of their longest strand.
std::vector<HairLock> collect_locks(const HangingHair& hair, const StrandTips& tips, const StrandGroups& groups,
                                    double shortest) {
  std::vector<HairLock> locks;
  std::vector<std::uint32_t> lock_of_group(tips.cell.size(), importer::kNoIndex), lock_of_tip;
  for (std::size_t t = 0; t < tips.cell.size(); ++t) {
    std::uint32_t& lock = lock_of_group[groups.group_of(t)];
    if (lock == importer::kNoIndex) {
      lock = std::uint32_t(locks.size());
      locks.emplace_back();
    }
    lock_of_tip.push_back(lock);
    for (std::uint32_t c = tips.cell[t]; c != importer::kNoIndex; c = hair.from[c]) locks[lock].ways.push_back(c);
  }
  for (std::uint32_t c = 0; c < hair.cells.count(); ++c) {
    if (tips.of_cell[c] != importer::kNoIndex) locks[lock_of_tip[tips.of_cell[c]]].cells.push_back(c);
  }
  for (HairLock& lock : locks) {
    std::ranges::sort(lock.ways);
    lock.ways.erase(std::ranges::unique(lock.ways).begin(), lock.ways.end());
    for (std::uint32_t c : lock.cells) lock.length = std::max(lock.length, hair.depth[c]);
    lock.moves = lock.length >= shortest;
  }
  return locks;
}

}  // namespace

std::vector<HairLock> group_locks(const HangingHair& hair, double head_radius, const RigRecipe& recipe,
                                  const std::stop_token& stop) {
  const StrandTips tips = find_strand_tips(hair, kTipsApart * head_radius, kMostTips);
  if (tips.cell.empty()) return {};
  const double step = std::max(hair.depth[tips.cell.front()] / double(kLevels), 1.0e-9);
  const std::vector<std::uint32_t> piece = pieces_of_levels(hair, step);
  std::vector<Strand> strands;
  std::vector<double> length;
  for (std::uint32_t tip : tips.cell) {
    strands.push_back(strand_of(hair, piece, tip, step));
    length.push_back(hair.depth[tip]);
  }
  StrandGroups groups(
      length, [&](std::size_t i, std::size_t j) { return distance_of(strands[i], strands[j], head_radius, step); },
      stop);
  groups.merge_up_to(1);
  groups.merge_down_to(recipe.chain_max_count, recipe.chain_shortest);
  return collect_locks(hair, tips, groups, recipe.chain_shortest);
}

}  // namespace coif::cook
