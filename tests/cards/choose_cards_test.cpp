#include "cards/choose_cards.h"

#include "cards/judge_cards.h"
#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace coif::cards::choose_cards_test {

constexpr float kWidth = 0.001f;
constexpr std::size_t kTriangles = 480;

/// Locks that hang in waves of some amplitude, 0.4 m long.
groom::Groom waving(float amplitude) {
  std::vector<std::vector<Eigen::Vector3f>> strands;
  for (int i = 0; i < 600; ++i) {
    const float phase = float(i % 60), x = 0.01f * float(i % 60), z = 0.0005f * float(i / 60);
    std::vector<Eigen::Vector3f> strand;
    for (int k = 0; k < 40; ++k) {
      const float down = 0.01f * float(k);
      strand.emplace_back(x + amplitude * std::sin(40 * down + phase), -down,
                          z + amplitude * std::cos(40 * down + phase));
    }
    strands.push_back(strand);
  }
  return test::groom_of(strands);
}

CardsPlan plan_for(const groom::Groom& groom, unsigned threads) {
  return choose_plan(groom, shape_of(groom, kWidth), kConstructions, {kTriangles, std::size_t{1} << 18, 1}, threads);
}

TEST(ChosenPlan, HasMoreQuadsEachWhereHairBends) {
  const CardsPlan straight = plan_for(waving(0), 2), bent = plan_for(waving(0.02f), 2);
  EXPECT_LT(straight.quads, bent.quads);
}

TEST(ChosenPlan, IsNoWorseThanOthersOfTheSamePrice) {
  const groom::Groom groom = waving(0.01f);
  const GroomShape shape = shape_of(groom, kWidth);
  const CardsJudge judge(groom, kWidth, 128, 2);
  FitTarget target(groom, kWidth, 128);
  const auto price = [&](const CardsPlan& plan) {
    auto cards = texture_cards(groom, shape, construct_cards(groom, shape.strands, plan, kTriangles, 2),
                               std::size_t{1} << 16, 2);
    EXPECT_TRUE(cards.has_value());
    fit_opacity(target, 1, *cards, 2);
    return judge.judge(surface_of(*cards), 2).price();
  };
  const double chosen = price(plan_for(groom, 2));
  for (const CardsPlan& plan :
       {CardsPlan{Construction::kBent, 1}, CardsPlan{Construction::kEven, 12}, CardsPlan{Construction::kFlat, 1}}) {
    EXPECT_LT(chosen, 1.05 * price(plan)) << int(plan.construction) << ", " << plan.quads;
  }
}

TEST(ChosenPlan, RepeatsWithAnyNumberOfThreads) {
  const groom::Groom groom = waving(0.01f);
  EXPECT_EQ(plan_for(groom, 1), plan_for(groom, 3));
}

TEST(CardsMerit, WeighsLayersOnlyWherePicturesAreAlike) {
  const CardsMerit thin{0.1, 0.05, 10}, thick{0.099, 0.05, 20}, near{0.08, 0.04, 20};
  EXPECT_LT(thin.price(), thick.price());
  EXPECT_LT(near.price(), thin.price());
}

TEST(ConstructedCards, HoldEveryStrandOnceWithinTheBudget) {
  const groom::Groom groom = waving(0.01f);
  const EvenStrands strands = shape_of(groom, kWidth).strands;
  for (const CardsPlan& plan :
       {CardsPlan{Construction::kBent, 2.5}, CardsPlan{Construction::kEven, 3}, CardsPlan{Construction::kFlat, 1}}) {
    for (const std::size_t triangles : {std::size_t{2}, std::size_t{300}}) {
      const ChosenCards one = construct_cards(groom, strands, plan, triangles, 1),
                        three = construct_cards(groom, strands, plan, triangles, 3);
      std::size_t made = 0;
      std::multiset<std::uint32_t> members;
      for (const CardStrip& strip : one.strips) made += strip.triangles();
      for (const Wisp& wisp : one.wisps) members.insert(wisp.members.begin(), wisp.members.end());
      EXPECT_LE(made, triangles);
      EXPECT_EQ(members.size(), 600u);
      EXPECT_EQ(std::set(members.begin(), members.end()).size(), 600u);
      ASSERT_EQ(one.strips.size(), one.wisps.size());
      ASSERT_EQ(three.strips.size(), one.strips.size()) << "threads change nothing";
      for (std::size_t i = 0; i < one.strips.size(); ++i) EXPECT_EQ(one.strips[i].edges, three.strips[i].edges);
    }
  }
}

TEST(LaidStrips, HoldStrandsThatBendBesideThem) {
  const groom::Groom groom = waving(0.01f);
  const EvenStrands strands = shape_of(groom, kWidth).strands;
  ChosenCards cards{find_wisps(strands, 60, 2), {}};
  for (std::uint32_t i = 0; i < cards.wisps.size(); ++i) cards.strips.push_back(even_strip(i, 2));
  std::vector<float> before;
  for (const CardStrip& strip : cards.strips) {
    const auto edges = edges_of(cards.wisps[strip.wisp].ribbon, strip);
    before.push_back((edges[1][1] - edges[1][0]).norm());
  }
  lay_strips(strands, cards, 2);
  float wider = 0;
  for (std::size_t i = 0; i < cards.strips.size(); ++i) {
    ASSERT_EQ(cards.strips[i].edges.size(), 3u);
    wider += ((cards.strips[i].edges[1][1] - cards.strips[i].edges[1][0]).norm() - before[i]) / float(before.size());
  }
  EXPECT_GT(wider, 0.001f) << "waves of 1 cm go beyond a strip of two quads";
}

}  // namespace coif::cards::choose_cards_test
