// Hair that follows an animator's pose: Hair::set_pose().

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace coif::pose_test {

constexpr float kFrame = 1.0f / 60;
constexpr ChainModel kModels[] = {ChainModel::kCascade, ChainModel::kPassive};

const char* name_of(ChainModel model) { return model == ChainModel::kPassive ? "passive" : "cascade"; }

/// Every chain bends its own way and twists; smooth, from the rest pose at 0.
std::vector<Quat> animation(const TestRig& rig, double seconds) {
  std::vector<Quat> rotations(rig.bones.size());
  for (std::size_t bone = 1; bone < rotations.size(); ++bone) {
    const double angle = 0.4 * std::sin(3 * seconds + 0.3 * double(bone)) - 0.4 * std::sin(0.3 * double(bone));
    rotations[bone] = product(turned_about({0.6f, 0, 0.8f}, angle), turned_about({0, 1, 0}, 0.5 * angle));
  }
  return rotations;
}

/// What the pose is as matrices, from rest: in double precision, by composition.
std::vector<Mat34> matrices_of(const TestRig& rig, const std::vector<Quat>& rotations) {
  std::vector<Mat34> all(rig.bones.size());
  std::vector<Quat> frames(rig.bones.size());
  std::vector<Vec3> tails(rig.bones.size());
  for (std::size_t i = 1; i < rig.bones.size(); ++i) {
    const BoneRecord& bone = rig.bones[i];
    const Vec3 joint{bone.joint[0], bone.joint[1], bone.joint[2]};
    frames[i] = bone.parent == 0 ? rotations[i] : product(frames[bone.parent], rotations[i]);
    const Vec3 start = bone.parent == 0 ? joint : tails[bone.parent];
    const Vec3 along = rotated(frames[i], {bone.rest_direction[0], bone.rest_direction[1], bone.rest_direction[2]});
    tails[i] = {start.x + along.x * bone.length, start.y + along.y * bone.length, start.z + along.z * bone.length};
    const Vec3 x = rotated(frames[i], {1, 0, 0}), y = rotated(frames[i], {0, 1, 0}), z = rotated(frames[i], {0, 0, 1});
    const Vec3 turned = rotated(frames[i], joint);
    const float shift[3] = {start.x - turned.x, start.y - turned.y, start.z - turned.z};
    const float rows[3][3] = {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}};
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l) all[i].m[k][l] = rows[k][l];
      all[i].m[k][3] = shift[k];
    }
  }
  return all;
}

/// The largest difference between the places of two points under both.
float largest_difference(std::span<const Mat34> a, std::span<const Mat34> b) {
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (const Vec3& point : {Vec3{0, 0, 0}, Vec3{0.1f, -0.1f, -0.1f}}) {
      most = std::max(most, distance(transformed(a[i], point), transformed(b[i], point)));
    }
  }
  return most;
}

TestRig rig_of(ChainModel model) {
  TestRig rig = nine_bone_rig();
  rig.model = model;
  for (std::size_t i = 1; i < rig.dynamics.size(); ++i) rig.dynamics[i].torsion = i < 4 ? 5.0f : kShortestArc;
  return rig;
}

HairDesc with_poses(std::uint32_t instances = 1) {
  return {.instances = instances, .solver = &kCharacterSolver, .follows_poses = true};
}

TEST(Pose, AtWeightZeroHairIsTheAnimationExactly) {
  for (const ChainModel model : kModels) {
    const TestRig rig = rig_of(model);
    TestHair test(rig, with_poses());
    const float none[] = {0.0f};
    for (int frame = 0; frame < 90; ++frame) {
      const auto rotations = animation(rig, frame * double(kFrame));
      ASSERT_EQ(test.hair.set_head(0, wander(frame * double(kFrame))), Status::kOk);
      ASSERT_EQ(test.hair.set_pose(0, rotations, none), Status::kOk);
      ASSERT_EQ(test.hair.step({}), Status::kOk);
      EXPECT_LT(largest_difference(test.hair.palette(0), matrices_of(rig, rotations)), 1e-6f)
          << name_of(model) << ' ' << frame;
    }
  }
}

