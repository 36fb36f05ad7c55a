#include "render/draw_distances.h"

#include "render/drawn_wig.h"

#include <array>
#include <cmath>

namespace coif {
namespace {

/// One bone and one card, half a metre high, with a coarser level that is drawn where a head takes less than a third
/// of the picture's height.
AssetContents card_with_levels() {
  AssetContents contents = card_contents(std::array{Card{.half_size = 0.25f}, Card{.half_size = 0.25f}});
  contents.lods = {{0, 1, 0.3f, 0}, {1, 1, 0, 0.01f}};
  contents.lod_bones = {0};
  return contents;
}

class DrawDistancesTest : public DrawnWigTest {
 protected:
  tl::expected<DrawDistances, ToolError> measure(const Asset& asset, std::vector<CrowdDistance> crowds,
                                                 double seconds = 0.2) {
    const auto stage = CrowdStage::create(asset, 96, 72);
    if (!stage) return tl::unexpected(stage.error());
    return measure_distances(asset, **stage, crowds, maker(), seconds);
  }
};

TEST_F(DrawDistancesTest, MoreHeadsAndFurtherOnesAreSmallerAndCoarser) {
  const OpenedAsset card(card_with_levels());
  palette_.resize(1);
  const auto found = measure(*card, {{1, 1}, {4, 1}, {4, 2}, {4, 4}});
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->rows.size(), 4u);
  double finer_share = 1e9;
  for (const DrawDistance& distance : found->rows) {
    EXPECT_LT(distance.screen_share, finer_share);
    EXPECT_EQ(distance.lod, distance.screen_share < 0.3 ? 1u : 0u) << distance.screen_share;
    EXPECT_GT(distance.time.seconds, 0);
    EXPECT_GT(distance.finest.seconds, 0);
    finer_share = distance.screen_share;
  }
  EXPECT_LT(found->rows[2].covered_pixels, 0.5 * found->rows[1].covered_pixels);
  EXPECT_EQ(found->rows.front().lod, 0u);
  EXPECT_EQ(found->rows.back().lod, 1u);
}

TEST_F(DrawDistancesTest, CoveredPixelsAreThoseOfTheHair) {
  const OpenedAsset card(card_with_levels());
  palette_.resize(1);
  const auto found = measure(*card, {{1, 1}});
  ASSERT_TRUE(found) << found.error().message;
  // The card is turned away by 30 degrees and seen from 5 degrees above; perspective and edges take their share.
  const double height = 72 * found->rows.front().screen_share;
  const double expected = height * height * std::cos(30 * 3.14159265 / 180);
  EXPECT_NEAR(found->rows.front().covered_pixels, expected, 0.15 * expected);
}

TEST_F(DrawDistancesTest, OneHeadIsNeverTooSlow) {
  const auto found = measure(*wig_, {{1, 1}, {10, 1}, {100, 1}}, 1e-9);
  ASSERT_TRUE(found) << found.error().message;
  ASSERT_EQ(found->rows.size(), 1u);
  EXPECT_EQ(found->rows.front().crowd.heads, 1u);
  ASSERT_EQ(found->left_out.size(), 2u);
  EXPECT_EQ(found->left_out[1].heads, 100u);
}

TEST_F(DrawDistancesTest, AHeadIsAsHighAsWhatKeepsHairOut) {
  AssetContents contents = card_with_levels();
  EXPECT_NEAR(head_height(*OpenedAsset(contents)), 0.5, 1e-6) << "without colliders, the hair";
  ColliderRecord sphere{};
  sphere.shape = ColliderShape::kSphere;
  sphere.radii[0] = sphere.radii[1] = sphere.radii[2] = 0.1f;
  sphere.rotation[3] = 1;
  ColliderRecord room = sphere;
  room.flags = kColliderKeepsInside;
  room.radii[0] = room.radii[1] = room.radii[2] = 3;
  contents.colliders = {sphere, room};
  EXPECT_NEAR(head_height(*OpenedAsset(contents)), 0.2, 1e-6);
}

}  // namespace
}  // namespace coif
