#include "cook/choose_twist.h"

#include "sim/test_rig.h"

#include <gtest/gtest.h>

namespace coif {
namespace {

constexpr float kTorsion = 20;

/// A bone that wants to stand upright, held by so stiff a spring (1/s^2), and one below it that hangs as it wants to.
AssetContents upright_and_hanging(float stiffness) {
  TestRig rig;
  rig.add({.rest_direction = {0, 1, 0}, .length = 0.1f, .stiffness = stiffness, .damping = 20, .torsion = kTorsion});
  rig.add({.length = 0.1f, .stiffness = 1500, .damping = 80, .torsion = kTorsion});
  // Straight up over its joint nothing decides to which side it falls.
  rig.bones[1].rest_direction[0] = 0.28f;
  rig.bones[1].rest_direction[1] = 0.96f;
  return rig.contents();
}

TEST(ChooseTwist, LeavesItOutWhereNoMotionFoldsABone) {
  const ChosenTwist chosen = choose_twist(upright_and_hanging(4000), 1);
  EXPECT_EQ(chosen.dynamics[1].torsion, kShortestArc);
  EXPECT_EQ(chosen.dynamics[2].torsion, kShortestArc);
  ASSERT_EQ(chosen.left_out.size(), 1u);
  EXPECT_GT(chosen.left_out[0].bytes_per_head, 0u);
  EXPECT_GT(chosen.left_out[0].ns_per_frame, 0);
  EXPECT_TRUE(chosen.notes.empty());
}

TEST(ChooseTwist, KeepsItInTheChainThatFallsOverAndNamesIt) {
  const ChosenTwist chosen = choose_twist(upright_and_hanging(1), 1);
  EXPECT_EQ(chosen.dynamics[1].torsion, kTorsion);
  EXPECT_EQ(chosen.dynamics[2].torsion, kShortestArc);
  ASSERT_EQ(chosen.notes.size(), 1u);
  EXPECT_NE(chosen.notes[0].find("twist: carried in chain "), std::string::npos) << chosen.notes[0];
}

TEST(ChooseTwist, TakesALimitAtItsWord) {
  AssetContents limited = upright_and_hanging(1);
  limited.dynamics[1].angle_limit = 1;
  EXPECT_EQ(choose_twist(limited, 1).dynamics[1].torsion, kShortestArc);
}

TEST(ChooseTwist, ChangesNothingButTheTorsion) {
  const AssetContents contents = upright_and_hanging(4000);
  const ChosenTwist chosen = choose_twist(contents, 1);
  ASSERT_EQ(chosen.dynamics.size(), contents.dynamics.size());
  for (std::size_t i = 1; i < contents.dynamics.size(); ++i) {
    EXPECT_EQ(chosen.dynamics[i].stiffness, contents.dynamics[i].stiffness);
    EXPECT_EQ(chosen.dynamics[i].damping, contents.dynamics[i].damping);
  }
  EXPECT_EQ(choose_twist(contents, 4).dynamics[1].torsion, chosen.dynamics[1].torsion) << "whatever the threads";
}

}  // namespace
}  // namespace coif
