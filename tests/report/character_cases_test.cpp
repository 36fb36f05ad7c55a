// Stress by what moves beside the hair.

#include "report/stability/measure_stability.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::report::character_cases_test {

constexpr double kAllowed = 0.01;  // % of the radius

StabilityRow run(const Stress& stress, ChainModel model) {
  StressRig rig;
  rig.bones_per_chain = 6;
  rig.bone_length = 0.05;
  const StressAsset hair(rig, model);
  return StressSubject(stress, hair.asset(), lab::sample_of(lab::rig_of(hair.asset()), kMaxBones))
      .run(solver_on_a_character());
}

TEST(CharacterCases, AreMoreThanEightThatLeaveNoBoneInside) {
  const auto cases = character_cases();
  EXPECT_GE(cases.size(), 8u);
  for (const ChainModel model : {ChainModel::kCascade, ChainModel::kPassive}) {
    for (const Stress& stress : cases) {
      const StabilityRow row = run(stress, model);
      const bool is_bad = stress.about.name.find("not a number") != std::string::npos;
      EXPECT_EQ(row.outcome, is_bad ? Outcome::kRejected : Outcome::kOk) << stress.about.name;
      EXPECT_LE(row.penetration_max_pct, kAllowed) << stress.about.name << ' ' << int(model);
      EXPECT_LT(row.stretch_max_pct, 1e-2) << stress.about.name;
    }
  }
}

TEST(CharacterCases, MoveTheHair) {
  for (Stress stress : character_cases()) {
    if (stress.about.name.find("sphere") == std::string::npos && stress.about.name.find("pinched") == std::string::npos)
      continue;
    const double pushed = run(stress, ChainModel::kCascade).max_speed;
    stress.colliders = [](const lab::HairPlace&, double) { return std::vector<MovingCollider>(); };
    EXPECT_GT(pushed, 1.2 * run(stress, ChainModel::kCascade).max_speed) << stress.about.name;
  }
}

TEST(CharacterCases, AreForOurSolverAlone) {
  const StressAsset hair(StressRig{.bones_per_chain = 3});
  const Stress stress = character_cases().front();
  const StressSubject subject(stress, hair.asset(), lab::sample_of(lab::rig_of(hair.asset()), 64));
  EXPECT_TRUE(subject.is_for(*find_measured_solver("coif")));
  for (const char* other : {"thesis", "passive", "xpbd"}) EXPECT_FALSE(subject.is_for(*find_measured_solver(other)));
}

TEST(HairPlace, IsInTheMiddleOfTheLongestChain) {
  const StressAsset hair(StressRig{.chains = 1, .bones_per_chain = 4, .bone_length = 0.1});
  const lab::Rig rig = lab::rig_of(hair.asset());
  const lab::HairPlace place = lab::place_of(rig);
  EXPECT_NEAR(place.length, 0.4, 1e-6);
  EXPECT_NEAR(place.head_radius, 0.1, 1e-6);
  const Eigen::Vector3d root = rig.bones.front().joint;
  EXPECT_LT((place.middle - root).norm(), 0.2 + 1e-6);
  EXPECT_GT((place.middle - root).norm(), 0.19);
  EXPECT_NEAR(place.outward.dot(-Eigen::Vector3d::UnitZ()), 1, 1e-6) << "the chains hang behind the head";
}

}  // namespace coif::report::character_cases_test
