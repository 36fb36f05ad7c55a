// Orders that are found for cards whose right order is known.

#include "visibility/order_search.h"

#include "models/card_asset.h"

#include <coif/view_cells.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace coif::visibility::order_search_test {

UnitOrder counted(std::size_t count) {
  UnitOrder order(count);
  std::iota(order.begin(), order.end(), 0u);
  return order;
}

struct Searched {
  explicit Searched(const AssetContents& contents, OrderSearchSettings settings = {}) {
    settings.views_per_cell = 4;
    settings.lines_per_view = 400;
    const lab::OpenedAsset opened(contents);
    const std::vector<HairPositions> poses = {posed_positions(opened.asset(), {})};
    const SeenHair hair(opened.asset());
    const UnitOrder start = counted(opened.asset().patches().size());
    found = search_orders(hair.surface, judged_hair(hair, poses, settings), poses, start, settings);
  }
  FoundOrders found;
};

/// Cards one behind the other, the nearest to +Z first: the worst order as seen from there.
std::vector<Card> stack(int count) {
  std::vector<Card> cards;
  for (int i = 0; i < count; ++i) cards.push_back({.center = {0, 0, -0.02f * float(i)}, .alpha = 150});
  return cards;
}

/// Leaves around a ball in two layers, outer ones first and the inner ones dark; what is behind the ball is hidden.
AssetContents two_shells() {
  constexpr int kLight = 150, kDark = 140;
  std::vector<Card> cards;
  for (const float radius : {0.13f, 0.11f}) {
    for (int i = 0; i < 12; ++i) {
      const auto angle = float(2 * std::numbers::pi * i / 12);
      const Eigen::Vector3f out(std::sin(angle), 0, std::cos(angle)), side(out.z(), 0, -out.x());
      const int alpha = radius > 0.12f ? kLight : kDark;
      cards.push_back({.center = radius * out, .right = 0.04f * side, .up = {0, 0.06f, 0}, .alpha = alpha});
    }
  }
  AssetContents contents = card_contents(cards);
  for (std::size_t k = 0; k < 3; ++k) contents.texels[4 * std::size_t{kDark} + k] = std::byte{20};
  add_ball(contents, {0, 0, 0}, 0.1f);
  return contents;
}

TEST(OrderSearch, InnerShellsComeFirstWhereTheHeadHidesTheOtherSide) {
  OrderSearchSettings settings;
  settings.max_orders = 1;
  const FoundOrders found = Searched(two_shells(), settings).found;
  UnitOrder place(24);
  for (std::uint32_t i = 0; i < 24; ++i) place[found.patches[i]] = i;
  for (std::uint32_t outer = 0; outer < 12; ++outer) {
    for (const std::uint32_t step : {11u, 0u, 1u}) {
      EXPECT_LT(place[12 + (outer + step) % 12], place[outer]) << "what lies below " << outer;
    }
  }
  EXPECT_GT(found.single.psnr, found.head.psnr + 3);
}

TEST(OrderSearch, StackOfCardsNeedsAnOrderFromEachSide) {
  const FoundOrders found = Searched(card_contents(stack(4))).found;
  ASSERT_GE(found.by_view.orders.size(), 2u);
  EXPECT_GT(found.found.psnr, found.single.psnr + 10);
  for (const float side : {1.0f, -1.0f}) {
    const float towards_eye[3] = {0.1f, 0.1f, side};
    const UnitOrder& order = found.by_view.orders[found.by_view.order_of[view_cell(towards_eye)]];
    const auto first_of = [&](std::uint32_t card) {
      return std::ranges::find_if(order, [&](std::uint32_t t) { return t / 2 == card; }) - order.begin();
    };
    EXPECT_EQ(first_of(3) < first_of(0), side > 0) << "the furthest comes first, from side " << side;
  }
}

TEST(OrderSearch, CardsThatCrossAreDrawnByTheirHalves) {
  std::vector<Card> cards = {{.alpha = 150}, {.right = {0, 0, 0.1f}, .alpha = 150}};
  OrderSearchSettings settings;
  settings.faces_together = true;
  const FoundOrders found = Searched(card_contents(cards), settings).found;
  EXPECT_GT(found.found.psnr, found.single.psnr + settings.min_gain);
  EXPECT_LE(found.found.psnr, found.limit);
}

TEST(OrderSearch, ResultIsNeverWorseThanByDistance) {
  for (const AssetContents& contents :
       {two_shells(), card_contents(stack(1)), card_contents(stack(2)), card_contents(stack(7))}) {
    for (const std::size_t most : {1u, 2u, 8u}) {
      OrderSearchSettings settings;
      settings.max_orders = most;
      const FoundOrders found = Searched(contents, settings).found;
      EXPECT_GE(found.found.psnr, found.head.psnr);
      EXPECT_LE(found.by_view.orders.size() + 1, most);
      EXPECT_TRUE(std::ranges::is_permutation(found.patches, counted(contents.patches.size())));
      for (const UnitOrder& order : found.by_view.orders) {
        EXPECT_TRUE(std::ranges::is_permutation(order, counted(contents.indices.size() / 3)));
      }
    }
  }
}

TEST(OrderSearch, FurtherOrdersMustGainEnough) {
  OrderSearchSettings settings;
  settings.min_gain = 1000;
  EXPECT_TRUE(Searched(card_contents(stack(4)), settings).found.by_view.orders.empty());
}

