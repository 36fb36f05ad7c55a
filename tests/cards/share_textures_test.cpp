#include "cards/card_texture.h"
#include "cards/fit_opacity.h"
#include "cards/made_up_cards.h"
#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

namespace coif::cards::share_textures_test {

constexpr float kWidth = 0.0005f;
constexpr std::size_t kLocks = 10;  // of each kind
constexpr std::size_t kStrands = 30;

/// Locks far from each other that hang down: every second one is long and narrow, the others are short and wide.
std::vector<std::vector<Eigen::Vector3f>> locks_of_two_kinds() {
  std::mt19937 random(3);
  std::uniform_real_distribution<float> unit(-1, 1);
  std::vector<std::vector<Eigen::Vector3f>> strands;
  for (std::size_t lock = 0; lock < 2 * kLocks; ++lock) {
    const bool is_long = lock % 2 == 0;
    for (std::size_t i = 0; i < kStrands; ++i) {
      const Eigen::Vector3f root(float(lock) + (is_long ? 0.005f : 0.03f) * unit(random), 0.001f * unit(random), 0);
      std::vector<Eigen::Vector3f>& strand = strands.emplace_back();
      for (int k = 0; k <= 8; ++k)
        strand.emplace_back(root - Eigen::Vector3f(0, (is_long ? 0.4f : 0.1f) * float(k) / 8, 0));
    }
  }
  return strands;
}

ChosenCards even_cards(const groom::Groom& groom, const GroomShape& shape, std::size_t cards) {
  return construct_cards(groom, shape.strands, {Construction::kEven, 2}, 4 * cards, 2);
}

bool is_long(const ChosenCards& cards, std::uint32_t strip) {
  return length_of(cards.wisps[cards.strips[strip].wisp].ribbon) > 0.2f;
}

TEST(ShareTextures, CardsOfOneKindHaveOneTexture) {
  const groom::Groom groom = test::groom_of(locks_of_two_kinds());
  const GroomShape shape = shape_of(groom, kWidth);
  const ChosenCards cards = even_cards(groom, shape, 2 * kLocks);
  ASSERT_EQ(cards.strips.size(), 2 * kLocks);
  const TextureShares shares = share_textures(groom, shape.is_reversed, cards, kWidth, 2, 2);
  ASSERT_EQ(shares.drawn_from.size(), 2u);
  for (std::uint32_t strip = 0; strip < cards.strips.size(); ++strip)
    EXPECT_EQ(is_long(cards, strip), is_long(cards, shares.drawn_from[shares.texture_of[strip]])) << strip;
}

TEST(ShareTextures, CardsOfDifferentColoursShareNothing) {
  constexpr std::size_t kWisps = 16, kOfWisp = 20;
  groom::Groom groom = test::hanging_wisps(kWisps, kOfWisp);
  for (std::size_t i = 0; i < groom.points.size(); ++i) {
    const bool is_red = i * kWisps / groom.points.size() % 2 == 0;
    groom.colors.emplace_back(is_red ? 0.6f : 0.1f, 0.1f, is_red ? 0.1f : 0.5f);
  }
  const GroomShape shape = shape_of(groom, kWidth);
  const ChosenCards cards = even_cards(groom, shape, kWisps);
  ASSERT_EQ(cards.strips.size(), kWisps);
  const TextureShares shares = share_textures(groom, shape.is_reversed, cards, kWidth, 4, 2);
  const auto is_red = [&](std::uint32_t strip) {
    return cards.wisps[cards.strips[strip].wisp].members.front() / kOfWisp % 2 == 0;
  };
  for (std::uint32_t strip = 0; strip < cards.strips.size(); ++strip)
    EXPECT_EQ(is_red(strip), is_red(shares.drawn_from[shares.texture_of[strip]])) << strip;
}

TEST(ShareTextures, EachTextureIsDrawnFromOneOfTheCardsThatShowIt) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(400));
  const GroomShape shape = shape_of(groom, kWidth);
  const ChosenCards cards = even_cards(groom, shape, 80);
  const TextureShares shares = share_textures(groom, shape.is_reversed, cards, kWidth, 12, 2);
  EXPECT_LE(shares.drawn_from.size(), 12u);
  ASSERT_EQ(shares.texture_of.size(), cards.strips.size());
  for (std::uint32_t i = 0; i < shares.drawn_from.size(); ++i) EXPECT_EQ(shares.texture_of[shares.drawn_from[i]], i);
  const TextureShares again = share_textures(groom, shape.is_reversed, cards, kWidth, 12, 3);
  EXPECT_EQ(shares.texture_of, again.texture_of);
  EXPECT_EQ(shares.drawn_from, again.drawn_from);
}

TEST(ShareTextures, FewCardsKeepTheirOwn) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(50));
  const GroomShape shape = shape_of(groom, kWidth);
  const ChosenCards cards = even_cards(groom, shape, 8);
  const TextureShares shares = share_textures(groom, shape.is_reversed, cards, kWidth, 8, 2);
  EXPECT_EQ(shares.texture_of, own_textures(cards.strips.size()).texture_of);
  EXPECT_EQ(shares.drawn_from, own_textures(cards.strips.size()).drawn_from);
}

TEST(ShareTextures, StrandsThatOwnTexturesShowAreNotShared) {
  const std::vector<CardSize> cards(2000, {0.02f, 0.3f});
  constexpr std::size_t kTexels = std::size_t{1} << 21;
  EXPECT_EQ(wisps_for(cards, kTexels, 0.002f), 0u);
  const std::size_t fine = wisps_for(cards, kTexels, 0.0001f), wider = wisps_for(cards, 4 * kTexels, 0.0002f);
  EXPECT_GT(fine, 0u);
  EXPECT_LE(fine, wider);
  EXPECT_LE(2 * wider, cards.size());
  EXPECT_EQ(wisps_for(std::span(cards).first(20), kTexels / 1000, 0.00001f), 0u) << "too few cards to share any";
}

TEST(ShareTextures, SharedTexturesAreFittedToAllTheirCards) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(2000));
  const GroomShape shape = shape_of(groom, kWidth);
  CardsBudget budget{.triangles = 800, .texels = std::size_t{1} << 16, .rounds = 0, .strand_width = kWidth, .caps = 0};
  budget.plan = CardsPlan{Construction::kBent, 4};
  budget.wisps = 16;
  const auto bare = make_cards(groom, shape, budget, 2);
  budget.rounds = 6;
  const auto fitted = make_cards(groom, shape, budget, 2);
  ASSERT_TRUE(bare && fitted);
  EXPECT_EQ(fitted->textures.size(), 16u);
  EXPECT_EQ(fitted->strips.size(), 100u);
  EXPECT_GT(test::mean_overlap(groom, *fitted, kWidth), test::mean_overlap(groom, *bare, kWidth) + 0.02);
}

TEST(ShareTextures, CoarserLevelsShareFewer) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(600));
  CardsBudget budget{
      .triangles = 800, .texels = std::size_t{1} << 16, .rounds = 0, .strand_width = kWidth, .caps = 0, .levels = 3};
  budget.plan = CardsPlan{Construction::kBent, 4};
  budget.wisps = 20;
  const auto levels = make_card_levels(groom, shape_of(groom, kWidth), budget, 2);
  ASSERT_TRUE(levels);
  ASSERT_EQ(levels->size(), 3u);
  EXPECT_EQ((*levels)[0].textures.size(), 20u);
  EXPECT_EQ((*levels)[1].textures.size(), 10u);
  EXPECT_EQ((*levels)[2].textures.size(), 5u);
}

}  // namespace coif::cards::share_textures_test
