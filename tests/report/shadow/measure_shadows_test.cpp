#include "report/shadow/measure_shadows.h"

#include "render/egl_context.h"
#include "visibility/card_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace coif {
namespace {

const ShadowSettings kSmall{.sizes = {128}, .spacing = 0.005};

class MeasureShadows : public testing::Test {
 protected:
  void SetUp() override {
    const auto context = EglContext::create();
    if (!context) GTEST_SKIP() << context.error().message;
  }

  /// Layers of cards around a head, further apart than a texel of the map.
  static AssetContents layered(int alpha) {
    std::vector<Card> cards;
    for (int layer = 0; layer < 3; ++layer) {
      for (const float side : {-1.0f, 1.0f}) {
        const float distance = 0.14f + 0.03f * float(layer);
        cards.push_back({{0, 0, side * distance}, {0.12f * side, 0, 0}, {0, 0.12f, 0}, alpha});
        cards.push_back({{side * distance, 0, 0}, {0, 0, -0.12f * side}, {0, 0.12f, 0}, alpha});
      }
    }
    AssetContents contents = card_contents(cards);
    add_ball(contents, Eigen::Vector3f::Zero(), 0.1f);
    return contents;
  }

  static ShadowReport measured(const AssetContents& contents) {
    const OpenedAsset asset(contents);
    auto report = measure_shadows(asset.asset(), kSmall, {});
    EXPECT_TRUE(report) << report.error().message;
    return report ? *report : ShadowReport{};
  }

  static const ShadowTotal& total(const ShadowReport& report, const std::string& technique, std::uint32_t layers = 0) {
    const auto found = std::ranges::find_if(
        report.totals, [&](const ShadowTotal& one) { return one.technique == technique && one.layers == layers; });
    EXPECT_NE(found, report.totals.end()) << technique << ", " << layers;
    return *found;
  }
};

TEST_F(MeasureShadows, LayersKnowHalfTransparentHairAndAPlainMapDoesNot) {
  const ShadowReport report = measured(layered(128));
  const double none = total(report, "none").hair.rmse;
  const double plain = total(report, "plain").hair.rmse;
  const double four = total(report, "deep", 4).hair.rmse, eight = total(report, "deep", 8).hair.rmse;
  EXPECT_GT(none, 0.4);
  EXPECT_GT(plain, 0.25) << "half-transparent hair is solid to it";
  EXPECT_LT(four, 0.6 * plain);
  EXPECT_LE(eight, four);
  EXPECT_LT(eight, 0.12);
  EXPECT_LT(total(report, "deep", 4).head.rmse, 0.1);
  EXPECT_GT(total(report, "none").hair.bias, 0.3) << "without shadows all is too light";
}

TEST_F(MeasureShadows, EveryTechniqueKnowsSolidHair) {
  const ShadowReport report = measured(layered(255));
  for (const ShadowTotal& one : report.totals) {
    if (one.technique == "none") continue;
    EXPECT_LT(one.hair.rmse, 0.2) << one.technique << ", " << one.layers;
    EXPECT_LT(one.head.rmse, 0.15) << one.technique << ", " << one.layers;
  }
}

TEST_F(MeasureShadows, HasARowForEachTechniqueLightAndPose) {
  const ShadowReport report = measured(layered(128));
  EXPECT_EQ(report.rows.size(), 4 * report.lights.size()) << "rigid hair has one pose";
  EXPECT_EQ(report.totals.size(), 4u);
  EXPECT_GT(report.hair_points, 1000u);
  EXPECT_GT(report.head_points, 1000u);
  EXPECT_EQ(total(report, "plain").bytes, 128u * 128 * 4);
  for (const ShadowRow& row : report.rows) EXPECT_EQ(row.ms > 0, row.size > 0);
}

TEST_F(MeasureShadows, RefusesWhatItCannotMeasure) {
  const OpenedAsset asset(layered(128));
  for (const ShadowSettings& bad : {ShadowSettings{.sizes = {}}, {.sizes = {15}}, {.sizes = {256}, .spacing = 0.1}}) {
    const auto report = measure_shadows(asset.asset(), bad, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ToolError::Kind::kUsage);
  }
  const auto report = measure_shadows(Asset{}, kSmall, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ToolError::Kind::kBadInput);
}

}  // namespace
}  // namespace coif
