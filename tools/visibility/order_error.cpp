#include "visibility/order_error.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

namespace coif {
namespace {

constexpr double kBestPsnr = 99;

/// A layer in the order in which it is blended.
struct Blended {
  std::uint64_t key;
  float alpha;
  float share;  ///< Of the pixel, where depth sorts.
};

/// A solid layer hides what is behind it, which has as much of the pixel as it should have let through; as one more layer.
/// `passes`: of the light before it.
double error_of_solid(float alpha, float passes) {
  const double off = double((1 - alpha) * passes);
  return (1 + kHiddenVariance) * off * off;
}

/// Squared differences of one line. `blended` is memory that calls share.
class LineError {
 public:
  LineError(std::span<const std::uint32_t> rank, const DrawRule& rule) : rank_(rank), rule_(rule) {}

  double operator()(std::span<const Layer> line) {
    blended_.clear();
    float passes = 1;
    std::size_t i = 0;
    for (; i < line.size() && line[i].alpha < rule_.opaque_threshold; ++i) {
      blended_.push_back({key_of(line[i]), line[i].alpha, line[i].alpha * passes});
      passes *= 1 - line[i].alpha;
    }
    return error_of_blended() + (i < line.size() ? error_of_solid(line[i].alpha, passes) : 0);
  }

 private:
  [[nodiscard]] std::uint64_t key_of(const Layer& layer) const {
    const bool later = !rule_.faces_together && layer.is_front != 0;
    return std::uint64_t(later) << 32 | rank_[layer.triangle];
  }

  double error_of_blended() {
    std::ranges::stable_sort(blended_, std::greater{}, &Blended::key);
    float passes = 1;
    double error = 0;
    for (const Blended& layer : blended_) {
      const double off = double(layer.alpha * passes - layer.share);
      error += off * off;
      passes *= 1 - layer.alpha;
    }
    return error;
  }

  std::span<const std::uint32_t> rank_;
  DrawRule rule_;
  std::vector<Blended> blended_;
};

}  // namespace

double squared_error(const SightLines& lines, std::span<const std::uint32_t> rank, const DrawRule& rule) {
  LineError error_of(rank, rule);
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) sum += error_of(lines.line(i));
  return sum;
}

double threshold_error(const SightLines& lines, float opaque_threshold) {
  double sum = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    float passes = 1;
    for (const Layer& layer : lines.line(i)) {
      if (layer.alpha >= opaque_threshold) {
        sum += error_of_solid(layer.alpha, passes);
        break;
      }
      passes *= 1 - layer.alpha;
    }
  }
  return sum;
}

double psnr_db(double squared_error, std::size_t pixels) {
  const double mean = kColorSpread * kColorSpread * squared_error / double(std::max<std::size_t>(pixels, 1));
  return mean > 0 ? std::min(kBestPsnr, -10 * std::log10(mean)) : kBestPsnr;
}

namespace {

/// One vote per pair. Votes of a pair are added in the order in which they came, so that sums are always the same.
void merge(std::vector<Vote>& votes) {
  const auto pair_of = [](const Vote& vote) { return std::tuple(vote.first, vote.second); };
  std::ranges::stable_sort(votes, {}, pair_of);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < votes.size();) {
    Vote sum = votes[i];
    double weight = 0;
    for (; i < votes.size() && pair_of(votes[i]) == pair_of(sum); ++i) weight += double(votes[i].weight);
    sum.weight = float(weight);
    if (sum.weight != 0) votes[kept++] = sum;
  }
  votes.resize(kept);
}

Vote vote_of(std::uint32_t before, std::uint32_t after, float weight) {
  return before < after ? Vote{before, after, weight} : Vote{after, before, -weight};
}

/// Adds the votes of one line's blended layers.
void vote(std::span<const Layer> blended, std::span<const std::uint32_t> unit_of, bool faces_together,
          std::vector<Vote>& votes) {
  for (std::size_t near = 0; near + 1 < blended.size(); ++near) {
    float passes = blended[near].alpha;  // of the light before `near` comes in below
    for (std::size_t i = 0; i < near; ++i) passes *= 1 - blended[i].alpha;
    const std::uint32_t over = unit_of[blended[near].triangle];
    for (std::size_t far = near + 1; far < blended.size(); ++far) {
      const float loss = passes * blended[far].alpha;
      passes *= 1 - blended[far].alpha;
      const std::uint32_t under = unit_of[blended[far].triangle];
      const bool in_one_go = faces_together || blended[near].is_front == blended[far].is_front;
      if (under == over || !in_one_go) continue;
      votes.push_back(vote_of(under, over, loss * loss));
    }
  }
}

}  // namespace

std::vector<Vote> votes_of(const SightLines& lines, std::span<const std::uint32_t> unit_of_triangle,
                           const DrawRule& rule) {
  std::vector<Vote> votes;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto line = lines.line(i);
    std::size_t count = 0;
    while (count < line.size() && line[count].alpha < rule.opaque_threshold) ++count;
    vote(line.first(count), unit_of_triangle, rule.faces_together, votes);
  }
  merge(votes);
  return votes;
}

std::vector<Vote> votes_of_groups(std::span<const Vote> votes, std::span<const std::uint32_t> group_of) {
  std::vector<Vote> of_groups;
  for (const Vote& vote : votes) {
    const std::uint32_t before = group_of[vote.first], after = group_of[vote.second];
    if (before != after) of_groups.push_back(vote_of(before, after, vote.weight));
  }
  merge(of_groups);
  return of_groups;
}

std::vector<Vote> sum_of(std::span<const std::vector<Vote>> lists) {
  std::vector<Vote> all;
  for (const std::vector<Vote>& votes : lists) all.insert(all.end(), votes.begin(), votes.end());
  merge(all);
  return all;
}

}  // namespace coif
