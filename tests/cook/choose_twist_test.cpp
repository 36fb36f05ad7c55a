#include "cook/dynamics/settle_dynamics.h"
#include "cook/recipe/recipe.h"
#include "cook/told.h"

#include "lab/rig.h"
#include "lab/runtime_solver.h"
#include "models/test_rig.h"
#include "motion/head_path.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace coif::cook::choose_twist_test {

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

Told<std::vector<DynamicsRecord>> chosen_for(const AssetContents& contents, unsigned threads = 1) {
  return told([&](Findings& findings) { return choose_twist(contents, threads, findings); });
}

TEST(ChooseTwist, LeavesItOutWhereNoMotionFoldsABone) {
  const auto chosen = chosen_for(upright_and_hanging(4000));
  EXPECT_EQ(chosen.made[1].torsion, kShortestArc);
  EXPECT_EQ(chosen.made[2].torsion, kShortestArc);
  ASSERT_EQ(chosen.left_out.size(), 1u);
  EXPECT_GT(chosen.left_out[0].bytes_per_head, 0u);
  EXPECT_GT(chosen.left_out[0].ns_per_frame, 0);
  EXPECT_TRUE(chosen.notes.empty());
}

TEST(ChooseTwist, KeepsItInTheChainThatFallsOverAndNamesIt) {
  const auto chosen = chosen_for(upright_and_hanging(1));
  EXPECT_EQ(chosen.made[1].torsion, kTorsion);
  EXPECT_EQ(chosen.made[2].torsion, kShortestArc);
  ASSERT_EQ(chosen.notes.size(), 1u);
  EXPECT_NE(chosen.notes[0].find("twist: carried in chain "), std::string::npos) << chosen.notes[0];
}

TEST(ChooseTwist, NamesFourChainsAndCountsTheOthers) {
  for (const int chains : {1, 4, 5, 7}) {
    TestRig rig;
    for (int i = 0; i < chains; ++i) {
      rig.add(
          {.rest_direction = {0.28f, 0.96f, 0}, .length = 0.1f, .stiffness = 1, .damping = 20, .torsion = kTorsion});
    }
    const auto chosen = chosen_for(rig.contents());
    ASSERT_EQ(chosen.notes.size(), 1u);
    const char* const named = chains == 1   ? "in chain 0, where"
                              : chains == 4 ? "in chains 0, 1, 2, 3, where"
                              : chains == 5 ? "in chains 0, 1, 2, 3, 1 more, where"
                                            : "in chains 0, 1, 2, 3, 3 more, where";
    EXPECT_NE(chosen.notes[0].find(named), std::string::npos) << chosen.notes[0];
  }
}

TEST(ChooseTwist, TakesALimitAtItsWord) {
  AssetContents limited = upright_and_hanging(1);
  limited.dynamics[1].angle_limit = 1;
  EXPECT_EQ(chosen_for(limited).made[1].torsion, kShortestArc);
}

TEST(ChooseTwist, ALimitFromTheHeadsDirectionIsNoneFromTheParents) {
  // Gravity turns the first bone one way and the second the other, each by no more than the limit.
  constexpr float kLimit = 1.7f;
  const auto second_bone = [](float parent_share) {
    TestRig rig;
    rig.add(
        {.rest_direction = {0.28f, 0.96f, 0}, .length = 0.1f, .stiffness = 1, .damping = 20, .angle_limit = kLimit});
    rig.add({.parent = 1,
             .rest_direction = {-0.96f, 0.28f, 0},
             .length = 0.1f,
             .stiffness = 1,
             .damping = 20,
             .torsion = kTorsion,
             .angle_limit = kLimit,
             .parent_share = parent_share});
    return chosen_for(rig.contents()).made[2].torsion;
  };
  EXPECT_EQ(second_bone(1), kShortestArc);
  EXPECT_EQ(second_bone(0), kTorsion);
}

