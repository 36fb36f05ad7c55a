#include "visibility/order_error.h"

#include "base/parallel_for.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

namespace coif::visibility {
namespace {

constexpr double kBestPsnr = 99;

}  // namespace

double psnr_db(double squared_error, std::size_t pixels) {
  const double mean = squared_error / double(std::max<std::size_t>(pixels, 1));
  return mean > 0 ? std::min(kBestPsnr, -10 * std::log10(mean)) : kBestPsnr;
}

namespace {

constexpr std::uint32_t kDigitBits = 11;
constexpr std::size_t kFewVotes = 512;  // are sorted by comparing them

/// Sorts by one digit of a unit, counted from the lowest one; equal ones keep their order.
void sort_by_digit(std::span<const Vote> votes, std::uint32_t Vote::*unit, std::uint32_t lowest, std::uint32_t shift,
                   std::span<Vote> out) {
  constexpr std::uint32_t kDigits = 1u << kDigitBits;
  std::array<std::uint32_t, kDigits> next{};
  const auto digit_of = [&](const Vote& vote) { return (vote.*unit - lowest) >> shift & (kDigits - 1); };
  for (const Vote& vote : votes) ++next[digit_of(vote)];
  std::exclusive_scan(next.begin(), next.end(), next.begin(), 0u);
  for (const Vote& vote : votes) out[next[digit_of(vote)]++] = vote;
}

std::tuple<std::uint32_t, std::uint32_t> pair_of(const Vote& vote) { return {vote.first, vote.second}; }

/// Sorts by the first unit, then by the second; equal ones keep their order. Digit by digit, since there are many votes
/// of few units.
void sort_by_pair(std::vector<Vote>& votes) {
  if (votes.size() < kFewVotes) {
    std::ranges::stable_sort(votes, {}, pair_of);
    return;
  }
  std::vector<Vote> other(votes.size());
  for (std::uint32_t Vote::*const unit : {&Vote::second, &Vote::first}) {
    const auto [least, most] = std::ranges::minmax_element(votes, {}, unit);
    const std::uint32_t lowest = (*least).*unit, range = (*most).*unit - lowest;
    for (std::uint32_t shift = 0; shift < 32 && range >> shift > 0; shift += kDigitBits) {
      sort_by_digit(votes, unit, lowest, shift, other);
      votes.swap(other);
    }
  }
}

/// One vote per pair. Votes of a pair are added in their order, so that sums are always the same.
void merge(std::vector<Vote>& votes) {
  sort_by_pair(votes);
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
    float passes = blended[near].alpha;  // Share of the light; `near` is included below.
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

namespace {

constexpr std::size_t kVotesOfPart = 16'384;  // Fits a processor's own cache together with the sorted ones.

using VoteLists = std::span<const std::span<const Vote>>;

std::size_t count_of(VoteLists lists) {
  std::size_t count = 0;
  for (const auto& votes : lists) count += votes.size();
  return count;
}

/// First units that divide all votes into parts of about this size, judged by the longest list: each part's lowest
/// unit, and one above all.
std::vector<std::uint32_t> part_bounds(VoteLists lists) {
  const auto longest = std::ranges::max(lists, {}, [](const auto& votes) { return votes.size(); });
  const std::size_t parts = count_of(lists) / kVotesOfPart + 1;
  std::vector<std::uint32_t> bounds{0};
  for (std::size_t p = 1; p < parts; ++p) {
    const std::uint32_t unit = longest[longest.size() * p / parts].first;
    if (unit > bounds.back()) bounds.push_back(unit);
  }
  bounds.push_back(kNone);
  return bounds;
}

/// Votes of a list whose first units are at least `low` and below `high`.
std::span<const Vote> between(std::span<const Vote> votes, std::uint32_t low, std::uint32_t high) {
  const auto begin = std::ranges::lower_bound(votes, low, {}, &Vote::first);
  return {begin, std::ranges::lower_bound(begin, votes.end(), high, {}, &Vote::first)};
}

std::vector<Vote> sum_of_part(VoteLists lists) {
  std::vector<Vote> sum;
  sum.reserve(count_of(lists));
  for (const auto& votes : lists) sum.insert(sum.end(), votes.begin(), votes.end());
  merge(sum);
  return sum;
}

}  // namespace

std::vector<Vote> sum_of(VoteLists lists, const platform::Threads& threads) {
  if (count_of(lists) <= kVotesOfPart) return sum_of_part(lists);
  const std::vector<std::uint32_t> bounds = part_bounds(lists);
  std::vector<std::vector<Vote>> parts(bounds.size() - 1);
  parallel_for(parts.size(), threads, [&](std::size_t p) {
    std::vector<std::span<const Vote>> of_lists;
    for (const auto& votes : lists) of_lists.push_back(between(votes, bounds[p], bounds[p + 1]));
    parts[p] = sum_of_part(of_lists);
  });
  std::vector<Vote> all;
  all.reserve(count_of(std::vector<std::span<const Vote>>(parts.begin(), parts.end())));
  for (const std::vector<Vote>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace coif::visibility
