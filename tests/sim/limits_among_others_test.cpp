// Limits beside what else there is: colliders, levels of detail, poses, crowds, and the solver that knows none.

#include "sim/limited_strands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace coif::limits_test {

TEST(LimitsAmongOthers, HoldWhereCollidersAskForMore) {
  for_all([](ChainModel model, LimitKind kind) {
    TestRig rig = strands(model, {kind, 0.25f, 0.2f});
    rig.add_sphere({0, 0, 0}, 0.13f);  // the first bones start in it
    rig.add_capsule({-0.2f, -0.1f, -0.2f}, {0.2f, -0.1f, -0.2f}, 0.05f);
    for (const Solver* const solver : {&kCoifSolver, &kCharacterSolver}) {
      HairDesc desc{.solver = solver};
      if (solver == &kCharacterSolver) desc.moving_colliders = 1;
      TestHair test(rig, desc);
      Violence violence(9);
      for (int frame = 0; frame < 90; ++frame) {
        const HeadPose pose = frame % 3 == 0 ? violence.next() : wander(frame / 60.0);
        ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
        if (solver == &kCharacterSolver) {
          MovingCollider hand{.shape = ColliderShape::kSphere, .center = {0.1 * std::sin(frame * 0.3), -0.05, -0.15}};
          hand.radius = 0.06f;
          ASSERT_EQ(test.hair.set_colliders(0, std::span(&hand, 1)), Status::kOk);
        }
        ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
        EXPECT_LT(worst_violation(rig, test), kAllowed) << frame;
        EXPECT_LT(worst_stretch(rig, test.ends()), 1e-5f);
      }
    }
  });
}

TEST(LimitsAmongOthers, AndContactsBothHoldWhereBothCan) {
  // A bone hangs beside a ball that pushes it aside; the hinge lets it go around on one way only, and there it goes.
  for (const ChainModel model : kModels) {
    for (const LimitKind kind : kKinds) {
      SCOPED_TRACE(named(model, kind));
      TestRig rig;
      rig.model = model;
      TestBone bone{
          .rest_direction = {0, -1, 0}, .length = 0.2f, .stiffness = 30, .damping = 5, .torsion = kShortestArc};
      rig.add(bone);
      rig.add_sphere({0.01f, -0.15f, 0.03f}, 0.05f);
      rig.limit(1, kind, 1.2f, kind == LimitKind::kSpherical ? 0.1f : 0.0f, turned_about({1, 0, 0}, kPi));
      TestHair test(rig);
      for (int frame = 0; frame < 120; ++frame) {
        ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
        EXPECT_LT(worst_violation(rig, test), kAllowed);
        if (frame < 1) continue;
        const Vec3 end = test.ends()[0];
        double nearest = 1;
        for (int k = 0; k <= 200; ++k) {
          const float s = float(k) / 200;
          nearest = std::min(nearest, double(distance({end.x * s, end.y * s, end.z * s}, {0.01f, -0.15f, 0.03f})));
        }
        EXPECT_GT(nearest, 0.05 - 1e-4 * 0.05) << frame;
      }
    }
  }
}

TEST(LimitsAmongOthers, OfBonesThatLevelsOfDetailHoldAreKeptByTheRest) {
  for_all([](ChainModel model, LimitKind kind) {
    TestRig rig = strands(model, {kind});
    rig.levels = {0, 2, 2, 1, 1, 2, 1, 1, 1};
    TestHair test(rig);
    Violence violence(11);
    for (int frame = 0; frame < 60; ++frame) {
      ASSERT_EQ(test.hair.set_detail(0, {.level = frame % 20 < 10 ? 1u : 0u}), Status::kOk);
      ASSERT_EQ(test.hair.set_head(0, violence.next()), Status::kOk);
      ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      EXPECT_LT(worst_violation(rig, test), kAllowed);
    }
  });
}

