// Directions that are bounded by limits about axes of their own: what each kind promises, whatever the motion.

#include "sim/limited_strands.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace coif::limits_test {

TEST(Limits, HoldInEveryMotionAtEveryFrameRate) {
  for_all([](ChainModel model, LimitKind kind) {
    for (const float first : {0.0f, 0.02f, 0.4f, 1.4f, 2.6f}) {
      const TestRig rig = strands(model, {kind, first, 0.5f * std::min(first, 1.5f)});
      for (const double fps : {15.0, 30.0, 60.0, 144.0, 240.0}) {
        TestHair test(rig);
        Violence violence(17);
        double worst = 0;
        for (int frame = 0; frame < 60; ++frame) {
          // Half of it as no head moves, half as one runs and looks about.
          const HeadPose pose = frame < 30 ? violence.next() : wander(frame / fps);
          ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
          ASSERT_EQ(test.hair.step(at_rate(fps)), Status::kOk);
          worst = std::max(worst, worst_violation(rig, test));
          EXPECT_LT(worst_stretch(rig, test.ends()), 1e-5f);
        }
        EXPECT_LT(worst, kAllowed) << "angle " << first << " at " << fps;
      }
    }
  });
}

TEST(Limits, HoldWithSubStepsAndAngleLimitsAndSharedPull) {
  for_all([](ChainModel model, LimitKind kind) {
    TestRig rig = strands(model, {kind});
    for (DynamicsRecord& bone : rig.dynamics) bone.angle_limit = 0.3f, bone.parent_share = 0.5f;
    TestHair test(rig);
    Violence violence(3);
    StepSettings settings = at_rate(30);
    settings.substeps = 4;
    for (int frame = 0; frame < 60; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, violence.next()), Status::kOk);
      ASSERT_EQ(test.hair.step(settings), Status::kOk);
      EXPECT_LT(worst_violation(rig, test), kAllowed);
    }
  });
}

TEST(Limits, AngleOfZeroLocksTheBoneToItsMiddle) {
  for_all([](ChainModel model, LimitKind kind) {
    const TestRig rig = strands(model, {kind, 0, 0});
    TestHair test(rig);
    const auto rest = rig.rest_ends();
    for (int frame = 0; frame < 40; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, wander(frame / 60.0)), Status::kOk);
      ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      EXPECT_LT(largest_distance(test.ends(), rest), 1e-5f);
    }
  });
}

TEST(Limits, HalfATurnIsNoneToTheBit) {
  for (const ChainModel model : kModels) {
    TestRig free = strands(model, {LimitKind::kCone, kNoAngleLimit});
    TestRig wide = free;
    free.limits.clear();
    EXPECT_TRUE(same_bits(violent_ends(free), violent_ends(wide))) << named(model, LimitKind::kCone);
    for (std::uint32_t i = 1; i < wide.bones.size(); ++i) {
      wide.limit(i, LimitKind::kSpherical, kNoAngleLimit, kMostYaw);
    }
    EXPECT_TRUE(same_bits(violent_ends(free), violent_ends(wide))) << named(model, LimitKind::kSpherical);
  }
}

TEST(Limits, OfOneChainChangeNoBitOfItsNeighbour) {
  for (const ChainModel model : kModels) {
    TestRig rig = strands(model, {LimitKind::kSpherical});
    for (DynamicsRecord& bone : rig.dynamics) bone.torsion = kShortestArc;  // one row
    rig.add_sphere({0, 0, 0}, 0.095f);
    TestRig free = rig;
    free.limits.clear();
    for (std::uint32_t i = 1; i <= 4; ++i) rig.limit(i, LimitKind::kUnlimited, 0);
    const auto beside = violent_ends(rig), alone = violent_ends(free);
    ASSERT_EQ(beside.size(), alone.size());
    bool differs = false;
    for (std::size_t i = 0; i < beside.size(); ++i) {
      const bool is_same = std::memcmp(&beside[i], &alone[i], sizeof(Vec3)) == 0;
      if (i % 8 < 4) {
        EXPECT_TRUE(is_same) << named(model, LimitKind::kSpherical) << " " << i;
      }
      differs = differs || !is_same;
    }
    EXPECT_TRUE(differs) << "the other chain is limited";
  }
}

