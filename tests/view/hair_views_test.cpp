#include "view/page/hair_views.h"

#include "base/json.h"
#include "models/drawn_card.h"
#include "view/page/triangle_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace coif::view::hair_views_test {

AssetContents two_cards() {
  return card_contents(std::array{DrawnCard{.center = {0, 0, 0}}, DrawnCard{.center = {0, 0, 1}}});
}

HairInstance resting(const std::vector<Mat34>& palette, std::uint32_t lod = 0) { return {HeadPose{}, palette, lod}; }

/// The rest pose of one bone.
std::vector<Mat34> rest() { return std::vector<Mat34>(1); }

ScreenColor color_of(const TriangleCorner& corner) { return {corner.color[0], corner.color[1], corner.color[2]}; }

double brightness(const ScreenColor& color) { return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2]; }

TEST(TriangleCorners, AreTheLevelsTrianglesInTheirOrder) {
  const DrawnAsset asset(two_cards());
  TriangleCorners corners(*asset);
  const std::vector<Mat34> palette = rest();
  const auto drawn = corners.of(HairView::kOrder, resting(palette), 0);
  ASSERT_EQ(drawn.size(), (*asset).indices().size());
  EXPECT_EQ(corners.most(), drawn.size());
  for (std::size_t i = 0; i < drawn.size(); ++i) {
    const VertexRecord& vertex = (*asset).vertices()[(*asset).indices()[i]];
    EXPECT_EQ(drawn[i].position.z, vertex.position[2]);
    EXPECT_EQ(drawn[i].uv[0], vertex.uv[0]);
    EXPECT_EQ(color_of(drawn[i]), order_color(double(i / 3) / double(drawn.size() / 3 - 1)));
  }
}

TEST(TriangleCorners, FollowTheOrderOfTheView) {
  AssetContents contents = two_cards();
  contents.orders = {2, 3, 0, 1};  // the second card first
  contents.order_views = second_from_behind();
  const DrawnAsset asset(contents);
  TriangleCorners corners(*asset);
  const std::vector<Mat34> palette = rest();
  const auto drawn = corners.of(HairView::kOrder, resting(palette), 1);
  ASSERT_EQ(drawn.size(), 12u);
  EXPECT_EQ(drawn.front().position.z, 1);
  EXPECT_EQ(drawn.back().position.z, 0);
  EXPECT_EQ(color_of(drawn.front()), order_color(0));
  EXPECT_EQ(color_of(drawn.back()), order_color(1));
}

TEST(TriangleCorners, KeepAPatchsColourInEveryOrder) {
  AssetContents contents = two_cards();
  contents.orders = {2, 0, 3, 1};
  contents.order_views = second_from_behind();
  const DrawnAsset asset(contents);
  TriangleCorners corners(*asset);
  const std::vector<Mat34> palette = rest();
  for (const std::uint32_t order : {0u, 1u}) {
    for (const TriangleCorner& corner : corners.of(HairView::kPatches, resting(palette), order)) {
      EXPECT_EQ(color_of(corner), screen_color_of_patch(corner.position.z == 0 ? 0 : 1));
    }
  }
}

TEST(TriangleCorners, MoveWithTheBones) {
  const DrawnAsset asset(two_cards());
  TriangleCorners corners(*asset);
  std::vector<Mat34> palette = rest();
  palette[0].m[1][3] += 0.25f;
  const float moved = corners.of(HairView::kPatches, resting(palette), 0)[0].position.y;
  EXPECT_EQ(moved, (*asset).vertices()[(*asset).indices()[0]].position[1] + 0.25f);
  EXPECT_TRUE(corners.of(HairView::kPatches, resting(palette, 7), 0).empty()) << "no such level";
  palette.resize(3);
  EXPECT_TRUE(corners.of(HairView::kPatches, resting(palette), 0).empty()) << "another asset's palette";
}

TEST(HairViews, ColoursGetBrighterAndAreShownAsTheyAre) {
  for (std::size_t i = 1; i < kLayerColors.size(); ++i) {
    EXPECT_GT(brightness(kLayerColors[i]), brightness(kLayerColors[i - 1]) + 10) << i;
  }
  for (int i = 1; i <= 20; ++i) EXPECT_GT(brightness(order_color(i / 20.0)), brightness(order_color((i - 1) / 20.0)));
  // Beyond 0.75 of a screen's light develop() bends what is drawn.
  constexpr std::uint8_t kBent = 225;
  for (const ScreenColor& color : kLayerColors) EXPECT_LT(*std::ranges::max_element(color), kBent);
  for (int i = 0; i <= 20; ++i) EXPECT_LT(std::ranges::max(order_color(i / 20.0)), kBent);
}

TEST(HairViews, PatchesOfAnAssetDiffer) {
  std::set<ScreenColor> colors;
  for (std::size_t patch = 0; patch < 200; ++patch) colors.insert(screen_color_of_patch(patch));
  EXPECT_GE(colors.size(), 195u);
}

TEST(HairViews, LegendsSayWhatEachColourMeans) {
  const DrawnAsset asset(two_cards());
  const auto legend = [&](HairView view) { return nlohmann::json::parse(legend_json(*asset, view, 0)); };
  EXPECT_EQ(legend(HairView::kHair)["title"], "");
  EXPECT_NE(legend(HairView::kPatches)["title"].get<std::string>().find("2 patches"), std::string::npos);
  const auto layers = legend(HairView::kOverdraw);
  ASSERT_EQ(layers["colors"].size(), kLayerColors.size());
  EXPECT_EQ(layers["colors"][0]["color"], "#2c1e6e");
  std::vector<std::string> texts;
  for (const auto& entry : layers["colors"]) texts.push_back(entry["text"]);
  EXPECT_EQ(texts, (std::vector<std::string>{"1", "2", "3 to 4", "5 to 8", "9 to 16", "17 to 32", "33 and more"}));
  const auto order = legend(HairView::kOrder);
  EXPECT_EQ(order["colors"].front()["text"], "first");
  EXPECT_EQ(order["colors"].back()["text"], "last");
  EXPECT_FALSE(order["title"].get<std::string>().empty());
}

TEST(HairViews, NumbersOutOfRangeShowTheHair) {
  for (const float number : {-1.0f, 0.0f, 4.0f, 1e9f, float(NAN)}) EXPECT_EQ(hair_view_of(number), HairView::kHair);
  EXPECT_EQ(hair_view_of(2), HairView::kOverdraw);
}

}  // namespace coif::view::hair_views_test
