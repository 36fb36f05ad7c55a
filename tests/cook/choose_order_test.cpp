// The pass that chooses draw orders, on packed cards whose right order is known.

#include "cook/order/choose_order.h"
#include "cook/recipe/recipe.h"
#include "cook/told.h"
#include "lab/rig.h"
#include "models/card_asset.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace coif::cook::choose_order_test {

/// Four cards one behind the other, in the order of their distance from the head: as seen from +Z the nearest comes
/// first.
AssetContents stack() {
  std::vector<Card> cards;
  for (int i = 0; i < 4; ++i) cards.push_back({.center = {0, 0, -0.02f * float(i)}, .alpha = 150});
  return card_contents(cards);
}

/// A coarser level with two triangles of each card but the second.
AssetContents stack_of_two_levels() {
  AssetContents contents = stack();
  const std::vector<PatchRecord> finest = contents.patches;
  for (const std::uint32_t p : {0u, 2u, 3u}) {
    PatchRecord patch = finest[p];
    const auto first = contents.indices.begin() + patch.first_index;
    const std::vector<std::uint32_t> triangle(first, first + 3);
    patch.first_index = std::uint32_t(contents.indices.size());
    patch.index_count = 3;
    contents.indices.insert(contents.indices.end(), triangle.begin(), triangle.end());
    contents.patches.push_back(patch);
  }
  contents.lods = {{0, 4, 0.1f, 0}, {4, 3, 0, 0.01f}};
  contents.lod_bones = {0};
  return contents;
}

Recipe recipe_with(OrderMethod method) {
  Recipe recipe = default_recipe();
  recipe.order_method = method;
  return recipe;
}

std::vector<std::string> choose(const Recipe& recipe, AssetContents& contents, unsigned threads = 2) {
  const std::vector<Image> used = {{256, 1, 1, std::vector<std::uint8_t>(256, 255)}};
  Findings findings;
  const auto chosen = choose_order(recipe, used, threads, contents, findings);
  EXPECT_TRUE(chosen) << (chosen ? "" : chosen.error().message);
  const lab::OpenedAsset opened(contents);
  EXPECT_TRUE(opened.asset().is_open()) << "the format allows the result: " << describe(opened.status().code);
  return findings.notes;
}

TEST(ChooseOrder, StackOfCardsGetsOrdersByDirection) {
  AssetContents contents = stack();
  const auto notes = choose(recipe_with(OrderMethod::kAuto), contents);
  EXPECT_GE(contents.orders.size(), 2 * 8u);
  EXPECT_EQ(contents.order_views.size(), kViewCells);
  ASSERT_FALSE(notes.empty());
  EXPECT_NE(notes[0].find("orders of triangles by direction"), std::string::npos) << notes[0];
}

TEST(ChooseOrder, EveryTriangleKeepsItsCorners) {
  AssetContents contents = stack_of_two_levels();
  const AssetContents before = contents;
  choose(recipe_with(OrderMethod::kAuto), contents);
  const auto triangles_of = [](const AssetContents& c, const PatchRecord& patch) {
    const auto first = c.indices.begin() + patch.first_index;
    return std::vector<std::uint32_t>(first, first + patch.index_count);
  };
  for (std::size_t level = 0; level < 2; ++level) {
    for (std::uint32_t i = 0; i < before.lods[level].patch_count; ++i) {
      const PatchRecord& old = before.patches[before.lods[level].first_patch + i];
      const auto begin = contents.patches.begin() + contents.lods[level].first_patch;
      const auto now = std::find_if(begin, begin + contents.lods[level].patch_count,
                                    [&](const PatchRecord& p) { return p.file_place == old.file_place; });
      EXPECT_EQ(triangles_of(contents, *now), triangles_of(before, old));
      EXPECT_EQ(now->head_distance, old.head_distance);
    }
  }
}