/// Winds down and around, 0.3 m: where a bone twists, all that hang from it move.
TestRig curl() {
  TestRig rig;
  std::uint32_t parent = 0;
  for (const Vec3& direction : {Vec3{0, -0.8f, -0.6f}, {0.6f, -0.8f, 0}, {0, -0.8f, 0.6f}, {-0.6f, -0.8f, 0}}) {
    parent = rig.add({.parent = parent,
                      .joint = {0, 0, -0.1f},
                      .rest_direction = direction,
                      .length = 0.075f,
                      .stiffness = 600,
                      .damping = 60,
                      .torsion = kTorsion});
  }
  return rig;
}

/// Largest distance of any bone's end to where it is when every bone carries a twist, as a share of the chain's length.
double moved_by_the_choice(const AssetContents& contents) {
  AssetContents chosen = contents;
  chosen.dynamics = chosen_for(contents).made;
  const lab::OpenedAsset with(contents), without(chosen);
  double worst = 0;
  for (const motion::MotionInfo& info : motion::all_motions()) {
    const auto path = motion::path_of(info.motion);
    lab::RuntimeSolver twisting(with.asset(), {}, kCoifSolver, 2), plain(without.asset(), {}, kCoifSolver, 2);
    twisting.reset(path->pose(0));
    plain.reset(path->pose(0));
    for (int frame = 1; frame <= 180; ++frame) {
      EXPECT_TRUE(twisting.step(path->pose(frame / 60.0), 1 / 60.0));
      EXPECT_TRUE(plain.step(path->pose(frame / 60.0), 1 / 60.0));
      for (std::size_t b = 0; b < plain.bone_ends().size(); ++b) {
        worst = std::max(worst, (plain.bone_ends()[b] - twisting.bone_ends()[b]).norm());
      }
    }
  }
  return worst / 0.3;
}

TEST(ChooseTwist, WhatIsLeftOutHardlyShows) {
  const AssetContents contents = curl().contents();
  EXPECT_EQ(chosen_for(contents).made.back().torsion, kShortestArc);
  EXPECT_LT(moved_by_the_choice(contents), 0.02);
  EXPECT_GT(moved_by_the_choice(contents), 0.001) << "or nothing was chosen";
}

TEST(NominalCost, ATwistCostsWhatLeavingItOutSaves) {
  AssetContents contents = calm_strand(4, 0.3f).contents();
  const auto cost = [&] {
    const auto tuned = tune_solver(contents, default_recipe(), 1, unheard());
    EXPECT_TRUE(tuned && !tuned->quality.empty());
    return tuned ? std::pair(tuned->quality[0].cost, tuned->quality[0].substeps) : std::pair(0.0f, 0u);
  };
  const auto chosen = chosen_for(contents);
  const auto [with, substeps] = cost();
  contents.dynamics = chosen.made;
  const auto [without, same_substeps] = cost();
  ASSERT_EQ(chosen.left_out.size(), 1u);
  EXPECT_EQ(substeps, same_substeps);
  EXPECT_FLOAT_EQ(with - without, float(nominal_twist_cost(4, substeps)));
  EXPECT_GT(chosen.left_out[0].ns_per_frame, 0);
  EXPECT_EQ(chosen.left_out[0].ns_per_frame, nominal_twist_cost(4, 1));
}

TEST(ChooseTwist, ChangesNothingButTheTorsion) {
  const AssetContents contents = upright_and_hanging(4000);
  const auto chosen = chosen_for(contents);
  ASSERT_EQ(chosen.made.size(), contents.dynamics.size());
  for (std::size_t i = 1; i < contents.dynamics.size(); ++i) {
    EXPECT_EQ(chosen.made[i].stiffness, contents.dynamics[i].stiffness);
    EXPECT_EQ(chosen.made[i].damping, contents.dynamics[i].damping);
  }
  EXPECT_EQ(chosen_for(contents, 4).made[1].torsion, chosen.made[1].torsion) << "whatever the threads";
}

}  // namespace coif::cook::choose_twist_test
