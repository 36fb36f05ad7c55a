#include "research/cards/baseline_cards.h"

#include "cards/made_up_groom.h"
#include "report/cards/groom_views.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <stdexcept>

namespace coif::research::cards_baselines_test {

constexpr float kWidth = 0.002f;

using report::GroomViews;

GroomViews views_of(const groom::Groom& groom) {
  const auto directions = cards::spread_directions(8);
  return {groom, kWidth, report::frames_around(groom, Eigen::Matrix3f::Identity(), directions, 96), 2};
}

double mean_iou(const GroomViews& views, const cards::CardSurface& surface) {
  double sum = 0;
  for (const cards::HairLikeness& one : views.compare(surface)) sum += one.coverage_iou;
  return sum / double(views.count());
}

double mean_error(const GroomViews& views, const cards::CardSurface& surface) {
  double sum = 0;
  for (const cards::HairLikeness& one : views.compare(surface)) sum += one.error;
  return sum / double(views.count());
}

TEST(ClustersOfStrands, HoldEachStrandOnceAndRepeat) {
  const cards::EvenStrands strands =
      cards::even_strands(cards::test::groom_of(cards::test::strands_of_a_head(300)), kWidth);
  for (const std::size_t count : {1u, 7u, 60u, 300u, 5000u}) {
    const auto clusters = cards::cluster_strands(strands, count, 1);
    EXPECT_LE(clusters.size(), std::min<std::size_t>(count, 300));
    std::set<std::uint32_t> seen;
    for (const auto& members : clusters) {
      EXPECT_FALSE(members.empty());
      EXPECT_TRUE(std::ranges::is_sorted(members));
      for (const std::uint32_t i : members) EXPECT_TRUE(seen.insert(i).second) << i;
    }
    EXPECT_EQ(seen.size(), 300u);
    EXPECT_EQ(cards::cluster_strands(strands, count, 3), clusters) << "threads change nothing";
  }
  EXPECT_TRUE(cards::cluster_strands({}, 4, 1).empty());
}

TEST(ClustersOfStrands, AreTheWispsWhereTheseLieApart) {
  const auto clusters = cards::cluster_strands(cards::even_strands(cards::test::hanging_wisps(5, 30), kWidth), 5, 2);
  ASSERT_EQ(clusters.size(), 5u);
  for (const auto& members : clusters) {
    ASSERT_EQ(members.size(), 30u);
    EXPECT_EQ(members.back() - members.front(), 29u) << "strands of one wisp follow each other";
  }
}

TEST(FlatRibbon, HoldsItsStrandsInThePlaneTheyLieIn) {
  // Bent, but flat: in the plane that Z and a slant across X and Y span.
  const Eigen::Vector3f slant = Eigen::Vector3f(1, 1, 0).normalized();
  std::vector<std::vector<Eigen::Vector3f>> strands;
  for (int i = 0; i < 5; ++i) {
    std::vector<Eigen::Vector3f> strand;
    for (int k = 0; k < 10; ++k) {
      const float t = float(k) / 9;
      strand.emplace_back((0.02f * float(i) + 0.05f * t * t) * slant - 0.4f * t * Eigen::Vector3f::UnitZ());
    }
    strands.push_back(strand);
  }
  const groom::Groom groom = cards::test::groom_of(strands);
  const std::uint32_t members[] = {0, 1, 2, 3, 4};
  const cards::Ribbon ribbon = cards::flat_ribbon_of(groom, cards::even_strands(groom, kWidth), members);
  const Eigen::Vector3f normal = ribbon.along[0].cross(ribbon.across[0]);
  EXPECT_NEAR(std::abs(normal.dot(slant)), 0, 1e-3);
  EXPECT_NEAR(std::abs(normal.z()), 0, 1e-3);
  EXPECT_LT(ribbon.along[0].z(), -0.9f) << "from the roots to the tips";
  EXPECT_NEAR(ribbon.half_depth[0], 0, 1e-4);
  const Eigen::Vector3f whole = ribbon.middle.back() - ribbon.middle.front();
  for (const Eigen::Vector3f& point : groom.points) {
    const Eigen::Vector3f off = point - ribbon.middle.front();
    EXPECT_GE(off.dot(ribbon.along[0]), -1e-5);
    EXPECT_LE(off.dot(ribbon.along[0]), whole.norm() + 1e-5);
    EXPECT_LE(std::abs(off.dot(ribbon.across[0])), ribbon.half_width[0]);
  }
}

TEST(FlatRibbon, IsThereForOneStraightStrand) {
  const groom::Groom groom = cards::test::groom_of({cards::test::hanging({0, 0, 0}, 0.3f)});
  const std::uint32_t only[] = {0};
  const cards::Ribbon ribbon = cards::flat_ribbon_of(groom, cards::even_strands(groom, kWidth), only);
  EXPECT_NEAR(cards::length_of(ribbon), 0.3f, 1e-5);
  EXPECT_NEAR(ribbon.across[0].norm(), 1, 1e-5);
  EXPECT_NEAR(ribbon.across[0].dot(ribbon.along[0]), 0, 1e-4);
  EXPECT_NEAR(ribbon.half_width[0], 0.5f * kWidth, 1e-5);
}

TEST(FlatCards, AreTwoTrianglesEachAndLookLikeHairThatIsFlat) {
  const groom::Groom groom = cards::test::hanging_wisps(5, 40);
  const cards::GroomShape shape = cards::shape_of(groom, kWidth);
  const auto cards = make_flat_cards(groom, shape, {10, std::size_t{1} << 18, 1, kWidth}, 2);
  ASSERT_TRUE(cards.has_value());
  ASSERT_EQ(cards->strips.size(), 5u);
  for (const cards::CardStrip& strip : cards->strips) EXPECT_EQ(strip.triangles(), 2u);
  const GroomViews front(groom, kWidth, report::frames_around(groom, Eigen::Matrix3f::Identity(), {{{0, 0, -1}}}, 192),
                         2);
  EXPECT_GT(front.compare(cards::surface_of(*cards))[0].coverage_iou, 0.88);
}

TEST(EvenStrip, GoesFromRootToTipInEqualSteps) {
  for (std::size_t segments = 1; segments < cards::Ribbon::kStations; ++segments) {
    const cards::CardStrip strip = cards::even_strip(3, segments);
    EXPECT_EQ(strip.wisp, 3u);
    ASSERT_EQ(strip.stations.size(), segments + 1);
    EXPECT_EQ(strip.stations.front(), 0);
    EXPECT_EQ(strip.stations.back(), cards::Ribbon::kStations - 1);
    const double step = double(cards::Ribbon::kStations - 1) / double(segments);
    for (std::size_t k = 0; k < segments; ++k) {
      EXPECT_NEAR(strip.stations[k + 1] - strip.stations[k], step, 1) << "stations are whole numbers";
    }
  }
}

TEST(EvenCards, HaveAsManySegmentsAsComeNearest) {
  const groom::Groom groom = cards::test::groom_of(cards::test::strands_of_a_head(150));
  const cards::GroomShape shape = cards::shape_of(groom, kWidth);
  const GroomViews views = views_of(groom);
  const cards::CardsBudget budget{120, std::size_t{1} << 16, 1, kWidth};
  const std::size_t best = even_segments(groom, shape, budget, 2);
  const auto even = make_even_cards(groom, shape, budget, best, 2);
  ASSERT_TRUE(even.has_value());
  std::size_t triangles = 0;
  for (const cards::CardStrip& strip : even->strips) triangles += strip.triangles();
  EXPECT_LE(triangles, budget.triangles);
  // Neither straight cards for many locks nor a few that bend everywhere. The choice counts layers, too.
  for (const std::size_t segments : {std::size_t{1}, cards::Ribbon::kStations - 1}) {
    const auto other = make_even_cards(groom, shape, budget, segments, 2);
    ASSERT_TRUE(other.has_value());
    const double found = mean_error(views, cards::surface_of(*even));
    EXPECT_LE(found, 1.05 * mean_error(views, cards::surface_of(*other))) << segments;
  }
}

TEST(BaselineCards, AreFittedAsOwnCardsAre) {
  const groom::Groom groom = cards::test::groom_of(cards::test::strands_of_a_head(300));
  const cards::GroomShape shape = cards::shape_of(groom, kWidth);
  const GroomViews views = views_of(groom);
  const cards::CardsBudget fitted{200, std::size_t{1} << 17, 4, kWidth};
  cards::CardsBudget plain = fitted;
  plain.rounds = 0;
  for (const auto make :
       {make_flat_cards, +[](const groom::Groom&g, const cards::GroomShape&s, const cards::CardsBudget&b,
                             const platform::Threads&t) { return make_even_cards(g, s, b, 3, t); }}) {
    const auto with = make(groom, shape, fitted, 2), without = make(groom, shape, plain, 2);
    ASSERT_TRUE(with.has_value() && without.has_value());
    EXPECT_GT(mean_iou(views, cards::surface_of(*with)), mean_iou(views, cards::surface_of(*without)) + 0.02);
  }
}

TEST(BaselineCards, SayWhyThereAreNone) {
  const groom::Groom groom = cards::test::groom_of(cards::test::strands_of_a_head(150));
  const auto even = make_even_cards(groom, cards::shape_of(groom, kWidth), {600, 64, 1, kWidth}, 1, 2);
  ASSERT_FALSE(even.has_value());
  EXPECT_EQ(even.error().kind, ToolError::Kind::kOverBudget);
  EXPECT_NE(even.error().message.find("allow them more"), std::string::npos) << even.error().message;
}

}  // namespace coif::research::cards_baselines_test
