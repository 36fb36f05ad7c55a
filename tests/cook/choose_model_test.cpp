// Which model moves hair that was meant for the cascade.

#include "cook/dynamics/settle_dynamics.h"

#include "cook/told.h"
#include "cook/vrm_chain.h"
#include "lab/rig.h"

#include <gtest/gtest.h>

namespace coif::choose_model_test {

AssetContents passive_of(AssetContents contents) {
  contents.skeleton.flags |= kSkeletonPassive;
  for (DynamicsRecord& record : contents.dynamics) record.torsion = kShortestArc;
  return contents;
}

Told<bool> needs_passive(const AssetContents& contents, unsigned threads = 1) {
  return told(
      [&](Findings& findings) { return needs_passive_model(contents, passive_of(contents), threads, findings); });
}

TEST(ChooseModel, SoftHairThatACascadeWouldAmplifyIsPassive) {
  const AssetContents soft =
      rig_of_chain({.bones = 5, .length = 0.4f, .stiffness = 60, .damping_ratio = 0.2f}).contents();
  const auto chosen = needs_passive(soft);
  EXPECT_TRUE(chosen.made);
  ASSERT_EQ(chosen.notes.size(), 1u);
  EXPECT_NE(chosen.notes[0].find("passive model"), std::string::npos) << chosen.notes[0];
  EXPECT_NE(chosen.notes[0].find("tumble"), std::string::npos) << "and says what went wrong: " << chosen.notes[0];
  EXPECT_EQ(needs_passive(soft, 3).notes, chosen.notes);
}

TEST(ChooseModel, HairWithOneMotionAsACascadeStaysOne) {
  const auto chosen = needs_passive(rig_of_chain({.bones = 3, .length = 0.3f, .damping_ratio = 1}).contents());
  EXPECT_FALSE(chosen.made);
  EXPECT_TRUE(chosen.notes.empty());
}

TEST(ChooseModel, WhatIsTooStiffToBeCheckedStaysACascade) {
  const AssetContents stiff =
      rig_of_chain({.bones = 16, .length = 0.6f, .stiffness = 4000, .damping_ratio = 0.3f}).contents();
  EXPECT_FALSE(needs_passive(stiff).made);
}

}  // namespace coif::choose_model_test
