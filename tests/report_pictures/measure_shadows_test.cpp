#include "report/shadow/measure_shadows.h"
#include "models/absent.h"
#include "models/card_asset.h"
#include "render/egl_context.h"
#include "report/shadow/deep_shadow_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iterator>
#include <limits>
#include <random>
#include <span>
#include <string>
#include <vector>

namespace coif::measure_shadows_test {

const report::ShadowSettings kSmall{.sizes = {128}, .spacing = 0.005};

class MeasureShadows : public testing::Test {
 protected:
  void SetUp() override {
    const auto context = render::EglContext::create();
    if (!context) COIF_FAIL_FOR_LACK_OF(context.error().message);
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

  static report::ShadowReport measured(const AssetContents& contents) {
    const lab::OpenedAsset asset(contents);
    auto report = report::measure_shadows(asset.asset(), kSmall, {});
    EXPECT_TRUE(report) << report.error().message;
    return report ? *report : report::ShadowReport{};
  }

  static const report::ShadowTotal& total(const report::ShadowReport& report, const std::string& technique,
                                          std::uint32_t layers = 0) {
    const auto found = std::ranges::find_if(report.totals, [&](const report::ShadowTotal& one) {
      return one.technique == technique && one.layers == layers;
    });
    EXPECT_NE(found, report.totals.end()) << technique << ", " << layers;
    return *found;
  }
};

TEST_F(MeasureShadows, LayersKnowHalfTransparentHairAndAPlainMapDoesNot) {
  const report::ShadowReport report = measured(layered(128));
  const double none = total(report, "none").hair.rmse;
  const double plain = total(report, "plain").hair.rmse;
  const double four = total(report, "deep", 4).hair.rmse, eight = total(report, "deep", 8).hair.rmse;
  EXPECT_GT(none, 0.4);
  EXPECT_GT(plain, 0.25) << "half-transparent hair is solid to it";
  EXPECT_LT(four, 0.6 * plain);
  EXPECT_LE(eight, four);
  EXPECT_LT(eight, 0.12);
  EXPECT_LT(total(report, "deep", 4).head.rmse, 0.1);
  for (const std::uint32_t peels : {4u, 6u}) EXPECT_LT(total(report, "deep-shadow", peels).hair.rmse, 0.5 * plain);
  EXPECT_LT(total(report, "deep-shadow-cpu").hair.rmse, 0.5 * plain);
  EXPECT_LT(total(report, "opacity", 12).hair.rmse, total(report, "opacity", 4).hair.rmse) << "more planes tell more";
  EXPECT_GT(total(report, "none").hair.bias, 0.3) << "without shadows all is too light";
}

// With larger maps it is more than twice as near; those take half a minute.
TEST_F(MeasureShadows, OfTheSampleTheDefaultIsNearerByHalfThanAPlainMapOfAsManyBytes) {
  std::ifstream file(COIF_COOKED_SAMPLE, std::ios::binary);
  const std::vector<char> content{std::istreambuf_iterator<char>(file), {}};
  AlignedBytes bytes(std::as_bytes(std::span(content)));
  Asset asset;
  ASSERT_TRUE(asset.open(bytes.bytes()));
  const auto report = report::measure_shadows(asset, {.sizes = {256, 344}, .spacing = 0.015}, {});
  ASSERT_TRUE(report) << report.error().message;
  const auto of_size = [&](const char* technique, std::uint32_t size) {
    return *std::ranges::find_if(
        report->totals, [&](const report::ShadowTotal& one) { return one.technique == technique && one.size == size; });
  };
  const report::ShadowTotal deep = of_size("deep-shadow", 256), plain = of_size("plain", 344);
  EXPECT_GE(plain.bytes, deep.bytes);
  EXPECT_LT(1.6 * deep.hair.rmse, plain.hair.rmse);
  EXPECT_LE(deep.head.rmse, plain.head.rmse);
  EXPECT_EQ(ShadowDesc{}.technique, &kDeepShadow) << "the default";
}

TEST_F(MeasureShadows, EveryTechniqueKnowsSolidHair) {
  const report::ShadowReport report = measured(layered(255));
  for (const report::ShadowTotal& one : report.totals) {
    if (one.technique == "none") continue;
    EXPECT_LT(one.hair.rmse, 0.2) << one.technique << ", " << one.layers;
    EXPECT_LT(one.head.rmse, 0.15) << one.technique << ", " << one.layers;
  }
}

TEST_F(MeasureShadows, HasARowForEachTechniqueLightAndPose) {
  const report::ShadowReport report = measured(layered(128));
  EXPECT_EQ(report.rows.size(), 9 * report.lights.size()) << "rigid hair has one pose";
  EXPECT_EQ(report.totals.size(), 9u);
  EXPECT_GT(report.hair_points, 1000u);
  EXPECT_GT(report.head_points, 1000u);
  EXPECT_EQ(total(report, "plain").bytes, 128u * 128 * 4);
  EXPECT_LT(total(report, "deep-shadow", 4).bytes, 128u * 128 * 10);
  EXPECT_LT(report.truth_rmse, 0.1) << "cards are wide";
  EXPECT_GT(report.truth_compared, 0.9);
  for (const report::ShadowRow& row : report.rows) {
    EXPECT_EQ(row.ms > 0, row.size > 0);
    EXPECT_EQ(row.read_ns > 0, row.size > 0);
    EXPECT_GE(row.hair.most, row.hair.rmse);
  }
}

TEST_F(MeasureShadows, RefusesWhatItCannotMeasure) {
  const lab::OpenedAsset asset(layered(128));
  for (const report::ShadowSettings& bad :
       {report::ShadowSettings{.sizes = {}}, {.sizes = {15}}, {.sizes = {256}, .spacing = 0.1}}) {
    const auto report = report::measure_shadows(asset.asset(), bad, {});
    ASSERT_FALSE(report);
    EXPECT_EQ(report.error().kind, ToolError::Kind::kUsage);
  }
  const auto report = report::measure_shadows(Asset{}, kSmall, {});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().kind, ToolError::Kind::kBadInput);
}

Card card_at(float z, int alpha) {
  Card card;
  card.center.z() = z;
  card.alpha = alpha;
  return card;
}

std::vector<report::ShadowPoint> points_of(const AssetContents& contents) {
  const lab::OpenedAsset asset(contents);
  const visibility::HairSurface surface(asset.asset());
  const auto positions = visibility::posed_positions(asset.asset(), {});
  return report::shadow_points(visibility::FragmentView(surface, positions, {.spacing = 0.01f}), surface, positions);
}

TEST(ShadowPoints, LoseTheAlphaOfWhatLiesBeforeThem) {
  const auto points = points_of(card_contents(std::array{card_at(0, 102), card_at(0.1f, 51), card_at(0.2f, 153)}));
  ASSERT_FALSE(points.empty());
  for (const report::ShadowPoint& point : points) {
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
  for (const report::ShadowPoint& point : points_of(contents)) {
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

std::vector<visibility::Fragment> random_line(std::mt19937& random) {
  std::uniform_real_distribution<float> depth(0, 0.1f), alpha(0.05f, 0.9f);
  std::vector<visibility::Fragment> line(1 + random() % 30);
  for (visibility::Fragment& fragment : line) fragment = {depth(random), alpha(random), 0, 0, true};
  std::ranges::sort(line, {}, &visibility::Fragment::depth);
  return line;
}

constexpr float kNoSolid = std::numeric_limits<float>::infinity();

TEST(Visibility, TakesEachFragmentsAlphaBehindItAndBeforeTheNext) {
  const std::array line{visibility::Fragment{0.01f, 0.5f}, visibility::Fragment{0.02f, 0.2f},
                        visibility::Fragment{0.5f, 0.5f}};
  const auto exact = report::visibility_of(line, 0.3f, 0.004f);
  EXPECT_EQ(report::light_at(exact, 0.01f), 1);
  EXPECT_EQ(report::light_at(exact, 0.0139f), 1) << "no further than it reaches";
  EXPECT_NEAR(report::light_at(exact, 0.02f), 0.5, 1e-6);
  EXPECT_NEAR(report::light_at(exact, 0.2f), 0.4, 1e-6);
  EXPECT_NEAR(report::light_at(exact, 1), 0.4, 1e-6) << "what lies behind the head is not there";
}

TEST(Visibility, StaysWithinItsBoundAndFallsWhenCompressed) {
  std::mt19937 random(3);
  for (const float bound : {0.001f, 0.02f, 0.1f}) {
    for (int i = 0; i < 200; ++i) {
      const auto exact = report::visibility_of(random_line(random), kNoSolid, 0.002f);
      const auto kept = report::compress_visibility(exact, bound);
      EXPECT_LE(kept.size(), exact.size());
      float last = 1;
      for (int k = 0; k <= 1200; ++k) {
        const float depth = 0.0001f * float(k), light = report::light_at(kept, depth);
        EXPECT_NEAR(light, report::light_at(exact, depth), bound + 1e-3f) << bound << ", " << i << ", " << depth;
        EXPECT_LE(light, last + 1e-6f);
        last = light;
      }
    }
  }
}

TEST(Visibility, TakesFewerVerticesWithAWiderBound) {
  std::mt19937 random(4);
  std::size_t narrow = 0, wide = 0, exact_size = 0;
  for (int i = 0; i < 200; ++i) {
    const auto exact = report::visibility_of(random_line(random), kNoSolid, 0.002f);
    exact_size += exact.size();
    narrow += report::compress_visibility(exact, 0.001f).size();
    wide += report::compress_visibility(exact, 0.05f).size();
  }
  EXPECT_LT(wide, narrow);
  EXPECT_LT(narrow, exact_size);
  EXPECT_TRUE(report::compress_visibility({}, 0.1f).empty());
}

TEST(ShadowError, CountsPointsByTheirWeight) {
  const std::array points{report::ShadowPoint{{}, {}, 0.5f, 3, false}, report::ShadowPoint{{}, {}, 1.0f, 1, false},
                          report::ShadowPoint{{}, {}, 0.0f, 1, true}};
  const std::array light{0.7f, 0.6f, 0.3f};
  const report::ShadowError hair = report::shadow_error(points, light, false),
                            head = report::shadow_error(points, light, true);
  EXPECT_NEAR(hair.bias, (3 * 0.2 - 0.4) / 4, 1e-6);
  EXPECT_NEAR(hair.rmse, std::sqrt((3 * 0.04 + 0.16) / 4), 1e-6);
  EXPECT_NEAR(head.bias, 0.3, 1e-6);
  EXPECT_NEAR(head.rmse, 0.3, 1e-6);
}

TEST(ShadowError, OfNoPointsIsNoNumber) {
  EXPECT_TRUE(std::isnan(report::shadow_error({}, {}, false).rmse));
  EXPECT_TRUE(std::isnan(report::shadow_error({}, {}, true).bias));
}

TEST(ShadowTotals, TakeEachTechniqueOverLightsAndPoses) {
  std::vector<report::ShadowRow> rows;
  const auto add = [&](std::uint32_t layers, const char* light, double rmse, double bias, double ms) {
    rows.push_back({.technique = "deep", .layers = layers, .size = 256, .light = light, .pose = "rest"});
    rows.back().hair = {rmse, bias};
    rows.back().ms = ms;
  };
  add(4, "above", 0.3, 0.1, 2);
  add(8, "above", 0.1, 0.0, 4);
  add(4, "side", 0.4, -0.3, 3);
  add(4, "back", 0.0, -0.1, 10);
  const std::vector<report::ShadowTotal> totals = report::shadow_totals(rows);
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

}  // namespace coif::measure_shadows_test
