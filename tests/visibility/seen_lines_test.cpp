// Pictures by arithmetic: what is seen along a line, and what a drawn picture loses against the exact one.

#include "visibility/seen_lines.h"

#include "models/card_asset.h"
#include "visibility/order_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace coif::visibility::seen_lines_test {

constexpr DrawRule kApart{0.95f, false, 0.01f}, kTogether{0.95f, true, 0.01f};
const Eigen::Array3f kBlack(0, 0, 0), kWhite(1, 1, 1), kGrey(0.5f, 0.5f, 0.5f);

SeenLayer layer(std::uint32_t triangle, float alpha, const Eigen::Array3f& color, bool is_front = true) {
  return {color, alpha, triangle & 0x7FFFFFFFu, is_front ? 1u : 0u};
}

SeenLines line_of(std::vector<SeenLayer> layers, const Eigen::Array3f& behind = kBlack) {
  SeenLines lines;
  lines.layers = std::move(layers);
  lines.begin = {0, std::uint32_t(lines.layers.size())};
  lines.behind = {behind};
  return lines;
}

double error(const SeenLines& lines, const std::vector<std::uint32_t>& rank, const DrawRule& rule) {
  return picture_error(lines, rank, rule);
}

TEST(SeenLines, OnlyTheOrderByDepthIsExact) {
  const SeenLines lines = line_of({layer(0, 0.5f, kWhite), layer(1, 0.4f, kGrey), layer(2, 0.3f, kBlack)});
  EXPECT_NEAR(error(lines, {2, 1, 0}, kApart), 0, 1.0e-9);
  EXPECT_NEAR(error(lines, {}, kApart), 0, 1.0e-9);
  EXPECT_GT(error(lines, {0, 1, 2}, kApart), 0.01);
}

TEST(SeenLines, OrderMattersAsMuchAsColoursDiffer) {
  const std::vector<std::uint32_t> wrong = {0, 1};
  const double black_white = error(line_of({layer(0, 0.5f, kWhite), layer(1, 0.5f, kBlack)}), wrong, kApart);
  const double alike = error(line_of({layer(0, 0.5f, kWhite), layer(1, 0.5f, kWhite)}), wrong, kApart);
  EXPECT_GT(black_white, 100 * alike);
  EXPECT_NEAR(alike, 2 * std::pow(0.25 * kOtherLightSpread, 2), 1.0e-7) << "another light would tell them apart";
}

TEST(SeenLines, DifferencesAreThoseOfEncodedColours) {
  // 0.5 black over white shows 0.5, drawn the other way round as well; 0.75 against 0.25 where one is over the other.
  const SeenLines lines = line_of({layer(0, 0.5f, kWhite), layer(1, 0.5f, kBlack)});
  const auto encoded = [](double c) { return 1.055 * std::pow(c, 1 / 2.4) - 0.055; };
  EXPECT_NEAR(error(lines, {0, 1}, kApart), std::pow(encoded(0.5) - encoded(0.25), 2), 2.0e-4);
}

TEST(SeenLines, BackFacesBeforeFrontFacesMayBeWrong) {
  const SeenLines lines = line_of({layer(0, 0.5f, kWhite, false), layer(1, 0.5f, kBlack, true)});
  EXPECT_NEAR(error(lines, {1, 0}, kTogether), 0, 1.0e-9);
  EXPECT_GT(error(lines, {1, 0}, kApart), 0.01);
}

TEST(SeenLines, SolidLayersHideWhatTheirAlphaLetsThrough) {
  const SeenLines lines = line_of({layer(0, 0.8f, kWhite)});
  EXPECT_GT(error(lines, {0}, {0.75f, false, 0.01f}), 0.005) << "all white, not a fifth of black";
  EXPECT_NEAR(error(lines, {0}, {0.85f, false, 0.01f}), 0, 1.0e-9);
  EXPECT_LT(error(line_of({layer(0, 0.8f, kWhite)}, kWhite), {0}, {0.75f, false, 0.01f}), 1.0e-4) << "nothing to hide";
}

TEST(SeenLines, WhatIsTooFaintIsInTheExactPictureOnly) {
  const SeenLines lines = line_of({layer(0, 0.05f, kWhite)});
  EXPECT_GT(error(lines, {0}, {0.95f, false, 0.1f}), 0.01);
  EXPECT_NEAR(error(lines, {0}, {0.95f, false, 0.01f}), 0, 1.0e-9);
}

TEST(SeenLines, OnlyBlendedLayersInFrontOfSolidOnesCost) {
  const SeenLines lines =
      line_of({layer(0, 0.5f, kWhite), layer(1, 0.001f, kWhite), layer(2, 0.8f, kWhite), layer(3, 0.5f, kWhite)});
  EXPECT_EQ(blended_layers(lines, kApart), 3);
  EXPECT_EQ(blended_layers(lines, {0.75f, false, 0.01f}), 1);
  EXPECT_EQ(blended_layers(lines, {0.3f, false, 0.01f}), 0);
}

