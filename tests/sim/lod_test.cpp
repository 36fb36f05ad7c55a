#include <coif/lod.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace coif {
namespace {

std::vector<LodRecord> levels(std::initializer_list<float> screen_sizes) {
  std::vector<LodRecord> lods;
  for (const float size : screen_sizes) lods.push_back({std::uint32_t(lods.size()), 1, size, 0});
  return lods;
}

const std::vector<LodRecord> kFour = levels({0.5f, 0.2f, 0.05f, 0});

TEST(ScreenShare, IsOneWhereTheHeightFillsTheView) {
  const float fov = 0.8f;
  const float distance = 0.25f / 2 / std::tan(fov / 2);
  EXPECT_NEAR(screen_share(0.25f, distance, fov), 1.0f, 1e-6f);
  EXPECT_NEAR(screen_share(0.25f, 10 * distance, fov), 0.1f, 1e-6f);
}

TEST(ChooseLod, IsTheFinestThatFits) {
  const struct {
    float share;
    std::uint32_t level;
  } cases[] = {{9, 0}, {0.5f, 0}, {0.49f, 1}, {0.2f, 1}, {0.1f, 2}, {0.05f, 2}, {0.01f, 3}, {0, 3}};
  for (const auto& c : cases) {
    for (std::uint32_t current = 0; current < 4; ++current) EXPECT_EQ(choose_lod(kFour, c.share, current, 0), c.level);
  }
}

TEST(ChooseLod, NeverGetsFinerAsTheHeadShrinksNorCoarserAsItGrows) {
  for (const float hysteresis : {0.0f, 0.1f, 0.5f}) {
    std::uint32_t level = 0;
    for (float share = 1; share > 0.001f; share *= 0.99f) {
      const std::uint32_t next = choose_lod(kFour, share, level, hysteresis);
      EXPECT_GE(next, level);
      level = next;
    }
    EXPECT_EQ(level, 3u);
    for (float share = 0.001f; share < 2; share *= 1.01f) {
      const std::uint32_t next = choose_lod(kFour, share, level, hysteresis);
      EXPECT_LE(next, level);
      level = next;
    }
    EXPECT_EQ(level, 0u);
  }
}

TEST(ChooseLod, StaysWhereTheShareTremblesAboutABorder) {
  for (std::uint32_t current : {0u, 1u}) {
    for (const float share : {0.46f, 0.5f, 0.54f}) EXPECT_EQ(choose_lod(kFour, share, current, 0.1f), current);
  }
}

TEST(ChooseLod, LeavesALevelBeyondTheHysteresisAndSkipsLevels) {
  EXPECT_EQ(choose_lod(kFour, 0.44f, 0, 0.1f), 1u);
  EXPECT_EQ(choose_lod(kFour, 0.56f, 1, 0.1f), 0u);
  EXPECT_EQ(choose_lod(kFour, 0.01f, 0, 0.1f), 3u);
  EXPECT_EQ(choose_lod(kFour, 1, 3, 0.1f), 0u);
}

TEST(ChooseLod, AlwaysReturnsALevelThatExists) {
  const float odd[] = {NAN, INFINITY, -INFINITY, -1, 0, 1e-38f, 1e38f};
  for (const float share : odd) {
    for (const float hysteresis : odd) {
      for (const std::uint32_t current : {0u, 3u, 4u, kNone}) {
        EXPECT_LT(choose_lod(kFour, share, current, hysteresis), 4u);
      }
    }
  }
  EXPECT_EQ(choose_lod(kFour, NAN, 0, 0.1f), 3u);
  EXPECT_EQ(choose_lod({}, 0.5f, 7, 0.1f), 0u);
  EXPECT_EQ(choose_lod(levels({0}), 0.5f, 0, 0.1f), 0u);
}

}  // namespace
}  // namespace coif
