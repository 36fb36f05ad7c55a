#include "cards/fit_opacity.h"

#include "cards/made_up_cards.h"
#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace coif::cards::fit_opacity_test {

constexpr float kWidth = 0.003f;

OpacityFit fit(const groom::Groom& groom, int rounds, Cards& cards, unsigned threads) {
  FitTarget target(groom, kWidth);
  return fit_opacity(target, rounds, cards, threads);
}

Cards unfitted_cards(const groom::Groom& groom, std::size_t count, std::size_t triangles) {
  return test::unfitted_cards(groom, kWidth, count, triangles, std::size_t{1} << 18);
}

TEST(FitOpacity, BringsCardsNearerToStrandsFromDirectionsThatItDidNotSee) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(400));
  Cards cards = unfitted_cards(groom, 60, 480);
  const double before = test::mean_overlap(groom, cards, kWidth);
  const OpacityFit fitted = fit(groom, 4, cards, 2);
  ASSERT_GE(fitted.errors.size(), 2u);
  EXPECT_LT(fitted.errors.back(), 0.9 * fitted.errors.front());
  EXPECT_GT(test::mean_overlap(groom, cards, kWidth), before + 0.07);
  for (const CardTexture& texture : cards.textures) {
    EXPECT_GE(std::ranges::min(texture.opacity), 0);
    EXPECT_LE(std::ranges::max(texture.opacity), 1);
  }
}

TEST(FitOpacity, AddsNothingAtSidesAndTipsWhoseStraightEdgesWouldShow) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(200));
  Cards cards = unfitted_cards(groom, 20, 100);
  const std::vector<CardTexture> before = cards.textures;
  fit(groom, 2, cards, 2);
  bool is_changed = false;
  for (std::size_t i = 0; i < cards.textures.size(); ++i) {
    const CardTexture& texture = cards.textures[i];
    is_changed = is_changed || texture.opacity != before[i].opacity;
    const float least = 8 / float(std::min(texture.width, texture.height));
    for (std::uint32_t y = 0; y < texture.height; ++y) {
      const std::size_t side = std::size_t(y) * texture.width;
      EXPECT_LE(texture.opacity[side], before[i].opacity[side] + least);
    }
  }
  EXPECT_TRUE(is_changed);
}

TEST(FitOpacity, RepeatsWithAnyNumberOfThreads) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(150));
  Cards one = unfitted_cards(groom, 20, 100), three = one;
  const OpacityFit first = fit(groom, 2, one, 1), second = fit(groom, 2, three, 3);
  EXPECT_EQ(first.errors, second.errors);
  for (std::size_t i = 0; i < one.textures.size(); ++i) EXPECT_EQ(one.textures[i].opacity, three.textures[i].opacity);
}

}  // namespace coif::cards::fit_opacity_test