TEST(ChooseOrder, CoarserLevelsFollowTheFinest) {
  AssetContents contents = stack_of_two_levels();
  choose(recipe_with(OrderMethod::kAuto), contents);
  const std::size_t all = contents.indices.size() / 3;
  ASSERT_FALSE(contents.orders.empty());
  for (std::size_t start = 0; start < contents.orders.size(); start += all) {
    // Cards are told by their first vertices, four to a card.
    const auto card_at = [&](std::size_t position) {
      return contents.indices[3 * std::size_t{contents.orders[start + position]}] / 4;
    };
    const auto place_of = [&](std::uint32_t card) {
      std::size_t sum = 0;
      for (std::size_t i = 0; i < 8; ++i) sum += card_at(i) == card ? i : 0;
      return sum;
    };
    for (std::size_t i = 9; i < all; ++i) EXPECT_LE(place_of(card_at(i - 1)), place_of(card_at(i)));
  }
}

TEST(ChooseOrder, RecipeDecidesHowManyOrdersThereAre) {
  Recipe recipe = recipe_with(OrderMethod::kViews);
  recipe.order_max = 2;
  AssetContents contents = stack();
  choose(recipe, contents);
  EXPECT_LE(contents.orders.size(), 8u);

  contents = stack();
  choose(recipe_with(OrderMethod::kSingle), contents);
  EXPECT_TRUE(contents.orders.empty());
  EXPECT_TRUE(contents.order_views.empty());

  recipe = recipe_with(OrderMethod::kAuto);
  recipe.order_max_bytes = 31;
  contents = stack();
  choose(recipe, contents);
  EXPECT_TRUE(contents.orders.empty()) << "an order of eight triangles takes 32";

  recipe = recipe_with(OrderMethod::kAuto);
  recipe.order_min_gain = 100;
  contents = stack();
  choose(recipe, contents);
  EXPECT_TRUE(contents.orders.empty());
}

/// What the cooker says of the order by distance from the head.
std::string head_quality(AssetContents contents) {
  const auto notes = choose(recipe_with(OrderMethod::kAuto), contents);
  const std::size_t from = notes.at(0).find("by distance from the head"), to = notes[0].find(", the best");
  return from < to && to != std::string::npos ? notes[0].substr(from, to - from) : notes[0];
}

TEST(ChooseOrder, DistanceFromTheHeadIsThatWhateverTheOrderInTheFile) {
  std::vector<Card> cards;
  for (const int i : {2, 0, 3, 1}) cards.push_back({.center = {0, 0, -0.02f * float(i)}, .alpha = 150});
  const std::string sorted = head_quality(stack());
  EXPECT_NE(sorted.find(" dB (median "), std::string::npos) << sorted;
  EXPECT_EQ(head_quality(card_contents(cards)), sorted);
}

/// Cards on the bones of hair that moves.
AssetContents hanging_stack() {
  std::vector<Card> cards;
  for (int i = 0; i < 9; ++i) cards.push_back({.center = {0, -0.03f * float(i % 3), -0.02f * float(i)}, .alpha = 150});
  const AssetContents drawn = card_contents(cards);
  AssetContents contents = nine_bone_rig().contents();
  contents.vertices = drawn.vertices;
  contents.indices = drawn.indices;
  contents.patches = drawn.patches;
  contents.material = drawn.material;
  contents.textures = drawn.textures;
  contents.texels = drawn.texels;
  for (std::size_t v = 0; v < contents.vertices.size(); ++v) {
    contents.skin.push_back({{std::uint16_t(contents.bones.size() - 9 + v / 4), 0, 0, 0}, {255, 0, 0, 0}});
  }
  return contents;
}

TEST(ChooseOrder, IsSearchedInPosesOfTheSolverThatTheRecipeNames) {
  const auto told_of = [](const std::string& solver) {
    Recipe recipe = recipe_with(OrderMethod::kAuto);
    recipe.order_solver = solver;
    AssetContents contents = hanging_stack();
    return choose(recipe, contents).at(0);
  };
  EXPECT_NE(told_of("thesis"), told_of(default_recipe().order_solver));
}

void expect_untouched(const Recipe& recipe, AssetContents contents) {
  const std::vector<std::byte> before = write_asset(contents);
  EXPECT_TRUE(choose(recipe, contents).empty());
  EXPECT_EQ(write_asset(contents), before);
}