TEST(Limits, AreTheSameBitsOnEveryInstructionSetInEveryOrderOfLanes) {
  for_all([](ChainModel model, LimitKind kind) {
    TestRig rig = strands(model, {kind});
    rig.add_sphere({0, 0, 0}, 0.12f);  // roots inside: contacts against limits
    for (const Solver* const solver : {&kCoifSolver, &kCharacterSolver}) {
      std::vector<Vec3> expected;
      for (const InstructionSet set : runnable_sets()) {
        for (const std::uint32_t instances : {1u, 37u}) {
          HairDesc desc{.instances = instances, .solver = solver};
          desc.instruction_set = set;
          const auto ends = violent_ends(rig, desc);
          if (expected.empty()) expected = ends;
          EXPECT_TRUE(same_bits(expected, ends)) << int(set) << ", " << instances << " heads";
        }
      }
    }
  });
}

TEST(Limits, HingeMovesInItsPlaneAlone) {
  for (const ChainModel model : kModels) {
    TestRig rig;
    rig.model = model;
    TestBone bone{.rest_direction = {0, -1, 0}, .length = 0.1f};
    bone.stiffness = 20;
    bone.damping = 1;
    bone.torsion = kShortestArc;
    rig.add(bone);
    // The limit's y down, its x along the world's x: what pushes sideways does nothing, what pushes backwards swings
    // it.
    rig.limit(1, LimitKind::kHinge, 1.2f, 0, turned_about({1, 0, 0}, kPi));
    TestHair test(rig);
    double farthest = 0;
    for (int frame = 0; frame < 120; ++frame) {
      HeadPose pose;
      pose.position[0] = 0.2 * std::sin(frame * 0.2);
      pose.position[2] = 0.2 * std::sin(frame * 0.13);
      ASSERT_EQ(test.hair.set_head(0, pose), Status::kOk);
      ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      EXPECT_LT(std::fabs(test.ends()[0].x), 1e-6f);
      farthest = std::max(farthest, double(std::fabs(test.ends()[0].z)));
    }
    EXPECT_GT(farthest, 0.02);
  }
}

/// One bone of 10 cm without stiffness that hangs from the head's origin, told how fast it goes by a head that stopped.
TEST(Limits, TakeTheSpeedAgainstTheStopAndLeaveTheRest) {
  for (const ChainModel model : kModels) {
    TestRig rig;
    rig.model = model;
    TestBone bone{.rest_direction = {0, -1, 0}, .length = 0.1f};
    bone.stiffness = bone.damping = 0;
    bone.torsion = kShortestArc;
    rig.add(bone);
    rig.limit(1, LimitKind::kCone, 0.5f, 0, turned_about({1, 0, 0}, kPi));
    TestHair test(rig);
    StepSettings settings = at_rate(120);
    settings.environment.gravity = {0, 0, -30};  // sideways: it lies against the stop
    for (int frame = 0; frame < 240; ++frame) ASSERT_EQ(test.hair.step(settings), Status::kOk);
    const Vec3 still = test.ends()[0];
    EXPECT_NEAR(std::acos(-still.y / 0.1f), 0.5, 1e-4);
    settings.environment.gravity = {20, 0, -30};  // along the stop it is free
    Vec3 last = still;
    double longest = 0, farthest = 0;
    for (int frame = 0; frame < 30; ++frame) {
      ASSERT_EQ(test.hair.step(settings), Status::kOk);
      longest = std::max(longest, double(distance(last, test.ends()[0])));
      last = test.ends()[0];
      farthest = std::max(farthest, double(last.x));
      EXPECT_LT(worst_violation(rig, test), kAllowed);
    }
    EXPECT_GT(farthest, 0.04) << "twice as far as it would rest, as a pendulum does";
    settings.environment.gravity = {0, 0, 0};
    const Vec3 before = test.ends()[0];
    ASSERT_EQ(test.hair.step(settings), Status::kOk);
    // No bounce: it does not leave the stop faster than it went along it.
    EXPECT_LE(distance(before, test.ends()[0]), 1.5 * longest);
    EXPECT_GT(std::acos(-test.ends()[0].y / 0.1f), 0.49);
  }
}

TEST(Limits, AgainstItsStopABoneMovesAsItsFrameDoes) {
  for_all([](ChainModel model, LimitKind kind) {
    const TestRig rig = strands(model, {kind, 0.1f, 0.1f});
    TestHair test(rig);
    StepSettings settings = at_rate(60);
    settings.environment.gravity = {0, 0, 50};  // presses all against their stops
    std::vector<Vec3> ends;
    for (int frame = 0; frame < 300; ++frame) {
      ASSERT_EQ(test.hair.step(settings), Status::kOk);
    }
    ends = test.ends();
    for (int frame = 0; frame < 30; ++frame) ASSERT_EQ(test.hair.step(settings), Status::kOk);
    EXPECT_LT(largest_distance(ends, test.ends()), 1e-4f) << "at rest there";
  });
}

