#include "cook/bake_dynamics.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

TEST(BakeDynamics, CurvesAreLinearBetweenPointsAndConstantOutside) {
  const std::vector<CurvePoint> curve{{0.2, 1.0}, {0.4, 0.5}, {0.8, 0.1}};
  EXPECT_DOUBLE_EQ(evaluate_curve(curve, 0.0), 1.0);
  EXPECT_DOUBLE_EQ(evaluate_curve(curve, 0.3), 0.75);
  EXPECT_DOUBLE_EQ(evaluate_curve(curve, 0.6), 0.3);
  EXPECT_DOUBLE_EQ(evaluate_curve(curve, 1.0), 0.1);
  EXPECT_DOUBLE_EQ(evaluate_curve(std::vector<CurvePoint>{{0.5, 0.3}}, 0.9), 0.3);
}

Skeleton chain_of(std::uint32_t bones) {
  Skeleton skeleton;
  skeleton.bones.resize(1 + bones);
  skeleton.bones[0].kind = BoneKind::kHead;
  for (std::uint32_t i = 1; i <= bones; ++i) {
    skeleton.bones[i].kind = BoneKind::kSimulated;
    skeleton.bones[i].parent = i - 1;
    skeleton.bones[i].place = double(i) / bones;
  }
  skeleton.chains = {{1, bones, 0, 0}};
  return skeleton;
}

std::vector<DynamicsRecord> records_of(const Skeleton& skeleton) {
  return bake_dynamics(SourceModel(), skeleton, default_recipe()).records;
}

TEST(BakeDynamics, ResistanceFallsFromRootToTip) {
  const auto records = records_of(chain_of(3));
  ASSERT_EQ(records.size(), 4u);
  EXPECT_GT(records[1].resistance, records[2].resistance);
  EXPECT_GT(records[2].resistance, records[3].resistance);
  EXPECT_FLOAT_EQ(records[2].resistance, float(0.5 * (0.35 + 0.06))) << "the middle bone has the curve's middle";
}

TEST(BakeDynamics, AChainOfOneBoneTakesTheCurvesMiddle) {
  EXPECT_FLOAT_EQ(records_of(chain_of(1))[1].resistance, float(0.5 * (0.35 + 0.06)));
}

TEST(BakeDynamics, RigidHairStoresNone) {
  Skeleton head_alone;
  head_alone.bones.resize(1);
  EXPECT_TRUE(records_of(head_alone).empty());
}

}  // namespace
}  // namespace coif
