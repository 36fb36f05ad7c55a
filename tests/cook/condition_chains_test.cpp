// Chains whose equation has no solution to converge to are damped until it has one, and no others are touched.

#include "cook/dynamics/settle_dynamics.h"

#include "cook/dynamics/chain_groups.h"
#include "cook/told.h"
#include "cook/vrm_chain.h"
#include "lab/measure_runtime.h"
#include "lab/rig.h"
#include "lab/runtime_solver.h"

#include <gtest/gtest.h>

#include <array>
#include <cstring>

namespace coif::cook::condition_chains_test {

bool same(const std::vector<DynamicsRecord>& a, const std::vector<DynamicsRecord>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(DynamicsRecord)) == 0;
}

/// The names are "Head", "b1", "b2", ...
AssetContents named(const TestRig& rig) {
  AssetContents contents = rig.contents();
  contents.bone_names = {"Head"};
  for (std::size_t b = 1; b < contents.bones.size(); ++b) contents.bone_names.push_back("b" + std::to_string(b));
  return contents;
}

/// Two computations of the reference against each other, and the runtime with 240 steps a second against the finer.
void expect_well_posed(const AssetContents& contents) {
  const lab::OpenedAsset opened(contents);
  const lab::Rig rig = lab::rig_of(opened.asset());
  constexpr std::uint32_t kSampled[] = {60};
  lab::ReferenceSettings settings;
  settings.sample_times = lab::frame_times(kSampled, 2);
  settings.most_steps_per_second = 11520;
  settings.wanted_self_difference_pct = 0.1;
  for (const motion::MotionInfo& info : motion::all_motions()) {
    if (info.motion == motion::Motion::kTeleport) continue;
    const lab::KnownMotion known{info.motion, lab::solve_reference(rig, {}, *motion::path_of(info.motion), settings)};
    EXPECT_LE(known.reference.self_difference_pct(), 0.1) << info.name;
    EXPECT_LE(lab::measure_runtime(opened.asset(), rig, known, 60, 4).rms, 0.05) << info.name;
  }
}

Told<std::vector<DynamicsRecord>> conditioned(const AssetContents& contents, unsigned threads = 1) {
  return told([&](Findings& findings) {
    return condition_chains(contents, find_ill_posed(contents, threads), threads, findings);
  });
}

TEST(ConditionChains, LeavesADampedChainAlone) {
  const AssetContents contents = named(rig_of_chain({.bones = 3, .length = 0.3f, .damping_ratio = 1}));
  const auto result = conditioned(contents);
  EXPECT_TRUE(same(result.made, contents.dynamics));
  EXPECT_TRUE(result.notes.empty());
  EXPECT_TRUE(result.warnings.empty());
}

TEST(ConditionChains, DampsAnUndampedChainAndNamesIt) {
  AssetContents contents = named(rig_of_chain({.bones = 5}));
  const auto result = conditioned(contents);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("chain 'b1': "), std::string::npos) << result.notes[0];
  EXPECT_TRUE(result.warnings.empty());
  for (std::size_t b = 1; b < contents.bones.size(); ++b) {
    EXPECT_GT(result.made[b].damping, contents.dynamics[b].damping);
    EXPECT_EQ(result.made[b].stiffness, contents.dynamics[b].stiffness) << "the pose is the artist's";
    EXPECT_EQ(result.made[b].angle_limit, contents.dynamics[b].angle_limit);
  }
  contents.dynamics = result.made;
  expect_well_posed(contents);
  EXPECT_TRUE(conditioned(contents).notes.empty()) << "once is enough";
}

void expect_helped(int bones) {
  AssetContents contents = named(rig_of_chain({.bones = bones, .length = 0.8f, .damping_ratio = 1}));
  const auto result = conditioned(contents);
  EXPECT_EQ(result.notes.size(), 1u);
  EXPECT_TRUE(result.warnings.empty()) << result.warnings[0].message;
  contents.dynamics = result.made;
  expect_well_posed(contents);
}

/// Where `solver` has the bones after a turn of the head.
std::vector<Eigen::Vector3d> turned(const AssetContents& contents, const Solver& solver) {
  const lab::OpenedAsset opened(contents);
  lab::RuntimeSolver runtime(opened.asset(), {}, solver, 1);
  const auto path = motion::path_of(motion::Motion::kTurn);
  runtime.reset(path->pose(0));
  for (int frame = 1; frame <= 30; ++frame) EXPECT_TRUE(runtime.step(path->pose(frame / 60.0), 1 / 60.0));
  return {runtime.bone_ends().begin(), runtime.bone_ends().end()};
}

TEST(ConditionChains, AlgorithmOneStillReadsTheArtistsNumbers) {
  TestRig rig = rig_of_chain({.bones = 16, .length = 0.4f, .damping_ratio = 0.3f});
  for (DynamicsRecord& bone : rig.dynamics) bone.resistance = 0.2f;
  const AssetContents asked = named(rig);
  AssetContents given = asked;
  given.asked = asked_of(asked.dynamics);
  given.dynamics = conditioned(asked).made;
  ASSERT_FALSE(same(given.dynamics, asked.dynamics));
  EXPECT_EQ(turned(given, kThesisSolver), turned(asked, kThesisSolver));
  EXPECT_NE(turned(given, kCoifSolver), turned(asked, kCoifSolver));
}

TEST(ConditionChains, SixteenBonesBecomeWellPosed) { expect_helped(16); }

TEST(ConditionChains, SixtyFourBonesBecomeWellPosed) { expect_helped(64); }

