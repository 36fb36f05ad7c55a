// Hair of heads that are turned and then held.

#include "report/stability/held_heads.h"

#include "report/stability/measure_stability.h"

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace coif::report::held_heads_test {

constexpr std::uint64_t kAll = std::numeric_limits<std::uint64_t>::max();

/// Soft strands of the passive model, whose roots fold far under heads upside down.
StressRig soft_strands() {
  return {.chains = 4,
          .bones_per_chain = 6,
          .bone_length = 0.05,
          .root_resistance = 0.004,
          .tip_resistance = 0.001,
          .friction = 2.2,
          .damping_ratio = 0.45,
          .torsion = double(kShortestArc)};
}

TEST(HeldHeads, SoftHairComesToRestInEveryAttitude) {
  const StressAsset hair(soft_strands(), ChainModel::kPassive);
  ASSERT_TRUE(hair.is_open());
  for (const HeldHeads& way : ways_to_hold(hair.asset(), kAll)) {
    if (way.frame_rate == 144) continue;
    const HeldHeadsFinding found = hold_heads(hair.asset(), way);
    EXPECT_FALSE(found.is_restless()) << name_of(way) << ": " << found.rest_speed << " m/s at " << found.up[0] << ", "
                                      << found.up[1] << ", " << found.up[2];
    EXPECT_LT(found.settled_after, kSettlingTime) << name_of(way);
    EXPECT_GT(found.max_speed, 0.1) << "it was moved";
  }
}

TEST(HeldHeads, StiffenedHairRestsToo) {
  const StressAsset hair(soft_strands(), ChainModel::kPassive);
  for (const float factor : {0.1f, 10.0f, 1e3f, 1e6f}) {
    for (const bool is_all : {false, true}) {
      HeldHeads held{.substeps = 1, .seconds = 16, .stiffness = factor};
      if (is_all && factor < 1e3f) continue;  // little damping lets it swing, ten times as much lets it sink for long
      if (is_all) held.damping = held.friction = factor;
      const HeldHeadsFinding found = hold_heads(hair.asset(), held);
      EXPECT_FALSE(found.is_restless()) << factor << ": " << found.rest_speed << " m/s";
    }
  }
}

TEST(HeldHeads, HairThatNothingCalmsIsRestless) {
  const StressAsset hair(soft_strands(), ChainModel::kCascade);
  const HeldHeadsFinding found = hold_heads(hair.asset(), {.substeps = 8, .seconds = 14, .damping = 0, .friction = 0});
  EXPECT_TRUE(found.is_restless());
  EXPECT_GT(found.rest_speed, kAtRest);
  EXPECT_GT(found.settled_after, kSettlingTime);
}

TEST(HeldHeads, AreTriedInAllWaysThatTheBudgetAllows) {
  const StressAsset hair(soft_strands(), ChainModel::kPassive);
  const auto all = ways_to_hold(hair.asset(), kAll);
  EXPECT_EQ(all.size(), 30u) << "five numbers of parts, three rates, with and without colliders";
  std::set<std::string> names;
  for (const HeldHeads& way : all) names.insert(name_of(way));
  EXPECT_EQ(names.size(), all.size());
  const auto few = ways_to_hold(hair.asset(), 10'000'000);
  EXPECT_LT(few.size(), all.size());
  EXPECT_FALSE(few.empty());
}

}  // namespace coif::report::held_heads_test
