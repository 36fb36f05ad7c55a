#include "render/thesis_crowds.h"

#include "render/drawn_wig.h"

#include <set>
#include <tuple>

namespace coif {
namespace {

class ThesisCrowdsTest : public DrawnWigTest {
 protected:
  static ThesisCrowdSettings quick() { return {.heads = {4, 2}, .width = 32, .height = 24, .seconds = 1}; }
};

TEST_F(ThesisCrowdsTest, MeasuresFourWaysOfEveryCrowd) {
  const auto found = measure_thesis_crowds(*wig_, quick(), maker());
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_FALSE(found->device.empty());
  std::set<std::tuple<std::uint32_t, bool, bool>> ways;
  for (const ThesisCrowdRow& row : found->rows) {
    ways.insert({row.heads, row.transparency, row.simulation});
    EXPECT_GT(row.time.seconds, 0);
  }
  EXPECT_EQ(found->rows.size(), 8u);
  EXPECT_EQ(ways.size(), 8u);
  EXPECT_TRUE(ways.contains({2, true, true}));
  EXPECT_TRUE(ways.contains({4, false, false}));
  EXPECT_GT(steps_, 0u);
}

TEST_F(ThesisCrowdsTest, LeavesOutFramesThatTakeTooLong) {
  ThesisCrowdSettings settings = quick();
  settings.longest_frame = 1e-9;
  const auto found = measure_thesis_crowds(*wig_, settings, maker());
  ASSERT_TRUE(found) << found.error().message;
  EXPECT_TRUE(found->rows.empty());
  ASSERT_EQ(found->left_out.size(), 2u);
  EXPECT_EQ(found->left_out[0].heads, 2u);
}

TEST_F(ThesisCrowdsTest, PassesOnWhyThereIsNoCrowd) {
  const auto found = measure_thesis_crowds(*wig_, quick(), nobody);
  ASSERT_FALSE(found);
  EXPECT_EQ(found.error().message, "nobody came");
}

TEST_F(ThesisCrowdsTest, RefusesSettingsOutOfRange) {
  ThesisCrowdSettings empty = quick(), no_time = quick(), too_many = quick(), too_large = quick();
  empty.heads = {};
  no_time.seconds = 0;
  too_many.heads = {10'001};
  too_large.height = 8193;
  for (const ThesisCrowdSettings& settings : {empty, no_time, too_many, too_large}) {
    const auto found = measure_thesis_crowds(*wig_, settings, maker());
    ASSERT_FALSE(found);
    EXPECT_EQ(found.error().kind, ToolError::Kind::kUsage);
  }
}

}  // namespace
}  // namespace coif