TEST(ConditionChains, TouchesOnlyTheChainsThatNeedIt) {
  TestRig rig = rig_of_chain({.bones = 3, .length = 0.3f, .damping_ratio = 1});
  const TestRig soft = rig_of_chain({.bones = 5});
  std::uint32_t parent = 0;
  for (std::size_t b = 1; b < soft.bones.size(); ++b) {
    const BoneRecord& bone = soft.bones[b];
    parent = rig.add({.parent = parent,
                      .joint = {0, 0.02f, -0.12f},
                      .rest_direction = {0, -0.8f, -0.6f},
                      .length = bone.length,
                      .stiffness = soft.dynamics[b].stiffness,
                      .damping = 0,
                      .torsion = 20});
  }
  const AssetContents contents = named(rig);
  const auto result = conditioned(contents);
  ASSERT_EQ(result.notes.size(), 1u);
  EXPECT_NE(result.notes[0].find("chain 'b4': "), std::string::npos) << result.notes[0];
  for (std::size_t b = 1; b < 4; ++b) EXPECT_EQ(result.made[b].damping, contents.dynamics[b].damping);
  for (std::size_t b = 4; b < 9; ++b) EXPECT_GT(result.made[b].damping, 0);
  for (const unsigned threads : {2u, 5u}) {
    const auto again = conditioned(contents, threads);
    EXPECT_TRUE(same(again.made, result.made)) << threads << " threads";
    EXPECT_EQ(again.notes, result.notes);
  }
}

TEST(ConditionChains, WarnsWhereNothingHelps) {
  // Without weight and pull there is no stiffness whose root damping could be a share of.
  TestRig rig = rig_of_chain({.bones = 5, .length = 0.8f, .stiffness = 0});
  for (DynamicsRecord& record : rig.dynamics) record.gravity_scale = record.damping = record.torsion = 0;
  const auto result = conditioned(named(rig));
  EXPECT_TRUE(result.notes.empty());
  ASSERT_EQ(result.warnings.size(), 1u);
  EXPECT_NE(result.warnings[0].message.find("chain 'b1': "), std::string::npos) << result.warnings[0].message;
  EXPECT_NE(result.warnings[0].message.find("frame rate"), std::string::npos) << result.warnings[0].message;
}

TEST(ChainGrowth, RisesWithTheBonesAndIsBoundedByFrictionAndTheHead) {
  const auto growth = [](int bones, float friction, float parent_share) {
    AssetContents contents = rig_of_chain({.bones = bones, .length = 0.6f, .stiffness = 400}).contents();
    for (DynamicsRecord& record : contents.dynamics) {
      record.damping = 40;
      record.friction = friction;
      record.parent_share = parent_share;
    }
    return chain_growth(contents, 0);
  };
  EXPECT_GT(growth(4, 1, 1), 2);
  EXPECT_GT(growth(16, 1, 1), 100 * growth(4, 1, 1));
  EXPECT_LT(growth(16, 1, 0.5f), growth(16, 1, 1));
  EXPECT_NEAR(growth(16, 60, 0), 1, 1e-6);
}

TEST(ChainGrowth, IsThatOfTheWorstBranchWhicheverComesLast) {
  TestRig rig;
  const std::uint32_t stem = rig.add({.length = 0.1f, .stiffness = 400, .damping = 40});
  const TestBone calm{
      .parent = stem, .length = 0.1f, .friction = 60, .stiffness = 400, .damping = 40, .parent_share = 0};
  const TestBone lively{.parent = stem, .length = 0.1f, .friction = 1, .stiffness = 400, .damping = 1};
  TestRig other = rig;
  rig.add(calm), rig.add(lively);
  other.add(lively), other.add(calm);
  EXPECT_EQ(chain_growth(rig.contents(), 0), chain_growth(other.contents(), 0));
  EXPECT_GT(chain_growth(rig.contents(), 0), 2);
}

TEST(GroupChains, TheSoftestAndTheLongestTellOfAllWithAsManyBones) {
  AssetContents contents = nine_bone_rig().contents();
  EXPECT_EQ(group_chains(contents).size(), 1u);
  EXPECT_EQ(group_chains(contents)[0].chains.size(), 3u);
  contents.dynamics[4].stiffness = 1;  // chain 1
  contents.bones[9].length = 0.2f;     // chain 2; a longer bone is a softer one, but not as soft
  EXPECT_EQ(group_chains(contents)[0].telling, (std::vector<std::uint32_t>{1, 2}));
  contents.dynamics[9].stiffness = contents.dynamics[8].stiffness = contents.dynamics[7].stiffness = 0;
  EXPECT_EQ(group_chains(contents)[0].telling, (std::vector<std::uint32_t>{2})) << "one is both";
}

TEST(ChainsAlone, EachMovesAsAmongAll) {
  const AssetContents contents = nine_bone_rig().contents();
  const lab::OpenedAsset all(contents);
  for (std::uint32_t chain = 0; chain < 3; ++chain) {
    const lab::OpenedAsset one(chains_alone(contents, std::array{chain}));
    ASSERT_TRUE(one.asset().is_open());
    ASSERT_EQ(one.asset().skeleton().simulated_count, 3u);
    lab::RuntimeSolver among(all.asset(), {}, kCoifSolver, 2), alone(one.asset(), {}, kCoifSolver, 2);
    const auto path = motion::path_of(motion::Motion::kTumble);
    among.reset(path->pose(0));
    alone.reset(path->pose(0));
    for (int frame = 1; frame <= 120; ++frame) {
      ASSERT_TRUE(among.step(path->pose(frame / 60.0), 1 / 60.0));
      ASSERT_TRUE(alone.step(path->pose(frame / 60.0), 1 / 60.0));
      for (std::size_t b = 0; b < 3; ++b) {
        ASSERT_EQ(alone.bone_ends()[b], among.bone_ends()[3 * chain + b]) << "chain " << chain << ", frame " << frame;
      }
    }
  }
}

}  // namespace coif::cook::condition_chains_test
