// Orders for the vertex cache keep what votes ask for.

#include "visibility/cache_order.h"

#include "visibility/card_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

namespace coif {
namespace {

/// Two strips of four triangles each that share no vertex; numbers of the one are even, of the other odd.
HairSurface two_strips() {
  const OpenedAsset card(card_contents(std::vector<Card>(1)));
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

}  // namespace
}  // namespace coif
