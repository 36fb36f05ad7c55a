// Colliders of the asset that hang on the bones of a body: Hair::set_body().

#include "models/playback.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace coif::body_test {

/// A strand behind the head, and an upper arm beside it whose bone is turned against the model's axes.
TestRig rig_with_arm(ChainModel model) {
  TestRig rig;
  rig.model = model;
  TestBone bone{.joint = {0, 0.05f, -0.1f}, .length = 0.06f};
  bone.stiffness = 100;
  bone.damping = 10;
  bone.torsion = kShortestArc;
  rig.add_strand(4, bone);
  const Quat arm = turned_about({0, 0, 1}, 0.7);
  rig.body_bones.push_back({0, {0.3f, -0.1f, -0.1f}, {arm.x, arm.y, arm.z, arm.w}});
  ColliderRecord capsule{};
  capsule.shape = ColliderShape::kCapsule;
  capsule.rotation[3] = 1;
  capsule.center[0] = 0.3f, capsule.center[1] = -0.1f, capsule.center[2] = -0.2f;
  capsule.axis[2] = 0.2f;
  capsule.radii[0] = capsule.radii[1] = capsule.radii[2] = 0.04f;
  rig.body_colliders.push_back(capsule);
  return rig;
}

/// The same collider, told by the game: `way` metres from its rest.
MovingCollider told(const TestRig& rig, const Vec3& way, float scale) {
  const ColliderRecord& record = rig.body_colliders[0];
  MovingCollider collider{
      .shape = ColliderShape::kCapsule,
      .center = {double(scale * (record.center[0] + way.x)), double(scale * (record.center[1] + way.y)),
                 double(scale * (record.center[2] + way.z))},
      .axis = {0, 0, 0.2f * scale}};
  collider.radius = 0.04f * scale;
  return collider;
}

/// Where the arm's bone then is.
BodyPose arm_at(const TestRig& rig, const Vec3& way, float scale) {
  const BodyBoneRecord& rest = rig.body_bones[0];
  BodyPose pose;
  const float joint[3] = {rest.joint[0] + way.x, rest.joint[1] + way.y, rest.joint[2] + way.z};
  for (int axis = 0; axis < 3; ++axis) pose.position[axis] = double(scale * joint[axis]);
  pose.rotation = {rest.rotation[0], rest.rotation[1], rest.rotation[2], rest.rotation[3]};
  return pose;
}

TEST(Body, ItsCollidersGoWhereItsBonesGo) {
  for (const ChainModel model : {ChainModel::kCascade, ChainModel::kPassive}) {
    for (const float scale : {1.0f, 2.0f}) {
      const TestRig rig = rig_with_arm(model);
      TestHair body(rig, HairDesc{.solver = &kCharacterSolver, .follows_body = true});
      TestHair game(rig, HairDesc{.solver = &kCharacterSolver, .moving_colliders = 1});
      HeadPose head;
      head.scale = scale;
      float pushed = 0;
      for (int frame = 0; frame < 60; ++frame) {
        const Vec3 way{-0.3f * float(std::sin(frame * 0.08)), 0, 0};
        for (TestHair* const test : {&body, &game}) ASSERT_EQ(test->hair.set_head(0, head), Status::kOk);
        ASSERT_EQ(body.hair.set_body(0, std::vector{arm_at(rig, way, scale)}), Status::kOk);
        ASSERT_EQ(game.hair.set_colliders(0, std::vector{told(rig, way, scale)}), Status::kOk);
        for (TestHair* const test : {&body, &game}) ASSERT_EQ(test->hair.step({}), Status::kOk);
        EXPECT_LT(largest_distance(body.ends(), game.ends()), 2e-4f) << frame;
        pushed = std::max(pushed, largest_distance(body.ends(), rig.rest_ends()));
      }
      EXPECT_GT(pushed, 0.02f) << "it was at work";
    }
  }
}

/// A head twice as large has its bones' colliders twice as far from the bones, to all sides.
TEST(Body, CollidersOfAScaledHeadAreAsFarFromTheirBonesAsItIsLarge) {
  TestRig rig = rig_with_arm(ChainModel::kCascade);
  rig.body_bones[0] = {0, {0.2f, 0.1f, -0.25f}, {0, 0, 0, 1}};
  rig.body_colliders.clear();
  rig.add_body_sphere({0.03f, -0.1f, -0.12f}, 0.05f);
  for (const float scale : {0.5f, 1.0f, 3.0f}) {
    TestHair body(rig, HairDesc{.solver = &kCharacterSolver, .follows_body = true});
    TestHair game(rig, HairDesc{.solver = &kCharacterSolver, .moving_colliders = 1});
    HeadPose head;
    head.scale = scale;
    MovingCollider ball{.shape = ColliderShape::kSphere,
                        .center = {0.03 * double(scale), -0.1 * double(scale), -0.12 * double(scale)}};
    ball.radius = 0.05f * scale;
    for (int frame = 0; frame < 20; ++frame) {
      for (TestHair* const test : {&body, &game}) ASSERT_EQ(test->hair.set_head(0, head), Status::kOk);
      ASSERT_EQ(body.hair.set_body(0, std::vector{arm_at(rig, {}, scale)}), Status::kOk);
      ASSERT_EQ(game.hair.set_colliders(0, std::vector{ball}), Status::kOk);
      for (TestHair* const test : {&body, &game}) ASSERT_EQ(test->hair.step({}), Status::kOk);
      EXPECT_LT(largest_distance(body.ends(), game.ends()), 2e-4f) << scale << ", frame " << frame;
    }
    EXPECT_GT(largest_distance(body.ends(), rig.rest_ends()), 0.01f) << "it is at work";
  }
}