TEST(OrderSearch, RefiningKeepsFacesAndDoesNotLose) {
  const lab::OpenedAsset opened(two_shells());
  const SeenHair hair(opened.asset());
  const std::vector<HairPositions> poses = {posed_positions(opened.asset(), {})};
  OrderSearchSettings settings;
  settings.views_per_cell = 1;
  settings.lines_per_view = 200;
  const FoundOrders quick =
      search_orders(hair.surface, judged_hair(hair, poses, settings), poses, counted(24), settings);
  ASSERT_FALSE(quick.by_view.orders.empty());
  settings.views_per_cell = 4;
  settings.lines_per_view = 400;
  const JudgedHair judged = judged_hair(hair, poses, settings);
  const FoundOrders refined = refine_orders(hair.surface, judged, poses, counted(24), quick, settings);
  EXPECT_EQ(refined.rule.faces_together, quick.rule.faces_together);
  EXPECT_LE(refined.by_view.orders.size(), quick.by_view.orders.size());
  EXPECT_GE(refined.found.psnr, judge_orders(hair.surface, judged, quick, settings).psnr);
}

TEST(OrderSearch, JudgesByTheThresholdThatIsAskedFor) {
  const lab::OpenedAsset opened(card_contents(stack(1)));
  const SeenHair hair(opened.asset());
  const std::vector<HairPositions> poses = {posed_positions(opened.asset(), {})};
  OrderSearchSettings settings;
  settings.max_orders = 1;
  settings.lines_per_view = 400;
  const JudgedHair judged = judged_hair(hair, poses, settings);
  const FoundOrders found = search_orders(hair.surface, judged, poses, counted(1), settings);
  EXPECT_EQ(judge_orders(hair.surface, judged, found, settings).psnr, found.found.psnr);
  settings.opaque_threshold = 0.55f;  // less than the card's alpha: it hides what is behind
  EXPECT_LT(judge_orders(hair.surface, judged, found, settings).psnr, found.found.psnr - 10);
}

TEST(OrderSearch, ThreadsDoNotChangeTheResult) {
  OrderSearchSettings settings;
  const FoundOrders one = Searched(two_shells(), settings).found;
  settings.threads = 3;
  const FoundOrders three = Searched(two_shells(), settings).found;
  EXPECT_EQ(one.patches, three.patches);
  EXPECT_EQ(one.by_view.orders, three.by_view.orders);
  EXPECT_EQ(one.by_view.order_of, three.by_view.order_of);
  EXPECT_EQ(one.found.psnr, three.found.psnr);
}

TEST(OrderSearch, OneSidedHairHasNothingToDrawTogether) {
  AssetContents contents = two_shells();
  contents.material[0].flags = 0;
  OrderSearchSettings settings;
  settings.faces_together = true;
  EXPECT_FALSE(Searched(contents, settings).found.rule.faces_together);
}

TEST(OrderClusters, CellsThatWantTheSameShareAnOrder) {
  CellVotes cells;
  for (std::size_t cell = 0; cell < kViewCells; ++cell) cells[cell] = {{0, 1, cell % 2 == 0 ? 1.0f : -1.0f}};
  const CellOrders clusters = cluster_orders(cells, counted(2), 8, 2);
  ASSERT_EQ(clusters.orders.size(), 2u);
  for (std::size_t cell = 0; cell < kViewCells; ++cell) {
    EXPECT_EQ(votes_against(cells[cell], clusters.orders[clusters.order_of[cell]]), 0);
  }
  EXPECT_EQ(cluster_orders(cells, counted(2), 1, 1).orders.size(), 1u);
}

TEST(OrderClusters, PairsThatNothingWasSeenOfEndByTheirDepth) {
  const AssetContents contents = card_contents(stack(4));
  const lab::OpenedAsset opened(contents);
  const HairSurface hair(opened.asset());
  CellVotes cells;  // of every cell, a single one against the depth seen from +Z
  for (std::vector<Vote>& votes : cells) votes = {{2, 6, 1.0f}};
  CellOrders found{{counted(8), counted(8)}, {}};
  for (std::uint32_t cell = 0; cell < kViewCells; ++cell)
    found.order_of[cell] = direction_in_cell(cell, 0).z() > 0 ? 0 : 1;
  const CellOrders refined = refine_from_depth(hair, posed_positions(opened.asset(), {}), cells, found, 2);
  ASSERT_FALSE(refined.orders.empty());
  const std::vector<std::uint32_t> place = places_in(refined.orders[0], 8);
  EXPECT_LT(place[2], place[6]) << "as the vote says";
  EXPECT_GT(place[0], place[4]) << "the nearest card after the third";
  EXPECT_GT(place[1], place[7]);
}

TEST(OrderClusters, NeverLoseMoreThanTheirStartAndLessWithMoreOrders) {
  CellVotes cells;
  std::uint32_t seed = 1;
  for (std::vector<Vote>& votes : cells) {
    for (std::uint32_t a = 0; a + 1 < 12; ++a) {
      seed = seed * 1664525u + 1013904223u;
      votes.push_back({a, a + 1, float(int(seed >> 16 & 0xFF)) - 127.5f});
    }
  }
  const auto lost = [&](const CellOrders& clusters) {
    double sum = 0;
    for (std::size_t i = 0; i < kViewCells; ++i) sum += votes_against(cells[i], clusters.orders[clusters.order_of[i]]);
    return sum;
  };
  const double start = lost({{counted(12)}, {}});
  const double one = lost(cluster_orders(cells, counted(12), 1, 1));
  const double four = lost(cluster_orders(cells, counted(12), 4, 1));
  EXPECT_LE(one, start);
  EXPECT_LT(four, one);
}

}  // namespace coif::visibility::order_search_test
