#include "cook/bake_occlusion.h"

#include "visibility/card_asset.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

using Eigen::Vector3f;

constexpr int kOpaque = 255;

/// Square, facing +Z.
Card card(const Vector3f& center, float half_size, int alpha = kOpaque) {
  return {center, {half_size, 0, 0}, {0, half_size, 0}, alpha};
}

AssetContents baked(AssetContents contents, double strength = 1, unsigned threads = 1) {
  Recipe recipe = default_recipe();
  recipe.occlusion_strength = strength;
  (void)bake_occlusion(recipe, threads, contents);
  return contents;
}

/// Mean over the corners of one of the cards.
double light_on(const AssetContents& contents, std::size_t card) {
  double sum = 0;
  for (std::size_t k = 0; k < 4; ++k) sum += contents.vertices[4 * card + k].normal[3] / 32767.0;
  return sum / 4;
}

TEST(BakeOcclusion, NothingTakesLightFromALoneCardWhicheverWayItLies) {
  for (const Vector3f& axis : {Vector3f(0.3f, 1, 0.2f), Vector3f(-0.5f, 0.4f, 0.8f)}) {
    for (const float angle : {0.0f, 0.4f, 1.5708f}) {
      const Eigen::AngleAxisf turn(angle, axis.normalized());
      Card lone = card({0.05f, 0.1f, 0}, 0.1f);
      lone.right = turn * lone.right;
      lone.up = turn * lone.up;
      const AssetContents contents = baked(card_contents(std::array{lone}));
      for (const VertexRecord& v : contents.vertices) EXPECT_GT(v.normal[3], 0.99 * 32767) << angle;
    }
  }
}

TEST(BakeOcclusion, ABentStripDoesNotShadeItselfByItsOwnThickness) {
  // Cards of one strip along a quarter of a circle, each its own patch, as strips that were cut are.
  std::vector<Card> cards;
  for (int i = 0; i < 8; ++i) {
    const Eigen::AngleAxisf turn(float(i) * 0.1f, Vector3f::UnitX());
    Card segment = card(turn * Vector3f(0, 0, 0.3f), 0.015f);
    segment.right = turn * segment.right;
    segment.up = turn * segment.up;
    cards.push_back(segment);
  }
  const AssetContents contents = baked(card_contents(cards));
  for (std::size_t i = 0; i < cards.size(); ++i) EXPECT_GT(light_on(contents, i), 0.9) << i;
}

TEST(BakeOcclusion, UnderAnOpaqueShellHalfOfTheLightIsLeft) {
  const AssetContents contents = baked(card_contents(std::array{card({0, 0, 0.01f}, 0.3f), card({0, 0, 0}, 0.01f)}));
  EXPECT_NEAR(light_on(contents, 1), 0.5, 0.05);
}

TEST(BakeOcclusion, BetweenTwoOpaqueShellsNearlyNoneIsLeft) {
  const AssetContents contents =
      baked(card_contents(std::array{card({0, 0, 0.01f}, 0.3f), card({0, 0, -0.01f}, 0.3f), card({0, 0, 0}, 0.01f)}));
  EXPECT_LT(light_on(contents, 2), 0.06);
}

TEST(BakeOcclusion, ATransparentShellTakesItsAlphasShare) {
  for (const int alpha : {64, 128, 192}) {
    const AssetContents contents =
        baked(card_contents(std::array{card({0, 0, 0.01f}, 0.3f, alpha), card({0, 0, 0}, 0.01f)}));
    EXPECT_NEAR(light_on(contents, 1), 1 - 0.5 * alpha / 255.0, 0.05) << alpha;
  }
}

TEST(BakeOcclusion, InnerLayersGetLessThanOuterOnes) {
  std::vector<Card> layers;
  for (int i = 0; i < 5; ++i) layers.push_back(card({0, 0, 0.02f * float(i)}, 0.1f + 0.02f * float(i), 160));
  AssetContents contents = card_contents(layers);
  add_ball(contents, {0, 0, -0.3f}, 0.29f);
  contents = baked(std::move(contents));
  for (std::size_t i = 1; i < layers.size(); ++i) EXPECT_LT(light_on(contents, i - 1), light_on(contents, i)) << i;
}

TEST(BakeOcclusion, TheHeadTakesTheLightFromItsSide) {
  AssetContents contents = card_contents(std::array{card({0, 0, 0.1f}, 0.005f)});
  add_ball(contents, Vector3f::Zero(), 0.1f);
  EXPECT_NEAR(light_on(baked(contents), 0), 0.5, 0.06);
  AssetContents inside = card_contents(std::array{card({0, 0, 0.08f}, 0.005f)});
  add_ball(inside, Vector3f::Zero(), 0.1f);
  EXPECT_NEAR(light_on(baked(inside), 0), 0.5, 0.06) << "roots inside the collider are as light as the scalp";
}

TEST(BakeOcclusion, HairWithAnOutsideIsLitFromThereOnly) {
  // One-sided: the shell behind faces away, and takes nothing.
  AssetContents contents =
      card_contents(std::array{card({0, 0, 0}, 0.01f), card({0, 0, -0.01f}, 0.3f), card({0, 0, 0.01f}, 0.3f, 128)});
  contents.material[0].flags = 0;
  EXPECT_NEAR(light_on(baked(std::move(contents)), 0), 0.5, 0.05);
}

TEST(BakeOcclusion, StrengthScalesIt) {
  const AssetContents bare = card_contents(std::array{card({0, 0, 0.01f}, 0.3f), card({0, 0, 0}, 0.01f)});
  const double whole = light_on(baked(bare, 1), 1);
  EXPECT_NEAR(light_on(baked(bare, 0.5), 1), 0.5 + 0.5 * whole, 1.0e-4);
  EXPECT_EQ(light_on(baked(bare, 0), 1), 1);
}

TEST(BakeOcclusion, ThreadsDoNotChangeIt) {
  std::vector<Card> layers;
  for (int i = 0; i < 5; ++i) layers.push_back(card({0.01f * float(i), 0, 0.02f * float(i)}, 0.1f, 100 + 20 * i));
  const AssetContents one = baked(card_contents(layers), 1, 1), three = baked(card_contents(layers), 1, 3);
  for (std::size_t v = 0; v < one.vertices.size(); ++v)
    EXPECT_EQ(one.vertices[v].normal[3], three.vertices[v].normal[3]);
}

}  // namespace
}  // namespace coif