TEST(Body, UntilItIsToldNothingIsThere) {
  TestRig rig = rig_with_arm(ChainModel::kCascade);
  rig.body_colliders[0].center[0] = 0;  // through the strand
  TestHair body(rig, HairDesc{.solver = &kCharacterSolver, .follows_body = true}), plain(rig);
  for (int frame = 0; frame < 30; ++frame) {
    ASSERT_EQ(body.hair.step({}), Status::kOk);
    ASSERT_EQ(plain.hair.step({}), Status::kOk);
  }
  EXPECT_EQ(largest_distance(body.ends(), plain.ends()), 0.0f);
}

TEST(Body, ABoneMindsOnlyThoseOfItsSet) {
  TestRig rig = rig_with_arm(ChainModel::kCascade);
  rig.body_colliders[0].center[0] = 0.02f;
  AssetContents contents = rig.contents();
  for (std::uint32_t& set : contents.body_sets) set = 0;
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  const HairDesc desc{.solver = &kCharacterSolver, .follows_body = true};
  AlignedBytes memory(std::vector<std::byte>(Hair::memory_need(asset, desc).bytes));
  Hair hair;
  ASSERT_EQ(hair.create(asset, desc, memory.bytes()), Status::kOk);
  TestHair plain(rig);
  const BodyPose arm = arm_at(rig, {}, 1);
  for (int frame = 0; frame < 30; ++frame) {
    ASSERT_EQ(hair.set_body(0, {&arm, 1}), Status::kOk);
    ASSERT_EQ(hair.step({}), Status::kOk);
    ASSERT_EQ(plain.hair.step({}), Status::kOk);
  }
  const auto mine = hair.palette(0), others = plain.hair.palette(0);
  EXPECT_EQ(std::memcmp(mine.data(), others.data(), mine.size_bytes()), 0);
}

TEST(Body, GoesAlongWithAHeadThatIsPutElsewhere) {
  const TestRig rig = rig_with_arm(ChainModel::kCascade);
  TestHair test(rig, HairDesc{.solver = &kCharacterSolver, .follows_body = true});
  const auto tell = [&](double x) {
    BodyPose arm = arm_at(rig, {-0.29f, 0, 0}, 1);
    arm.position[0] += x;
    EXPECT_EQ(test.hair.set_body(0, {&arm, 1}), Status::kOk);
  };
  for (int frame = 0; frame < 200; ++frame) {
    tell(0);
    ASSERT_EQ(test.hair.step({.sleep_after = 1e9f}), Status::kOk);
  }
  const auto before = test.ends();
  ASSERT_EQ(test.hair.teleport(0, {{40, 0, 0}, {}}), Status::kOk);
  tell(40);
  ASSERT_EQ(test.hair.step({.sleep_after = 1e9f}), Status::kOk);
  EXPECT_LT(largest_distance(test.ends(), before), 1e-3f);
}

TEST(Body, BadOnesChangeNothing) {
  const TestRig rig = rig_with_arm(ChainModel::kCascade);
  TestHair test(rig, HairDesc{.solver = &kCharacterSolver, .follows_body = true});
  const auto before = test.memory_copy();
  BodyPose arm = arm_at(rig, {}, 1);
  EXPECT_EQ(test.hair.set_body(0, {}), Status::kSizeMismatch);
  EXPECT_EQ(test.hair.set_body(1, {&arm, 1}), Status::kBadIndex);
  arm.rotation = {};
  arm.rotation.w = 0;
  EXPECT_EQ(test.hair.set_body(0, {&arm, 1}), Status::kBadPose);
  arm = arm_at(rig, {}, 1);
  arm.position[2] = std::nan("");
  EXPECT_EQ(test.hair.set_body(0, {&arm, 1}), Status::kBadPose);
  EXPECT_EQ(test.memory_copy(), before);
  TestHair plain(rig);
  EXPECT_EQ(plain.hair.set_body(0, {&arm, 1}), Status::kNotAsked);
}

}  // namespace coif::body_test
