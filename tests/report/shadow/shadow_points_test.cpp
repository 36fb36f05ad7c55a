#include "report/shadow/shadow_points.h"

#include "visibility/card_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace coif {
namespace {

Card card_at(float z, int alpha) {
  Card card;
  card.center.z() = z;
  card.alpha = alpha;
  return card;
}

std::vector<ShadowPoint> points_of(const AssetContents& contents) {
  const OpenedAsset asset(contents);
  const HairSurface surface(asset.asset());
  const auto positions = posed_positions(asset.asset(), {});
  return shadow_points(FragmentView(surface, positions, {.spacing = 0.01f}), surface, positions);
}

TEST(ShadowPoints, LoseTheAlphaOfWhatLiesBeforeThem) {
  const auto points = points_of(card_contents(std::array{card_at(0, 102), card_at(0.1f, 51), card_at(0.2f, 153)}));
  ASSERT_FALSE(points.empty());
  for (const ShadowPoint& point : points) {
    EXPECT_FALSE(point.is_head);
    EXPECT_GT(std::abs(point.normal.normalized().z()), 0.999f) << "cards across the light";
    const bool is_first = point.place.z() > 0.15f, is_second = !is_first && point.place.z() > 0.05f;
    EXPECT_NEAR(point.transmittance, is_first ? 1 : is_second ? 0.4 : 0.4 * 0.8, 1e-4) << point.place.z();
    EXPECT_NEAR(point.weight, is_first ? 0.6 : is_second ? 0.2 : 0.4, 1e-4);
  }
}

TEST(ShadowPoints, EndAtTheHeadWhichIsOneItself) {
  AssetContents contents = card_contents(std::array{card_at(0.2f, 128), card_at(-0.2f, 128)});
  add_ball(contents, Eigen::Vector3f::Zero(), 0.15f);  // wider than the cards
  int hair = 0, head = 0;
  for (const ShadowPoint& point : points_of(contents)) {
    EXPECT_GT(point.place.z(), point.is_head ? -0.001f : 0.19f) << "nothing behind the head";
    (point.is_head ? head : hair) += 1;
    if (!point.is_head) continue;
    EXPECT_NEAR(point.place.norm(), 0.15, 1e-3);
    const bool is_covered = std::max(std::abs(point.place.x()), std::abs(point.place.y())) < 0.1f;
    EXPECT_NEAR(point.transmittance, is_covered ? 1 - 128.0 / 255 : 1, 1e-3);
  }
  EXPECT_GT(hair, 100);
  EXPECT_GT(head, 100);
}

}  // namespace
}  // namespace coif