TEST(ChooseOrder, HugeHairIsNotSearchedUnasked) {
  AssetContents contents = card_contents(std::vector<Card>{{.alpha = 150}});
  const std::vector<std::uint32_t> card = contents.indices;
  while (contents.indices.size() <= 3 * 250'000u) {
    contents.indices.insert(contents.indices.end(), card.begin(), card.end());
  }
  contents.patches[0].index_count = std::uint32_t(contents.indices.size());
  const auto notes = choose(default_recipe(), contents);
  ASSERT_EQ(notes.size(), 1u);
  EXPECT_NE(notes[0].find("by distance from the head; 250002 triangles are more"), std::string::npos) << notes[0];
  EXPECT_TRUE(contents.orders.empty());
}

TEST(ChooseOrder, HeadDistanceIsKeptWhereItIsAskedForOrNothingIsBlended) {
  expect_untouched(recipe_with(OrderMethod::kHead), stack());
  AssetContents contents = stack();
  contents.material[0].opaque_threshold = contents.material[0].discard_threshold;
  expect_untouched(default_recipe(), contents);
}

TEST(ChooseOrder, RecipesThresholdStays) {
  Recipe recipe = default_recipe();
  recipe.opaque_threshold = 0.9;
  AssetContents contents = stack();
  contents.material[0].opaque_threshold = 0.9f;
  choose(recipe, contents);
  EXPECT_EQ(contents.material[0].opaque_threshold, 0.9f);
}

/// Cards of one dark colour and one alpha below the usual threshold, each a little beside the one behind it.
AssetContents heap(int alpha) {
  std::vector<Card> cards;
  for (int i = 0; i < 6; ++i) cards.push_back({.center = {0.05f * float(i), 0, -0.01f * float(i)}, .alpha = alpha});
  AssetContents contents = card_contents(cards);
  for (std::size_t i = 0; i < contents.texels.size(); ++i) {
    if (i % 4 != 3) contents.texels[i] = std::byte{90};
  }
  return contents;
}

TEST(ChooseOrder, BlendsWhatLetsTheBackdropThroughThoughItsOrderIsWrong) {
  AssetContents contents = heap(204);
  choose(recipe_with(OrderMethod::kSingle), contents);
  EXPECT_GT(contents.material[0].opaque_threshold, 0.8f) << "the card's alpha";
}

TEST(ChooseOrder, OfThresholdsThatLookTheSameTheCheaperIsTaken) {
  AssetContents contents = heap(252);
  contents.material[0].opaque_threshold = 0.99f;
  choose(recipe_with(OrderMethod::kSingle), contents);
  EXPECT_LE(contents.material[0].opaque_threshold, 252 / 255.0f)
      << "one in 85 parts of the backdrop is not worth blending";
}

TEST(ChooseOrder, ThreadsDoNotChangeTheBytes) {
  AssetContents one = stack_of_two_levels(), three = one;
  choose(default_recipe(), one, 1);
  choose(default_recipe(), three, 3);
  EXPECT_EQ(write_asset(one), write_asset(three));
}

using Eigen::Vector3f;

constexpr int kOpaque = 255;

/// Square, facing +Z.
Card card(const Vector3f& center, float half_size, int alpha = kOpaque) {
  return {center, {half_size, 0, 0}, {0, half_size, 0}, alpha};
}

AssetContents baked(AssetContents contents, double strength = 1, unsigned threads = 1) {
  Recipe recipe = default_recipe();
  recipe.occlusion_strength = strength;
  bake_occlusion(recipe, threads, contents, unheard());
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

TEST(BakeOcclusion, AFoldedCardShadesItself) {
  AssetContents contents = card_contents(std::array{card({0, 0, 0.01f}, 0.3f), card({0, 0, 0}, 0.01f)});
  contents.patches[0].index_count += contents.patches[1].index_count;
  contents.patches.pop_back();
  EXPECT_NEAR(light_on(baked(std::move(contents)), 1), 0.5, 0.05);
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

}  // namespace coif::cook::choose_order_test