/// Cards of hair of one colour, each a little beside the one behind it: so many layers that which of them is seen
/// matters little, and edges that let the backdrop through.
AssetContents heap() {
  std::vector<Card> cards;
  for (int i = 0; i < 6; ++i) cards.push_back({.center = {0.05f * float(i), 0, -0.01f * float(i)}, .alpha = 204});
  AssetContents contents = card_contents(cards);
  for (std::size_t i = 0; i < contents.texels.size(); ++i) {
    if (i % 4 != 3) contents.texels[i] = std::byte{90};
  }
  return contents;
}

TEST(SeenLines, HidingTheBackdropIsWorseThanMixingLayersOfOneColour) {
  const lab::OpenedAsset opened(heap());
  const SeenHair hair(opened.asset());
  const std::vector<HairPositions> poses = {posed_positions(opened.asset(), {})};
  FoundOrders one;
  one.patches.resize(6);
  std::iota(one.patches.begin(), one.patches.end(), 0u);  // right from behind only
  OrderSearchSettings settings;
  settings.lines_per_view = 400;
  settings.opaque_threshold = 0.95f;
  const JudgedHair judged = judged_hair(hair, poses, settings);
  const double blended = judge_orders(hair.surface, judged, one, settings).psnr;
  settings.opaque_threshold = 0.75f;
  EXPECT_GT(blended, judge_orders(hair.surface, judged, one, settings).psnr + 3);
}

TEST(SeenLines, LightFallsFromAboveAndDarkHairIsDark) {
  const lab::OpenedAsset opened(card_contents(std::vector<Card>{{.alpha = 150}}));
  const SeenHair hair(opened.asset());
  const auto positions = posed_positions(opened.asset(), {});
  const auto mean = [&](const Eigen::Vector3f& towards_eye) {
    const SeenLines seen = see_lines(hair, positions, towards_eye, 0.01f, 0.95f);
    Eigen::Array3f sum = Eigen::Array3f::Zero();
    for (const SeenLayer& each : seen.layers) sum += each.color;
    return seen.layers.empty() ? -1.0f : sum.mean() / float(seen.layers.size());
  };
  EXPECT_GT(mean(Eigen::Vector3f(0, 0.5f, 1).normalized()), 0);
  EXPECT_GT(mean(Eigen::Vector3f(0, -0.9f, 0.3f).normalized()), mean(Eigen::Vector3f(0, 0.9f, 0.3f).normalized()))
      << "the card faces the light that moves with an eye below it";
}

TEST(SeenLines, HitsShowAllThatSeveralThresholdsMaySee) {
  // Where mips make a card less solid, what is behind it shows as well.
  constexpr std::size_t kSolid = 253;
  AssetContents contents = card_contents(std::vector<Card>{{.center = {0, 0, 0.1f}, .alpha = kSolid}, {.alpha = 150}});
  const lab::OpenedAsset opened(contents);
  contents.texels[4 * kSolid + 3] = std::byte{130};
  const lab::OpenedAsset fainter(contents);
  const SeenHair hair(opened.asset());
  const auto positions = posed_positions(opened.asset(), {});
  const SeenHits hits = see_hits(hair, positions, Eigen::Vector3f::UnitZ(), 0.01f);
  ASSERT_GT(hits.behind.size(), 100u);
  EXPECT_EQ(hits.hits.size(), 2 * hits.behind.size());
  const SeenLines seen = lines_of(hits, HairSurface(fainter.asset()).alpha, 0.95f);
  EXPECT_EQ(seen.layers.size(), hits.hits.size());
  EXPECT_NEAR(seen.layers[0].alpha, 130.0f / 255, 1.0e-6f);
  EXPECT_NEAR(lines_of(hits, hair.surface.alpha, 0.95f).layers[0].alpha, float(kSolid) / 255, 1.0e-6f);
}

TEST(SeenLines, HitsEndBehindSolidOnesAlone) {
  const auto hits_of_line = [](int alpha) {
    std::vector<Card> cards;
    for (int i = 0; i < 12; ++i) cards.push_back({.center = {0, 0, -0.01f * float(i)}, .alpha = alpha});
    const lab::OpenedAsset opened(card_contents(cards));
    const auto positions = posed_positions(opened.asset(), {});
    const SeenHits hits = see_hits(SeenHair(opened.asset()), positions, Eigen::Vector3f::UnitZ(), 0.01f);
    return hits.hits.size() / std::max<std::size_t>(hits.behind.size(), 1);
  };
  EXPECT_EQ(hits_of_line(230), 12u) << "each is blended, with some thresholds";
  EXPECT_LT(hits_of_line(255), 9u);
  EXPECT_GT(hits_of_line(255), 3u) << "mips may make them less solid";
}

TEST(SeenLines, TheHeadIsSeenThroughHair) {
  AssetContents contents = card_contents(std::vector<Card>{{.center = {0, 0, 0.2f}, .alpha = 150}});
  add_ball(contents, {0, 0, 0}, 0.05f);
  const lab::OpenedAsset opened(contents);
  const SeenLines seen =
      see_lines(SeenHair(opened.asset()), posed_positions(opened.asset(), {}), Eigen::Vector3f::UnitZ(), 0.01f, 0.95f);
  std::size_t clay = 0;
  for (const Eigen::Array3f& behind : seen.behind) clay += behind.x() > 1.05f * behind.z() ? 1 : 0;
  EXPECT_GT(clay, seen.size() / 20);
  EXPECT_LT(clay, seen.size() / 3);
}

}  // namespace coif::visibility::seen_lines_test
