#include "visibility/linear_order.h"
#include "models/card_asset.h"
#include "visibility/order_error.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace coif::visibility::linear_order_test {

UnitOrder counted(std::uint32_t count) {
  UnitOrder order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

/// Votes of every pair of a tenth of all, of either sign; the same for equal seeds.
std::vector<Vote> mixed_votes(std::uint32_t units, std::uint32_t seed) {
  std::vector<Vote> votes;
  for (std::uint32_t a = 0; a < units; ++a) {
    for (std::uint32_t b = a + 1; b < units; ++b) {
      seed = seed * 1664525u + 1013904223u;
      if (seed >> 28 != 0) continue;
      votes.push_back({a, b, float(int(seed >> 8 & 0xFFFF)) - 32768.0f});
    }
  }
  return votes;
}

TEST(LinearOrder, LostVotesAreThoseOfPairsInTheWrongOrder) {
  const std::vector<Vote> votes = {{0, 1, 2.0f}, {1, 2, -3.0f}};
  EXPECT_EQ(votes_against(votes, UnitOrder{0, 2, 1}), 0);
  EXPECT_EQ(votes_against(votes, UnitOrder{1, 0, 2}), 5);
  EXPECT_EQ(votes_against(votes, UnitOrder{0, 1, 2}), 3);
}

TEST(LinearOrder, FindsTheOrderOnWhichAllVotesAgree) {
  constexpr std::uint32_t kUnits = 50;
  UnitOrder wanted = counted(kUnits);
  std::ranges::sort(wanted, {}, [](std::uint32_t u) { return u * 37 % kUnits; });
  std::vector<Vote> votes;
  for (std::uint32_t i = 0; i < kUnits; ++i) {
    for (std::uint32_t k = i + 1; k < kUnits; ++k) {
      const auto [low, high] = std::minmax(wanted[i], wanted[k]);
      votes.push_back({low, high, wanted[i] == low ? 1.0f : -1.0f});
    }
  }
  EXPECT_EQ(improve_order(votes, counted(kUnits)), wanted);
  EXPECT_EQ(order_by_sums(votes, counted(kUnits)), wanted);
}

TEST(LinearOrder, NeverLosesMoreThanItsStartAndKeepsEveryUnit) {
  for (std::uint32_t seed = 1; seed <= 20; ++seed) {
    const std::vector<Vote> votes = mixed_votes(60, seed);
    const UnitOrder start = order_by_sums(votes, counted(60));
    UnitOrder better = improve_order(votes, start);
    EXPECT_LE(votes_against(votes, better), votes_against(votes, start));
    EXPECT_LE(votes_against(votes, improve_order(votes, counted(60))), votes_against(votes, counted(60)));
    std::ranges::sort(better);
    EXPECT_EQ(better, counted(60));
  }
}

TEST(LinearOrder, NoSingleMoveImprovesTheResult) {
  const std::vector<Vote> votes = mixed_votes(25, 7);
  const UnitOrder best = improve_order(votes, counted(25));
  const double least = votes_against(votes, best);
  for (std::size_t from = 0; from < best.size(); ++from) {
    for (std::size_t to = 0; to < best.size(); ++to) {
      UnitOrder moved = best;
      const std::uint32_t unit = moved[from];
      moved.erase(moved.begin() + std::ptrdiff_t(from));
      moved.insert(moved.begin() + std::ptrdiff_t(to), unit);
      EXPECT_GE(votes_against(votes, moved), least * (1 - 1.0e-6)) << from << " to " << to;
    }
  }
}

TEST(LinearOrder, UnitsWithoutVotesStayInOrder) {
  const std::vector<Vote> votes = {{1, 3, -1.0f}};
  UnitOrder order = improve_order(votes, counted(5));
  EXPECT_LT(std::ranges::find(order, 3u), std::ranges::find(order, 1u));
  std::erase_if(order, [](std::uint32_t unit) { return unit % 2 == 1; });
  EXPECT_EQ(order, (UnitOrder{0, 2, 4}));
  EXPECT_EQ(improve_order({}, UnitOrder{4, 2, 0}), (UnitOrder{4, 2, 0})) << "units need not be all";
  const std::vector<Vote> others = {{0, 2, 1.0f}, {1, 2, 9.0f}, {2, 3, -9.0f}};
  EXPECT_EQ(improve_order(others, UnitOrder{4, 2, 0}), (UnitOrder{4, 0, 2})) << "votes on others do not count";
}

// Which pairs of layers vote, and with what weight.

/// One line with these layers, nearest first.
SightLines line_of(std::initializer_list<Layer> layers) {
  SightLines lines;
  lines.layers = layers;
  lines.begin = {0, std::uint32_t(layers.size())};
  lines.covered = 1;
  return lines;
}

Layer layer(std::uint32_t triangle, float alpha, bool is_front = true) {
  return {alpha, triangle & 0xFFu, is_front ? 1u : 0u};
}

const std::vector<std::uint32_t> kOwnUnits = {0, 1, 2, 3};
const DrawRule kApart{0.95f, false}, kTogether{0.95f, true};

TEST(OrderVotes, WhatIsFurtherComesFirst) {
  const auto votes = votes_of(line_of({layer(2, 0.5f), layer(1, 0.4f)}), kOwnUnits, kApart);
  ASSERT_EQ(votes.size(), 1u);
  EXPECT_EQ(votes[0].first, 1u);
  EXPECT_EQ(votes[0].second, 2u);
  EXPECT_FLOAT_EQ(votes[0].weight, 0.2f * 0.2f) << "the square of both alphas";
  const auto other = votes_of(line_of({layer(1, 0.5f), layer(2, 0.4f)}), kOwnUnits, kApart);
  ASSERT_EQ(other.size(), 1u);
  EXPECT_FLOAT_EQ(other[0].weight, -0.04f) << "against the lower number first";
}

TEST(OrderVotes, LayersBeforeAndBetweenDimThem) {
  const auto votes = votes_of(line_of({layer(0, 0.5f), layer(1, 0.4f), layer(2, 0.2f)}), kOwnUnits, kApart);
  ASSERT_EQ(votes.size(), 3u);
  EXPECT_FLOAT_EQ(votes[0].weight, -0.04f) << "0 over 1";
  EXPECT_FLOAT_EQ(votes[1].weight, -(0.5f * 0.6f * 0.2f) * (0.5f * 0.6f * 0.2f)) << "0 over 2, behind 1";
  EXPECT_FLOAT_EQ(votes[2].weight, -(0.5f * 0.4f * 0.2f) * (0.5f * 0.4f * 0.2f)) << "1 over 2, both behind 0";
}

TEST(OrderVotes, FacesDrawnApartDoNotVoteOnEachOther) {
  const SightLines lines = line_of({layer(0, 0.5f, true), layer(1, 0.5f, false), layer(2, 0.5f, true)});
  const auto apart = votes_of(lines, kOwnUnits, kApart);
  ASSERT_EQ(apart.size(), 1u);
  EXPECT_EQ(apart[0].first, 0u);
  EXPECT_EQ(apart[0].second, 2u);
  EXPECT_EQ(votes_of(lines, kOwnUnits, kTogether).size(), 3u);
}

TEST(OrderVotes, OfGroupsAreThoseOfTheirMembers) {
  const SightLines lines = line_of({layer(2, 0.5f), layer(0, 0.4f), layer(3, 0.7f), layer(1, 0.2f)});
  const std::vector<std::uint32_t> groups = {1, 0, 0, 1};
  const auto of_groups = votes_of_groups(votes_of(lines, kOwnUnits, kTogether), groups);
  const auto wanted = votes_of(lines, groups, kTogether);
  ASSERT_EQ(of_groups.size(), 1u);
  ASSERT_EQ(wanted.size(), 1u);
  EXPECT_EQ(of_groups[0].first, wanted[0].first);
  EXPECT_EQ(of_groups[0].second, wanted[0].second);
  EXPECT_FLOAT_EQ(of_groups[0].weight, wanted[0].weight);
}

TEST(OrderVotes, AUnitDoesNotVoteOnItself) {
  const std::vector<std::uint32_t> units = {0, 0, 1, 1};
  EXPECT_TRUE(votes_of(line_of({layer(0, 0.5f), layer(1, 0.5f)}), units, kApart).empty());
  EXPECT_EQ(votes_of(line_of({layer(0, 0.5f), layer(1, 0.5f), layer(3, 0.5f)}), units, kApart).size(), 1u);
}

TEST(OrderVotes, SolidLayersAreSortedByDepthAndHideWhatIsBehind) {
  const SightLines lines = line_of({layer(0, 0.5f), layer(1, 0.96f), layer(2, 0.5f)});
  EXPECT_TRUE(votes_of(lines, kOwnUnits, kApart).empty());
  EXPECT_EQ(votes_of(lines, kOwnUnits, {0.97f, false}).size(), 3u) << "none is solid";
}

TEST(OrderVotes, VotesOfAPairAddUpAndMayCancel) {
  const std::vector<Vote> one = {{0, 1, 2.0f}, {1, 2, 1.0f}}, other = {{0, 1, -2.0f}, {1, 2, 0.5f}};
  const auto sum = sum_of(std::vector<std::span<const Vote>>{one, other});
  ASSERT_EQ(sum.size(), 1u);
  EXPECT_EQ(sum[0].first, 1u);
  EXPECT_FLOAT_EQ(sum[0].weight, 1.5f);
}

TEST(OrderVotes, ManyAddUpAsFewDoWhateverTheNumberOfThreads) {
  const std::vector<Vote> one = mixed_votes(1200, 3), other = mixed_votes(900, 8), none;
  std::map<std::pair<std::uint32_t, std::uint32_t>, float> wanted;
  for (const std::vector<Vote>* votes : {&one, &other}) {
    for (const Vote& vote : *votes) wanted[{vote.first, vote.second}] += vote.weight;
  }
  std::erase_if(wanted, [](const auto& pair) { return pair.second == 0; });
  const std::vector<std::span<const Vote>> lists = {one, none, other};
  for (const unsigned threads : {1u, 3u}) {
    const std::vector<Vote> sum = sum_of(lists, threads);
    ASSERT_EQ(sum.size(), wanted.size());
    auto pair = wanted.begin();
    for (std::size_t i = 0; i < sum.size(); ++i, ++pair) {
      ASSERT_EQ(std::pair(sum[i].first, sum[i].second), pair->first) << "sorted, one of each";
      ASSERT_EQ(sum[i].weight, pair->second);
    }
  }
}

TEST(OrderError, PsnrFallsByTenPerTenfoldError) {
  EXPECT_NEAR(psnr_db(0.1, 10) - psnr_db(1, 10), 10, 1.0e-9);
  EXPECT_NEAR(psnr_db(1, 100), psnr_db(0.1, 10), 1.0e-9);
  EXPECT_EQ(psnr_db(0, 10), 99);
  EXPECT_EQ(psnr_db(0, 0), 99);
}

// Orders for the vertex cache keep what votes ask for.

/// Two strips of four triangles each that share no vertex; numbers of the one are even, of the other odd.
HairSurface two_strips() {
  const lab::OpenedAsset card(card_contents(std::vector<Card>(1)));
  HairSurface hair(card.asset());
  hair.triangles.clear();
  for (std::uint32_t t = 0; t < 8; ++t) {
    const std::uint32_t first = t / 2 + 6 * (t % 2);
    hair.triangles.push_back({{first, first + 1, first + 2}, t % 2});
  }
  hair.uvs.resize(12);
  return hair;
}

UnitOrder alternating() {
  UnitOrder order(8);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

TEST(CacheOrder, TrianglesThatShareVerticesComeTogetherWhereNothingSpeaksAgainst) {
  const UnitOrder order = order_for_cache(two_strips(), {}, alternating());
  EXPECT_EQ(order, (UnitOrder{0, 2, 4, 6, 1, 3, 5, 7}));
}

TEST(CacheOrder, WhatVotesSpeakOfKeepsItsOrder) {
  const Vote votes[] = {{1, 2, 1.0f}, {3, 6, -0.5f}};  // whichever way they point
  const UnitOrder order = order_for_cache(two_strips(), votes, alternating());
  EXPECT_TRUE(std::ranges::is_permutation(order, alternating()));
  const auto place = [&](std::uint32_t t) { return std::ranges::find(order, t) - order.begin(); };
  EXPECT_LT(place(1), place(2));
  EXPECT_LT(place(3), place(6));
}

}  // namespace coif::visibility::linear_order_test