TEST(Pose, TheRestPoseAtFullWeightChangesNoBit) {
  for (const ChainModel model : kModels) {
    const TestRig rig = rig_of(model);
    TestHair posed(rig, with_poses()), plain(rig);
    const std::vector<Quat> rest(rig.bones.size());
    const float all[] = {1.0f};
    for (int frame = 0; frame < 60; ++frame) {
      ASSERT_EQ(posed.hair.set_pose(0, rest, all), Status::kOk);
      for (TestHair* const test : {&posed, &plain}) {
        ASSERT_EQ(test->hair.set_head(0, wander(frame * double(kFrame))), Status::kOk);
        ASSERT_EQ(test->hair.step({}), Status::kOk);
      }
    }
    EXPECT_EQ(largest_difference(posed.hair.palette(0), plain.hair.palette(0)), 0.0f) << name_of(model);
  }
}

TEST(Pose, AtFullWeightIsWhatPulls) {
  for (const ChainModel model : kModels) {
    TestRig rig = rig_of(model);
    rig.colliders.clear();
    TestHair test(rig, with_poses());
    const auto rotations = animation(rig, 0.4);
    const float all[] = {1.0f};
    StepSettings weightless;
    weightless.environment.gravity = {};
    ASSERT_EQ(test.hair.set_pose(0, rotations, all), Status::kOk);
    for (int frame = 0; frame < 600; ++frame) ASSERT_EQ(test.hair.step(weightless), Status::kOk);
    EXPECT_LT(largest_difference(test.hair.palette(0), matrices_of(rig, rotations)), 1e-4f) << name_of(model);
  }
}

/// The largest acceleration of any bone's end between three frames, m/s^2.
float largest_jerk(const std::vector<Vec3>& a, const std::vector<Vec3>& b, const std::vector<Vec3>& c) {
  float most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Vec3 change{c[i].x - 2 * b[i].x + a[i].x, c[i].y - 2 * b[i].y + a[i].y, c[i].z - 2 * b[i].z + a[i].z};
    most = std::max(most, distance(change, {}) / (kFrame * kFrame));
  }
  return most;
}

TEST(Pose, FromTheAnimationToTheSimulationVelocityDoesNotJump) {
  for (const ChainModel model : kModels) {
    const TestRig rig = rig_of(model);
    TestHair test(rig, with_poses());
    std::vector<Vec3> before, last;
    float animated = 0, at_switch = 0;
    for (int frame = 0; frame < 40; ++frame) {
      const float weight[] = {frame < 30 ? 0.0f : 1.0f};
      ASSERT_EQ(test.hair.set_pose(0, animation(rig, frame * double(kFrame)), weight), Status::kOk);
      ASSERT_EQ(test.hair.step({}), Status::kOk);
      const auto ends = test.ends();
      if (frame >= 2 && frame < 30) animated = std::max(animated, largest_jerk(before, last, ends));
      if (frame == 30 || frame == 31) at_switch = std::max(at_switch, largest_jerk(before, last, ends));
      before = last;
      last = ends;
    }
    // Gravity and springs set in; a jump of velocity by 1 m/s would be 60.
    EXPECT_LT(at_switch, animated + 20.0f) << name_of(model);
  }
}

TEST(Pose, BetweenTheTwoIsBetweenTheTwoAndStretchesNothing) {
  for (const ChainModel model : kModels) {
    const TestRig rig = rig_of(model);
    TestHair test(rig, with_poses());
    float last = 0;
    for (int i = 0; i <= 10; ++i) {
      const float weight[] = {0.1f * float(i)};
      const auto rotations = animation(rig, 0.4);
      ASSERT_EQ(test.hair.set_pose(0, rotations, weight), Status::kOk);
      for (int frame = 0; frame < 200; ++frame) ASSERT_EQ(test.hair.step({}), Status::kOk);
      EXPECT_LT(worst_stretch(rig, test.ends()), 1e-5f);
      const float off = largest_difference(test.hair.palette(0), matrices_of(rig, rotations));
      EXPECT_GE(off, last - 1e-4f) << name_of(model) << ' ' << i;
      last = off;
    }
    EXPECT_GT(last, 1e-3f) << "gravity bends what is simulated";
  }
}

