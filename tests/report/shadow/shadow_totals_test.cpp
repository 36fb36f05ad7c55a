#include "report/shadow/shadow_totals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

namespace coif {
namespace {

TEST(ShadowError, CountsPointsByTheirWeight) {
  const std::array points{ShadowPoint{{}, {}, 0.5f, 3, false}, ShadowPoint{{}, {}, 1.0f, 1, false},
                          ShadowPoint{{}, {}, 0.0f, 1, true}};
  const std::array light{0.7f, 0.6f, 0.3f};
  const ShadowError hair = shadow_error(points, light, false), head = shadow_error(points, light, true);
  EXPECT_NEAR(hair.bias, (3 * 0.2 - 0.4) / 4, 1e-6);
  EXPECT_NEAR(hair.rmse, std::sqrt((3 * 0.04 + 0.16) / 4), 1e-6);
  EXPECT_NEAR(head.bias, 0.3, 1e-6);
  EXPECT_NEAR(head.rmse, 0.3, 1e-6);
}

TEST(ShadowError, OfNoPointsIsNoNumber) {
  EXPECT_TRUE(std::isnan(shadow_error({}, {}, false).rmse));
  EXPECT_TRUE(std::isnan(shadow_error({}, {}, true).bias));
}

TEST(ShadowTotals, TakeEachTechniqueOverLightsAndPoses) {
  std::vector<ShadowRow> rows;
  const auto add = [&](std::uint32_t layers, const char* light, double rmse, double bias, double ms) {
    rows.push_back({.technique = "deep", .layers = layers, .size = 256, .light = light, .pose = "rest"});
    rows.back().hair = {rmse, bias};
    rows.back().ms = ms;
  };
  add(4, "above", 0.3, 0.1, 2);
  add(8, "above", 0.1, 0.0, 4);
  add(4, "side", 0.4, -0.3, 3);
  add(4, "back", 0.0, -0.1, 10);
  const std::vector<ShadowTotal> totals = shadow_totals(rows);
  ASSERT_EQ(totals.size(), 2u);
  EXPECT_EQ(totals[0].layers, 4u);
  EXPECT_NEAR(totals[0].hair.rmse, std::sqrt((0.09 + 0.16) / 3), 1e-9);
  EXPECT_NEAR(totals[0].hair.bias, -0.1, 1e-9);
  EXPECT_EQ(totals[0].worst_light, "side");
  EXPECT_EQ(totals[0].worst_rmse, 0.4);
  EXPECT_EQ(totals[0].ms, 3);
  EXPECT_TRUE(std::isnan(totals[0].head.rmse)) << "no row has a head";
  EXPECT_EQ(totals[1].layers, 8u);
}

}  // namespace
}  // namespace coif