TEST(LimitsAmongOthers, TurnWithThePoseThatHairFollows) {
  for_all([](ChainModel model, LimitKind kind) {
    const TestRig rig = strands(model, {kind, 0.2f, 0.15f});
    for (const float weight : {1.0f, 0.5f, 0.0f}) {
      TestHair test(rig, HairDesc{.solver = &kCharacterSolver, .follows_poses = true});
      const std::vector<float> weights(2, weight);
      std::vector<Quat> pose(rig.bones.size());
      Violence violence(13);
      for (int frame = 0; frame < 60; ++frame) {
        for (std::size_t i = 1; i < pose.size(); ++i) {
          pose[i] = turned_about({0, 0.6f, 0.8f}, 0.9 * std::sin(0.1 * frame + double(i)));
        }
        ASSERT_EQ(test.hair.set_pose(0, pose, weights), Status::kOk);
        ASSERT_EQ(test.hair.set_head(0, violence.next()), Status::kOk);
        ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
        EXPECT_LT(worst_violation(rig, test, 0, pose), kAllowed) << "weight " << weight << ", frame " << frame;
      }
    }
  });
}

TEST(LimitsAmongOthers, AreReachedInCrowdsOfBothOrdersOfLanes) {
  for_all([](ChainModel model, LimitKind kind) {
    const TestRig rig = strands(model, {kind});
    for (const std::uint32_t instances : {1u, 2u, 40u}) {
      TestHair test(rig, instances);
      Violence violence(19);
      for (int frame = 0; frame < 20; ++frame) {
        for (std::uint32_t i = 0; i < instances; ++i) ASSERT_EQ(test.hair.set_head(i, violence.next()), Status::kOk);
        ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
        for (std::uint32_t i = 0; i < instances; ++i) EXPECT_LT(worst_violation(rig, test, i), kAllowed);
      }
    }
  });
}

TEST(LimitsAmongOthers, TakeMemoryOnlyWhereTheAssetHasThem) {
  TestRig rig = strands(ChainModel::kCascade, {});
  const HairDesc desc;
  const TestHair limited(rig);
  rig.limits.clear();
  const TestHair free(rig);
  const auto with = Hair::memory_need(limited.asset, desc).bytes, without = Hair::memory_need(free.asset, desc).bytes;
  // 14 numbers of sixteen lanes for each bone of a row.
  EXPECT_GT(with, without);
  EXPECT_LE(with, without + rig.simulated_count() * 14 * 64);
}

TEST(LimitsAmongOthers, DoNotBindTheThesisSolver) {
  TestRig rig = strands(ChainModel::kCascade, {LimitKind::kCone, 0.05f});
  TestRig free = rig;
  free.limits.clear();
  EXPECT_TRUE(same_bits(violent_ends(rig, {.solver = &kThesisSolver}), violent_ends(free, {.solver = &kThesisSolver})));
}

TEST(LimitsAmongOthers, ChangeNothingOfChainsBesideThemThatHaveNone) {
  // Bones in a gap between colliders, where a bone with a limit gets more rounds to agree with all of them.
  TestRig rig;
  for (int i = 0; i < 4; ++i) {
    rig.add_strand(2, {.joint = {0.02f * float(i), 0, -0.09f},
                       .rest_direction = {0, -0.8f, -0.6f},
                       .length = 0.15f,
                       .hit_radius = 0.02f,
                       .stiffness = 60 + 20 * float(i),
                       .damping = 5,
                       .torsion = kShortestArc});
  }
  for (int i = 0; i < 6; ++i) {
    rig.add_sphere({0.02f * float(i) - 0.03f, -0.08f - 0.02f * float(i), -0.2f + 0.03f * float(i % 3)}, 0.06f);
  }
  for (const std::uint32_t bone : {1u, 2u, 5u}) rig.limit(bone, LimitKind::kCone, 0.1f);
  TestHair alone(rig, 1), among(rig, 20);  // rows of all chains of a head, and of one chain of many heads
  for (int frame = 0; frame < 60; ++frame) {
    for (TestHair* const test : {&alone, &among}) {
      ASSERT_EQ(test->hair.set_head(0, wander(frame / 20.0)), Status::kOk);
      ASSERT_EQ(test->hair.step(at_rate(60)), Status::kOk);
    }
    const auto one = alone.hair.palette(0), other = among.hair.palette(0);
    ASSERT_EQ(std::memcmp(one.data(), other.data(), one.size_bytes()), 0) << frame;
  }
}

}  // namespace coif::limits_test
