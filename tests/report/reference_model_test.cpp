#include "report/reference/reference_model.h"

#include "report/reference_trial.h"
#include "report/rig_sample.h"
#include "report/solver_trial.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

TEST(ReferenceModel, TwistGoesBackAtTheRateOfTorsion) {
  RigBone bone;
  bone.torsion = 7;
  const BoneMotion parent = motion_of_joint(Vector3d::Zero(), {});
  for (const double twist : {-2.0, -0.3, 0.0, 0.5, 1.5}) {
    const Quaterniond frame(AngleAxisd(twist, bone.rest_direction));
    const Vector3d spin = angular_velocity_of(bone, parent, {frame, Vector3d::Zero()});
    EXPECT_NEAR(spin.dot(bone.rest_direction), -7 * std::sin(twist), 1e-12) << twist;
  }
}

TEST(ReferenceModel, TwistOfAFoldedBoneIsLeftAlone) {
  RigBone bone;
  bone.torsion = 7;
  const BoneMotion parent = motion_of_joint(Vector3d::Zero(), {});
  const Quaterniond folded(AngleAxisd(3.14159265358979, Vector3d::UnitX()));
  const Quaterniond twisted = folded * Quaterniond(AngleAxisd(1, bone.rest_direction));
  EXPECT_LT(angular_velocity_of(bone, parent, {twisted, Vector3d::Zero()}).norm(), 1e-9);
}

TEST(ReferenceModel, BoneTurnsAboutItselfAsItsParentDoes) {
  const RigBone bone;
  HeadState head;
  head.angular_velocity = Vector3d(0.3, 5, -0.2);
  const BoneMotion parent = motion_of_joint(Vector3d::Zero(), head);
  const Vector3d turning(1, 0, 2);
  const Vector3d spin = angular_velocity_of(bone, parent, {Quaterniond::Identity(), turning});
  EXPECT_NEAR(spin.dot(bone.rest_direction), head.angular_velocity.dot(bone.rest_direction), 1e-12);
  EXPECT_LT((spin.cross(bone.rest_direction) - turning).norm(), 1e-12);
}

TEST(ReferenceModel, DefaultDirectionIsSharedBetweenParentAndHead) {
  RigBone bone;
  bone.rest_direction = Vector3d::UnitX();
  BoneMotion parent = motion_of_joint(Vector3d::Zero(), {});
  parent.frame = AngleAxisd(std::acos(-1.0) / 2, Vector3d::UnitY());  // its X is the world's -Z
  parent.angular_velocity = Vector3d(0, 2, 0);
  const auto direction = [&](double share) {
    bone.parent_share = share;
    return target_of(bone, parent, {}).direction;
  };
  EXPECT_LT((direction(1) + Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((direction(0) - Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((direction(0.25) - Vector3d(0.75, 0, -0.25)).norm(), 1e-12);
  EXPECT_LT((target_of(bone, parent, {}).turning - 0.25 * Vector3d(-2, 0, 0)).norm(), 1e-12);
}

TEST(ReferenceModel, ShortestArcTurnsOneToTheOther) {
  const Vector3d from = Vector3d(1, 2, -1).normalized();
  for (const Vector3d& to : {Vector3d(0.2, -1, 3), Vector3d(1, 2, -1), Vector3d(-1, -2, 1)}) {
    const Quaterniond arc = shortest_arc(from, to.normalized());
    EXPECT_LT((arc * from - to.normalized()).norm(), 1e-7);
    EXPECT_NEAR(arc.norm(), 1, 1e-12);
  }
}

TEST(RigSample, HoldsWholeTreesThatMoveAsAmongAll) {
  Rig rig;
  for (int strand = 0; strand < 10; ++strand) {
    for (RigBone bone : strand_rig(3).bones) {
      if (bone.parent >= 0) bone.parent += 3 * strand;
      bone.length *= 1 + 0.1 * strand;
      rig.bones.push_back(bone);
    }
  }
  rig = with_tips(rig);
  const RigSample sample = sample_of(rig, 12);
  ASSERT_EQ(sample.rig.tips.size(), 4u);
  EXPECT_EQ(sample.bones.size(), 12u);
  const auto path = path_of(Motion::kRun);
  const ReferenceRun all = solve_at(rig, {}, *path, 1, 240), some = solve_at(sample.rig, {}, *path, 1, 240);
  for (std::size_t tip = 0; tip < sample.rig.tips.size(); ++tip) {
    const std::uint32_t whole_bone = sample.bones[sample.rig.tips[tip]];
    const auto whole = std::size_t(std::ranges::find(rig.tips, whole_bone) - rig.tips.begin());
    ASSERT_LT(whole, rig.tips.size());
    EXPECT_EQ(sample.rig.tip_length[tip], rig.tip_length[whole]);
    EXPECT_EQ(some.path_of_tip(tip).back(), all.path_of_tip(whole).back());
  }
}

TEST(RigSample, OfEnoughBonesIsTheRig) {
  const Rig rig = with_tips(forked_rig());
  EXPECT_EQ(sample_of(rig, 100).bones.size(), rig.bones.size());
  EXPECT_EQ(sample_of(rig, 1).bones.size(), rig.bones.size()) << "one tree at least";
}

}  // namespace
}  // namespace coif