/// DynamicsRecord::angle_limit. Pressed against it, the bone stands still, and what hangs on it hangs as from any bone
/// that stands.
TEST(Limits, OfAnAngleHoweverNarrowHoldTheBoneStill) {
  for (const ChainModel model : kModels) {
    const auto hung = [model](float angle, int frames) {  // where the child's end is, seen from its start
      TestRig rig;
      rig.model = model;
      const std::uint32_t held = rig.add({.length = 0.1f, .stiffness = 1, .damping = 0, .angle_limit = angle});
      rig.add({.parent = held, .length = 0.1f, .stiffness = 100, .damping = 5, .torsion = kShortestArc});
      TestHair test(rig);
      StepSettings settings = at_rate(60);
      settings.environment.gravity = {30, 0, 0};
      for (int frame = 0; frame < frames; ++frame) EXPECT_EQ(test.hair.step(settings), Status::kOk);
      const auto ends = test.ends();
      EXPECT_LT(std::fabs(ends[0].x), 0.1f * angle + 1e-5f);
      return Vec3{ends[1].x - ends[0].x, ends[1].y - ends[0].y, ends[1].z - ends[0].z};
    };
    for (const int frames : {20, 60}) {
      const Vec3 expected = hung(0.005f, frames);
      for (const float angle : {0.0f, 1e-4f, 9e-4f, 1.03e-3f}) {
        EXPECT_LT(distance(hung(angle, frames), expected), 5e-4f) << angle << " in " << frames;
      }
    }
  }
}

/// Locked by a limit of any kind, or held rigid, a bone stands in its parent's frame; what hangs on it cannot tell
/// which.
TEST(Limits, OfAngleZeroAreTheSameLockWhateverTheirKind) {
  for (const ChainModel model : kModels) {
    const auto ends_with = [model](LimitKind kind) {
      TestRig rig;
      rig.model = model;
      const std::uint32_t held = rig.add({.length = 0.1f, .stiffness = 1, .damping = 0, .torsion = kShortestArc});
      rig.add({.parent = held, .length = 0.1f, .stiffness = 100, .damping = 5, .torsion = kShortestArc});
      rig.limit(held, kind, 0, 0, turned_about({1, 0, 0}, kPi));
      TestHair test(rig);
      StepSettings settings = at_rate(60);
      std::vector<Vec3> all;
      for (int frame = 0; frame < 90; ++frame) {  // pulled to one side after the other
        settings.environment.gravity = {30 * std::cos(0.1f * float(frame)), 0, 30 * std::sin(0.1f * float(frame))};
        EXPECT_EQ(test.hair.step(settings), Status::kOk);
        EXPECT_LT(distance(test.ends()[0], {0, -0.1f, 0}), 1e-6f);
        all.push_back(test.ends()[1]);
      }
      return all;
    };
    const auto cone = ends_with(LimitKind::kCone);
    for (const LimitKind kind : kKinds) EXPECT_LT(largest_distance(ends_with(kind), cone), 1e-4f) << named(model, kind);
  }
}

TEST(Limits, TheNearestAllowedDirectionIsContinuousAndStaysWhereItIs) {
  // A stiff bone is at its default direction: led around in small steps by the lean of a pull that is wide of the
  // limit.
  for (const LimitKind kind : kKinds) {
    Vec3 last{};
    bool has_last = false;
    for (int k = 0; k <= 720; ++k) {
      const double about = k * kPi / 360, aside = 1.0;
      TestRig rig;
      TestBone bone{.length = 1, .stiffness = 4e6f, .damping = 1e4f, .torsion = kShortestArc};
      bone.rest_direction = {float(std::sin(aside) * std::cos(about)), float(-std::cos(aside)),
                             float(std::sin(aside) * std::sin(about))};
      rig.add(bone);
      rig.limit(1, kind, 0.6f, kind == LimitKind::kSpherical ? 0.3f : 0.0f, turned_about({1, 0, 0}, kPi));
      TestHair test(rig);
      for (int frame = 0; frame < 2; ++frame) ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      EXPECT_LT(worst_violation(rig, test), kAllowed);
      const Vec3 end = test.ends()[0];
      ASSERT_EQ(test.hair.step(at_rate(60)), Status::kOk);
      EXPECT_LT(distance(end, test.ends()[0]), 2e-5f);
      if (has_last) {
        EXPECT_LT(distance(last, end), 0.02f) << int(kind) << " at " << k;
      }
      last = end;
      has_last = true;
    }
  }
}

}  // namespace coif::limits_test
