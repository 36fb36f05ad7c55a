#include "cards/choose_cards.h"

#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace coif::cards::wisps_test {

constexpr float kWidth = 0.0001f;

TEST(Ribbon, LiesAsItsStrandsSpread) {
  const EvenStrands strands = even_strands(test::hanging_wisps(1, 200), kWidth);
  std::vector<std::uint32_t> all(strands.count());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  const Ribbon ribbon = ribbon_of(strands, all);
  for (std::size_t k = 0; k < Ribbon::kStations; ++k) {
    EXPECT_NEAR(std::abs(ribbon.across[k].x()), 1, 1e-3f) << k;
    EXPECT_NEAR(ribbon.along[k].y(), -1, 1e-3f) << k;
    EXPECT_GT(ribbon.half_width[k], 0.009f);
    EXPECT_LT(ribbon.half_width[k], 0.011f);
    EXPECT_LT(ribbon.half_depth[k], 0.0006f);
  }
}

TEST(Ribbon, FramesAreUnitAtRightAnglesAndDoNotFlip) {
  const EvenStrands strands = even_strands(test::groom_of(test::strands_of_a_head(60)), kWidth);
  std::vector<std::uint32_t> all(strands.count());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  for (std::size_t first = 0; first < all.size(); first += 7) {
    const Ribbon ribbon =
        ribbon_of(strands, std::span(all).subspan(first, std::min<std::size_t>(7, all.size() - first)));
    for (std::size_t k = 0; k < Ribbon::kStations; ++k) {
      EXPECT_NEAR(ribbon.along[k].norm(), 1, 1e-5f);
      EXPECT_NEAR(ribbon.across[k].norm(), 1, 1e-5f);
      EXPECT_NEAR(ribbon.across[k].dot(ribbon.along[k]), 0, 1e-4f);
    }
  }
}

TEST(Ribbon, WhatLiesBesideItsMiddleCountsLessThanWhatLiesInFront) {
  const EvenStrands strands = even_strands(test::hanging_wisps(1, 50), kWidth);
  std::vector<std::uint32_t> all(strands.count());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  const Ribbon ribbon = ribbon_of(strands, all);
  const EvenStrands shifted =
      even_strands(test::groom_of({test::hanging({0.01f, 0, 0}, 0.3f), test::hanging({0, 0, 0.01f}, 0.3f)}), kWidth);
  EXPECT_LT(4 * distance_to(ribbon, shifted.strand(0)), distance_to(ribbon, shifted.strand(1)));
}

/// Strands of one lock: they wave together, 2 cm to both sides, and end up to 10 cm apart.
EvenStrands waving_lock() {
  std::vector<std::vector<Eigen::Vector3f>> strands;
  for (int i = 0; i < 40; ++i) {
    const float length = 0.2f + 0.1f * float(i) / 39;
    std::vector<Eigen::Vector3f> strand;
    for (int k = 0; k <= 100; ++k) {
      const float at = length * float(k) / 100;
      strand.emplace_back(0.02f * std::sin(at / 0.016f), -at, 0.0001f * float(i % 7));
    }
    strands.push_back(std::move(strand));
  }
  return even_strands(test::groom_of(strands), kWidth);
}

TEST(CardRibbon, FollowsTheWavesOfALockWhoseStrandsEndApart) {
  const EvenStrands strands = waving_lock();
  std::vector<std::uint32_t> all(strands.count());
  for (std::uint32_t i = 0; i < all.size(); ++i) all[i] = i;
  const Ribbon ribbon = card_ribbon_of(strands, all);
  float leftmost = 0, rightmost = 0, widest = 0;
  for (std::size_t k = 0; k < Ribbon::kStations; ++k) {
    leftmost = std::min(leftmost, ribbon.middle[k].x());
    rightmost = std::max(rightmost, ribbon.middle[k].x());
    widest = std::max(widest, ribbon.half_width[k]);
  }
  EXPECT_LT(leftmost, -0.015f);
  EXPECT_GT(rightmost, 0.015f);
  EXPECT_LT(widest, 0.01f) << "strands lie together wherever they are";
}

TEST(Wisps, AreTheOnesThatHangApart) {
  const EvenStrands strands = even_strands(test::hanging_wisps(7, 30), kWidth);
  const auto wisps = find_wisps(strands, 7, 2);
  ASSERT_EQ(wisps.size(), 7u);
  for (const Wisp& wisp : wisps) {
    ASSERT_EQ(wisp.members.size(), 30u);
    EXPECT_EQ(wisp.members.back() - wisp.members.front(), 29u) << "strands of one bundle follow each other";
    EXPECT_TRUE(std::ranges::is_sorted(wisp.members));
  }
}

TEST(Wisps, HoldEachStrandOnceAndRepeatWithAnyNumberOfThreads) {
  const EvenStrands strands = even_strands(test::groom_of(test::strands_of_a_head(500)), kWidth);
  const auto one = find_wisps(strands, 40, 1), four = find_wisps(strands, 40, 4);
  ASSERT_EQ(one.size(), four.size());
  std::vector<int> seen(strands.count(), 0);
  for (std::size_t w = 0; w < one.size(); ++w) {
    EXPECT_EQ(one[w].members, four[w].members);
    EXPECT_EQ(std::memcmp(&one[w].ribbon, &four[w].ribbon, sizeof(Ribbon)), 0);
    for (const std::uint32_t i : one[w].members) ++seen[i];
  }
  EXPECT_EQ(std::ranges::count(seen, 1), std::ptrdiff_t(seen.size()));
}

TEST(Wisps, MoreOfThemLoseLess) {
  const EvenStrands strands = even_strands(test::groom_of(test::strands_of_a_head(600)), kWidth);
  double before = 1e9;
  for (const std::size_t count : {5u, 20u, 80u, 320u}) {
    double lost = 0;
    for (const Wisp& wisp : find_wisps(strands, count, 2)) {
      for (const std::uint32_t i : wisp.members) lost += double(distance_to(wisp.ribbon, strands.strand(i)));
    }
    EXPECT_LT(lost, 0.7 * before) << count;
    before = lost;
  }
}

TEST(Wisps, AreNoMoreThanStrandsAndTakeCopiesOfOne) {
  const std::vector<std::vector<Eigen::Vector3f>> copies(5, test::hanging({0, 0, 0}, 0.1f));
  const auto wisps = find_wisps(even_strands(test::groom_of(copies), kWidth), 3, 1);
  ASSERT_EQ(wisps.size(), 1u);
  EXPECT_EQ(wisps[0].members.size(), 5u);
  EXPECT_TRUE(find_wisps({}, 3, 1).empty());
}

}  // namespace coif::cards::wisps_test
