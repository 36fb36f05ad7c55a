// Directions that are bounded by limits about axes of their own: what each kind promises, whatever the motion.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

namespace coif::limits_test {

constexpr double kAllowed = 1e-4;  // radians
constexpr double kPi = 3.14159265358979;
constexpr ChainModel kModels[] = {ChainModel::kCascade, ChainModel::kPassive};
constexpr LimitKind kKinds[] = {LimitKind::kCone, LimitKind::kHinge, LimitKind::kSpherical};

struct Point {
  double x, y, z;
};

/// By the conjugate.
Point rotated_back(const float (&q)[4], const Point& v) {
  const double x = -double(q[0]), y = -double(q[1]), z = -double(q[2]), w = q[3];
  const Point t{2 * (y * v.z - z * v.y), 2 * (z * v.x - x * v.z), 2 * (x * v.y - y * v.x)};
  return {v.x + w * t.x + y * t.z - z * t.y, v.y + w * t.y + z * t.x - x * t.z, v.z + w * t.z + x * t.y - y * t.x};
}

/// Of the parent's frame.
Point in_frame(const Mat34& m, const Point& v) {
  return {double(m.m[0][0]) * v.x + double(m.m[1][0]) * v.y + double(m.m[2][0]) * v.z,
          double(m.m[0][1]) * v.x + double(m.m[1][1]) * v.y + double(m.m[2][1]) * v.z,
          double(m.m[0][2]) * v.x + double(m.m[1][2]) * v.y + double(m.m[2][2]) * v.z};
}

/// How far, at least, a unit direction in the limit's axes is from what the record allows, radians. By its definition, not by the
/// solver's way.
double violation(const LimitRecord& limit, const Point& d) {
  const double angle = std::atan2(std::hypot(d.x, d.z), d.y);
  switch (limit.kind) {
    case LimitKind::kUnlimited: return 0;
    case LimitKind::kCone: return std::max(0.0, angle - double(limit.angles[0]));
    case LimitKind::kHinge: return std::max(std::asin(std::min(1.0, std::fabs(d.x))), angle - double(limit.angles[0]));
    case LimitKind::kSpherical: break;
  }
  const double yaw = std::asin(std::clamp(d.x, -1.0, 1.0)), pitch = std::atan2(d.z, d.y);
  const double over = std::fabs(pitch) - double(limit.angles[0]);
  return std::max(std::fabs(yaw) - double(limit.angles[1]), over * std::cos(yaw));
}

/// The worst of the rig's bones under head `instance`. `posed`: frames are turned by these first, one for each bone.
double worst_violation(const TestRig& rig, const TestHair& test, std::uint32_t instance = 0,
                       std::span<const Quat> posed = {}) {
  const auto palette = test.hair.palette(instance);
  double worst = 0;
  for (std::size_t i = 1; i < rig.limits.size(); ++i) {
    const float* const rest = rig.bones[i].rest_direction;
    const Vec3 now = transformed(palette[i], {rest[0], rest[1], rest[2]}), zero = transformed(palette[i], {});
    const Point in_head{double(now.x) - double(zero.x), double(now.y) - double(zero.y), double(now.z) - double(zero.z)};
    Point seen = in_frame(palette[rig.bones[i].parent], in_head);
    if (!posed.empty()) seen = rotated_back({posed[i].x, posed[i].y, posed[i].z, posed[i].w}, seen);
    const double v = violation(rig.limits[i], rotated_back(rig.limits[i].rotation, seen));
    worst = v > worst || std::isnan(v) ? v : worst;
  }
  return worst;
}

/// From the limit's y to the direction, by the shortest way, and then about that.
Quat axes_towards(const Vec3& direction, double about) {
  const double size = std::hypot(direction.x, direction.z);
  const double angle = std::atan2(size, double(direction.y));
  const Vec3 axis = size > 1e-9 ? Vec3{float(direction.z / size), 0, float(-direction.x / size)} : Vec3{1, 0, 0};
  return product(turned_about(axis, angle), turned_about({0, 1, 0}, about));
}

struct Limited {
  LimitKind kind = LimitKind::kCone;
  float first = 0.4f, second = 0.2f;
};

/// Two strands of four soft bones, the limits' middle the rest direction, their axes turned about that, bone by bone.
TestRig strands(ChainModel model, const Limited& limited) {
  TestRig rig;
  rig.model = model;
  for (const float side : {-0.04f, 0.05f}) {
    TestBone bone{.joint = {side, 0.05f, -0.1f}, .rest_direction = {0, -0.8f, -0.6f}, .length = 0.06f};
    bone.stiffness = 40;
    bone.damping = 3;
    bone.friction = 0.5f;
    bone.torsion = model == ChainModel::kCascade && side < 0 ? 20 : kShortestArc;
    rig.add_strand(4, bone);
  }
  for (std::uint32_t i = 1; i < rig.bones.size(); ++i) {
    const float second = limited.kind == LimitKind::kSpherical ? limited.second : 0.0f;
    rig.limit(i, limited.kind, limited.first, second, axes_towards({0, -0.8f, -0.6f}, 0.7 * i));
  }
  return rig;
}

StepSettings at_rate(double fps) {
  StepSettings settings;
  settings.dt = float(1 / fps);
  return settings;
}

std::string named(ChainModel model, LimitKind kind) {
  return std::string(model == ChainModel::kPassive ? "passive" : "cascade") + ", kind " + std::to_string(int(kind));
}

/// Calls visit(model, kind) for each pair.
void for_all(const std::function<void(ChainModel, LimitKind)>& visit) {
  for (const ChainModel model : kModels) {
    for (const LimitKind kind : kKinds) {
      SCOPED_TRACE(named(model, kind));
      visit(model, kind);
    }
  }
}

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

/// The ends of every frame of a violent motion.
std::vector<Vec3> violent_ends(const TestRig& rig, const HairDesc& desc = {}) {
  TestHair test(rig, desc);
  Violence violence(5);
  std::vector<Vec3> all;
  for (int frame = 0; frame < 40; ++frame) {
    const HeadPose pose = frame % 2 == 0 ? violence.next() : wander(frame / 60.0);
    for (std::uint32_t i = 0; i < desc.instances; ++i) {
      if (test.hair.set_head(i, pose) != Status::kOk) return {};
    }
    if (test.hair.step(at_rate(60)) != Status::kOk) return {};
    const auto ends = test.ends(desc.instances - 1);
    all.insert(all.end(), ends.begin(), ends.end());
  }
  return all;
}

bool same_bits(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  return a.size() == b.size() && !a.empty() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Vec3)) == 0;
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
      if (i % 8 < 4) EXPECT_TRUE(is_same) << named(model, LimitKind::kSpherical) << " " << i;
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
    // The limit's y down, its x along the world's x: what pushes sideways does nothing, what pushes backwards swings it.
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