TEST(Pose, EachChainHasItsOwnWeight) {
  const TestRig rig = rig_of(ChainModel::kCascade);
  TestHair test(rig, with_poses()), simulated(rig, with_poses());
  const float mixed[] = {1.0f, 0.0f, 1.0f}, all[] = {1.0f};
  for (int frame = 0; frame < 60; ++frame) {
    const auto rotations = animation(rig, frame * double(kFrame));
    ASSERT_EQ(test.hair.set_pose(0, rotations, mixed), Status::kOk);
    ASSERT_EQ(simulated.hair.set_pose(0, rotations, all), Status::kOk);
    for (TestHair* const each : {&test, &simulated}) ASSERT_EQ(each->hair.step({}), Status::kOk);
  }
  const auto rotations = matrices_of(rig, animation(rig, 59 * double(kFrame)));
  const auto mine = test.hair.palette(0), others = simulated.hair.palette(0);
  EXPECT_LT(largest_difference(mine.subspan(4, 3), std::span(rotations).subspan(4, 3)), 1e-6f);
  EXPECT_EQ(largest_difference(mine.subspan(1, 3), others.subspan(1, 3)), 0.0f);
  EXPECT_EQ(largest_difference(mine.subspan(7, 3), others.subspan(7, 3)), 0.0f);
}

TEST(Pose, OfOneHeadIsNoOtherHeads) {
  const TestRig rig = rig_of(ChainModel::kPassive);
  TestHair crowd(rig, with_poses(20)), alone(rig, with_poses()), plain(rig);
  const float half[] = {0.5f};
  for (int frame = 0; frame < 40; ++frame) {
    const auto rotations = animation(rig, frame * double(kFrame));
    ASSERT_EQ(crowd.hair.set_pose(13, rotations, half), Status::kOk);
    ASSERT_EQ(alone.hair.set_pose(0, rotations, half), Status::kOk);
    for (TestHair* const each : {&crowd, &alone, &plain}) ASSERT_EQ(each->hair.step({}), Status::kOk);
  }
  EXPECT_EQ(largest_difference(crowd.hair.palette(13), alone.hair.palette(0)), 0.0f);
  EXPECT_EQ(largest_difference(crowd.hair.palette(12), plain.hair.palette(0)), 0.0f);
}

TEST(Pose, EndsWhereItIsTakenBack) {
  const TestRig rig = rig_of(ChainModel::kCascade);
  TestHair test(rig, with_poses()), plain(rig);
  const float all[] = {1.0f};
  ASSERT_EQ(test.hair.set_pose(0, animation(rig, 0.4), all), Status::kOk);
  for (int frame = 0; frame < 30; ++frame) ASSERT_EQ(test.hair.step({}), Status::kOk);
  EXPECT_GT(largest_difference(test.hair.palette(0), plain.hair.palette(0)), 0.01f);
  ASSERT_EQ(test.hair.set_pose(0, {}, {}), Status::kOk);
  for (int frame = 0; frame < 900; ++frame) {
    ASSERT_EQ(test.hair.step({}), Status::kOk);
    ASSERT_EQ(plain.hair.step({}), Status::kOk);
  }
  EXPECT_LT(largest_difference(test.hair.palette(0), plain.hair.palette(0)), 1e-4f);
}

TEST(Pose, BadOnesChangeNothing) {
  const TestRig rig = rig_of(ChainModel::kCascade);
  TestHair test(rig, with_poses());
  auto rotations = animation(rig, 0.4);
  const float all[] = {1.0f}, two[] = {1.0f, 1.0f}, beyond[] = {1.1f}, none[] = {std::nanf("")};
  ASSERT_EQ(test.hair.set_pose(0, rotations, all), Status::kOk);
  ASSERT_EQ(test.hair.step({}), Status::kOk);
  const auto before = test.memory_copy();
  EXPECT_EQ(test.hair.set_pose(0, rotations, two), Status::kSizeMismatch);
  EXPECT_EQ(test.hair.set_pose(0, std::span(rotations).first(3), all), Status::kSizeMismatch);
  EXPECT_EQ(test.hair.set_pose(0, rotations, beyond), Status::kBadArgument);
  EXPECT_EQ(test.hair.set_pose(0, rotations, none), Status::kBadArgument);
  EXPECT_EQ(test.hair.set_pose(1, rotations, all), Status::kBadIndex);
  rotations[3] = {0, 0, 0, 0.5f};
  EXPECT_EQ(test.hair.set_pose(0, rotations, all), Status::kBadPose);
  EXPECT_EQ(test.memory_copy(), before);
  TestHair plain(rig);
  EXPECT_EQ(plain.hair.set_pose(0, rotations, all), Status::kNotAsked);
}

}  // namespace coif::pose_test
