#include "cards/choose_cards.h"

#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::cards::choose_cards_test {

constexpr float kWidth = 0.001f;

/// Locks that hang in waves of some amplitude, 0.4 m long.
EvenStrands waving(float amplitude) {
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
  return even_strands(test::groom_of(strands), kWidth);
}

TEST(ChosenCards, HaveMoreEdgesEachWhereHairBends) {
  constexpr std::size_t kTriangles = 480;
  const ChosenCards straight = choose_cards(waving(0), kTriangles, 2),
                    bent = choose_cards(waving(0.02f), kTriangles, 2);
  EXPECT_LT(bent.wisps.size(), straight.wisps.size());
  for (const ChosenCards* const cards : {&straight, &bent}) {
    std::size_t made = 0, members = 0;
    for (const CardStrip& strip : cards->strips) made += strip.triangles();
    for (const Wisp& wisp : cards->wisps) members += wisp.members.size();
    EXPECT_LE(made, kTriangles);
    EXPECT_EQ(members, 600u) << "every strand is in one";
    EXPECT_EQ(cards->strips.size(), cards->wisps.size());
  }
}

TEST(ChosenCards, AreNoWorseThanOthersOfTheSamePrice) {
  constexpr std::size_t kTriangles = 480;
  for (const float amplitude : {0.0f, 0.005f, 0.02f}) {
    const EvenStrands strands = waving(amplitude);
    const double chosen = strands_off_strips(strands, choose_cards(strands, kTriangles, 2), 2);
    ChosenCards usual{find_wisps(strands, kTriangles / 8, 2), {}};
    usual.strips = make_strips(usual.wisps, kTriangles);
    EXPECT_LE(chosen, strands_off_strips(strands, usual, 2) * (1 + 1e-9));
  }
}

TEST(ChosenCards, AreAtLeastOneAndRepeatWithAnyNumberOfThreads) {
  const EvenStrands strands = waving(0.01f);
  EXPECT_EQ(choose_cards(strands, 2, 1).wisps.size(), 1u);
  const ChosenCards one = choose_cards(strands, 300, 1), three = choose_cards(strands, 300, 3);
  ASSERT_EQ(one.wisps.size(), three.wisps.size());
  for (std::size_t i = 0; i < one.wisps.size(); ++i) {
    EXPECT_EQ(one.wisps[i].members, three.wisps[i].members);
    EXPECT_EQ(one.strips[i].stations, three.strips[i].stations);
  }
}

}  // namespace coif::cards::choose_cards_test
