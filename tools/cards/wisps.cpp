#include "cards/choose_cards.h"

#include "base/parallel_for.h"
#include "cards/cluster_points.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace coif::cards {
namespace {

constexpr std::size_t kSample = 16384;  // strands that find the cards
constexpr int kRounds = 12;
constexpr float kLeastGain = 0.002f;  // Share of the whole distance: further rounds change nothing visible.

float squared_distance(std::span<const Eigen::Vector3f> a, std::span<const Eigen::Vector3f> b) {
  float sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += (a[k] - b[k]).squaredNorm();
  return sum / float(a.size());
}

/// The nearest ribbon of each strand of `which`, and the sum of the distances.
struct Assignment {
  std::vector<std::uint32_t> ribbon_of;
  double distance = 0;
};

/// The nearest ribbon, and how far. `guess` is looked at first: the nearer it is, the sooner others are out.
std::pair<std::uint32_t, float> nearest_ribbon(const std::vector<Ribbon>& ribbons,
                                               std::span<const Eigen::Vector3f> strand, std::uint32_t guess) {
  std::pair<std::uint32_t, float> best(guess, distance_to(ribbons[guess], strand));
  for (std::uint32_t r = 0; r < ribbons.size(); ++r) {
    const float distance = distance_to(ribbons[r], strand, best.second);
    if (distance < best.second) best = {r, distance};
  }
  return best;
}

Assignment assign(const EvenStrands& strands, std::span<const std::uint32_t> which, const std::vector<Ribbon>& ribbons,
                  std::span<const std::uint32_t> guesses, const platform::Threads& threads) {
  Assignment out;
  out.ribbon_of.resize(which.size());
  std::vector<float> distances(which.size());
  parallel_for(which.size(), threads, [&](std::size_t i) {
    const auto [ribbon, distance] = nearest_ribbon(ribbons, strands.strand(which[i]), guesses.empty() ? 0 : guesses[i]);
    out.ribbon_of[i] = ribbon;
    distances[i] = distance;
  });
  out.distance = std::accumulate(distances.begin(), distances.end(), 0.0);
  return out;
}

std::vector<std::vector<std::uint32_t>> members_of(std::span<const std::uint32_t> which, const Assignment& assignment,
                                                   std::size_t count) {
  std::vector<std::vector<std::uint32_t>> members(count);
  for (std::size_t i = 0; i < which.size(); ++i) members[assignment.ribbon_of[i]].push_back(which[i]);
  std::erase_if(members, [](const auto& list) { return list.empty(); });
  return members;
}

std::vector<Ribbon> ribbons_of(const EvenStrands& strands, const std::vector<std::vector<std::uint32_t>>& members,
                               const platform::Threads& threads) {
  std::vector<Ribbon> ribbons(members.size());
  parallel_for(members.size(), threads, [&](std::size_t i) { ribbons[i] = ribbon_of(strands, members[i]); });
  return ribbons;
}

}  // namespace

std::vector<Wisp> find_wisps(const EvenStrands& strands, std::size_t count, const platform::Threads& threads) {
  if (strands.count() == 0 || count == 0) return {};
  std::vector<std::uint32_t> all(strands.count());
  std::iota(all.begin(), all.end(), 0u);
  std::vector<std::uint32_t> sample = all;
  if (all.size() > kSample) {
    for (std::size_t i = 0; i < kSample; ++i) sample[i] = std::uint32_t(i * all.size() / kSample);
    sample.resize(kSample);
  }
  std::vector<Ribbon> ribbons;
  const auto apart = [&](std::uint32_t i, std::uint32_t k) {
    return squared_distance(strands.strand(sample[i]), strands.strand(sample[k]));
  };
  for (const std::uint32_t seed : spread_seeds(sample.size(), std::min(count, sample.size()), apart)) {
    ribbons.push_back(ribbon_of(strands, std::span(&sample[seed], 1)));
  }
  std::vector<std::uint32_t> guesses;
  double before = std::numeric_limits<double>::max();
  for (int round = 0; round < kRounds; ++round) {
    const Assignment found = assign(strands, sample, ribbons, guesses, threads);
    if (found.distance > (1 - double(kLeastGain)) * before) break;
    before = found.distance;
    const auto members = members_of(sample, found, ribbons.size());
    ribbons = ribbons_of(strands, members, threads);
    const bool is_numbered_alike = std::size_t(std::ranges::max(found.ribbon_of)) + 1 == ribbons.size();
    guesses = is_numbered_alike ? found.ribbon_of : std::vector<std::uint32_t>();
  }
  const auto members = members_of(all, assign(strands, all, ribbons, {}, threads), ribbons.size());
  std::vector<Wisp> wisps(members.size());
  parallel_for(wisps.size(), threads, [&](std::size_t i) {
    wisps[i] = {members[i], card_ribbon_of(strands, members[i])};
  });
  return wisps;
}

}  // namespace coif::cards