TEST(Limits, TheNearestAllowedDirectionIsContinuousAndStaysWhereItIs) {
  // A stiff bone is at its default direction: led around in small steps by the lean of a pull that is wide of the limit.
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
      if (has_last) EXPECT_LT(distance(last, end), 0.02f) << int(kind) << " at " << k;
      last = end;
      has_last = true;
    }
  }
}

TEST(Limits, HoldWhereCollidersAskForMore) {
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

TEST(Limits, AndContactsBothHoldWhereBothCan) {
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

TEST(Limits, OfBonesThatLevelsOfDetailHoldAreKeptByTheRest) {
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

TEST(Limits, TurnWithThePoseThatHairFollows) {
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

TEST(Limits, AreReachedInCrowdsOfBothOrdersOfLanes) {
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

TEST(Limits, TakeMemoryOnlyWhereTheAssetHasThem) {
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

TEST(Limits, DoNotBindTheThesisSolver) {
  TestRig rig = strands(ChainModel::kCascade, {LimitKind::kCone, 0.05f});
  TestRig free = rig;
  free.limits.clear();
  EXPECT_TRUE(same_bits(violent_ends(rig, {.solver = &kThesisSolver}), violent_ends(free, {.solver = &kThesisSolver})));
}

}  // namespace coif::limits_test
