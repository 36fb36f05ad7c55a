#include "visibility/linear_order.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace coif {
namespace {

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
}

}  // namespace
}  // namespace coif
