// Hair that was created without something refuses to be told of it, and nothing else happens: with nothing, with one
// and with too many.

#include "models/test_rig.h"

#include <coif/hair.h>

#include <gtest/gtest.h>

#include <vector>

namespace coif::not_asked_test {

TestRig rig() {
  TestRig rig = nine_bone_rig();
  rig.body_bones.push_back({0, {0, -0.3f, 0}, {0, 0, 0, 1}});
  rig.add_body_sphere({0, -0.3f, 0}, 0.05f);
  return rig;
}

/// With nothing beyond what each solver has, and with each thing but one.
std::vector<HairDesc> descriptions() {
  std::vector<HairDesc> all;
  for (const Solver* const solver : {&kCoifSolver, &kCascadeSolver, &kPassiveSolver, &kThesisSolver}) {
    for (const std::uint32_t heads : {1u, 3u}) all.push_back({.instances = heads, .solver = solver});
  }
  for (const Solver* const solver : {&kCharacterSolver, &kCharacterCascadeSolver}) {
    HairDesc desc{.instances = 2, .solver = solver};
    all.push_back(desc);
    desc = {.instances = 2,
            .solver = solver,
            .dynamics_sets = 2,
            .moving_colliders = 2,
            .follows_body = true,
            .follows_poses = true,
            .has_own_air = true,
            .feels_gusts = true};
    all.push_back(desc);
    for (int without = 0; without < 6; ++without) {
      HairDesc less = desc;
      if (without == 0) less.moving_colliders = 0;
      if (without == 1) less.follows_body = false;
      if (without == 2) less.follows_poses = false;
      if (without == 3) less.has_own_air = false;
      if (without == 4) less.feels_gusts = false;
      if (without == 5) less.dynamics_sets = 1;
      all.push_back(less);
    }
  }
  return all;
}

Status asked(bool is_asked, Status otherwise = Status::kOk) { return is_asked ? otherwise : Status::kNotAsked; }

TEST(NotAsked, CollidersOneMoreThanThereIsRoomFor) {
  for (const HairDesc& desc : descriptions()) {
    TestHair test(rig(), desc);
    const std::vector<MovingCollider> balls(desc.moving_colliders + 1);
    EXPECT_EQ(test.hair.set_colliders(0, {}), Status::kOk) << "none are never too many";
    EXPECT_EQ(test.hair.set_colliders(0, std::span(balls).first(desc.moving_colliders)), Status::kOk);
    EXPECT_EQ(test.hair.set_colliders(0, balls), Status::kNotAsked);
    EXPECT_EQ(test.hair.set_colliders(0, std::vector<MovingCollider>(70)), Status::kNotAsked);
    EXPECT_EQ(test.hair.set_colliders(desc.instances, {}), Status::kBadIndex);
    EXPECT_EQ(test.hair.set_colliders(0, {}), Status::kOk);
    EXPECT_EQ(test.hair.step({}), Status::kOk);
  }
}

TEST(NotAsked, Bodies) {
  const BodyPose arms[2];
  for (const HairDesc& desc : descriptions()) {
    TestHair test(rig(), desc);
    EXPECT_EQ(test.hair.set_body(0, {}), asked(desc.follows_body, Status::kSizeMismatch));
    EXPECT_EQ(test.hair.set_body(0, std::span(arms).first(1)), asked(desc.follows_body));
    EXPECT_EQ(test.hair.set_body(0, arms), asked(desc.follows_body, Status::kSizeMismatch));
    EXPECT_EQ(test.hair.set_body(desc.instances, {}), Status::kBadIndex);
    EXPECT_EQ(test.hair.step({}), Status::kOk);
  }
}

TEST(NotAsked, Poses) {
  for (const HairDesc& desc : descriptions()) {
    TestHair test(rig(), desc);
    const std::vector<Quat> rotations(test.hair.bone_count() + 1);
    const std::vector<float> weights(4, 0.5f);
    const auto fit = std::span(rotations).first(test.hair.bone_count());
    const bool is_asked = desc.follows_poses;
    EXPECT_EQ(test.hair.set_pose(0, {}, {}), asked(is_asked));
    EXPECT_EQ(test.hair.set_pose(0, fit, {}), asked(is_asked, Status::kSizeMismatch));
    EXPECT_EQ(test.hair.set_pose(0, {}, std::span(weights).first(1)), asked(is_asked, Status::kSizeMismatch));
    EXPECT_EQ(test.hair.set_pose(0, rotations, std::span(weights).first(1)), asked(is_asked, Status::kSizeMismatch));
    EXPECT_EQ(test.hair.set_pose(0, fit, weights), asked(is_asked, Status::kSizeMismatch)) << "of three chains";
    EXPECT_EQ(test.hair.set_pose(0, fit, std::span(weights).first(3)), asked(is_asked));
    EXPECT_EQ(test.hair.set_pose(desc.instances, {}, {}), Status::kBadIndex);
    EXPECT_EQ(test.hair.step({}), Status::kOk);
  }
}

TEST(NotAsked, AirGustsAndDynamics) {
  for (const HairDesc& desc : descriptions()) {
    TestHair test(rig(), desc);
    EXPECT_EQ(test.hair.set_air(0, {}), asked(desc.has_own_air));
    EXPECT_EQ(test.hair.set_air(0, {.exposure = 2}), asked(desc.has_own_air, Status::kBadArgument));
    EXPECT_EQ(test.hair.set_air(desc.instances, {}), Status::kBadIndex);
    EXPECT_EQ(test.hair.set_gusts({}), asked(desc.feels_gusts));
    EXPECT_EQ(test.hair.set_gusts({.amplitude = -1}), asked(desc.feels_gusts, Status::kBadArgument));
    EXPECT_EQ(test.hair.gusts_way(), 0.0);
    EXPECT_EQ(test.hair.set_dynamics(0, {2, 2, 2}), asked(desc.dynamics_sets > 1));
    EXPECT_EQ(test.hair.set_dynamics(desc.dynamics_sets, {}), Status::kNotAsked);
    EXPECT_EQ(test.hair.set_dynamics(~0u, {}), Status::kNotAsked);
    EXPECT_EQ(test.hair.choose_dynamics(0, 0), Status::kOk) << "there is always one";
    EXPECT_EQ(test.hair.choose_dynamics(0, desc.dynamics_sets), Status::kNotAsked);
    EXPECT_EQ(test.hair.choose_dynamics(desc.instances, 0), Status::kBadIndex);
    EXPECT_EQ(test.hair.step({}), Status::kOk);
  }
}

TEST(NotAsked, IntervalsAndLevels) {
  for (const std::uint32_t longest : {1u, 2u, 4u}) {
    TestHair test(rig(), {.instances = 2, .longest_interval = longest});
    for (const std::uint32_t interval : {0u, 1u, 2u, 3u, 4u, 5u, 8u, ~0u}) {
      const bool is_there = (interval == 1 || interval == 2 || interval == 4) && interval <= longest;
      EXPECT_EQ(test.hair.set_detail(0, {.interval = interval}), is_there ? Status::kOk : Status::kBadArgument);
    }
    EXPECT_EQ(test.hair.set_detail(0, {.level = 1}), Status::kBadArgument) << "it has one level";
    EXPECT_EQ(test.hair.set_detail(2, {}), Status::kBadIndex);
    EXPECT_EQ(test.hair.step({}), Status::kOk);
  }
}

TEST(NotAsked, OfNoHeadsNothingIsAsked) {
  TestHair test(rig(), {.instances = 2});
  const std::vector<HeadPose> poses(3);
  const std::uint32_t heads[] = {0, 1, 2};
  EXPECT_EQ(test.hair.set_heads({}), Status::kSizeMismatch);
  EXPECT_EQ(test.hair.set_heads(poses), Status::kSizeMismatch);
  EXPECT_EQ(test.hair.set_heads(std::span(poses).first(2)), Status::kOk);
  EXPECT_EQ(test.hair.settle({}, 1, {}), Status::kOk);
  EXPECT_EQ(test.hair.settle(heads, 1, {}), Status::kBadIndex);
  EXPECT_EQ(test.hair.push(2, {}), Status::kBadIndex);
  EXPECT_EQ(test.hair.bone_ends(0, {}), Status::kSizeMismatch);
}

TEST(NotAsked, HairThatWasNotCreatedSaysSo) {
  Hair none;
  EXPECT_EQ(none.set_colliders(0, {}), Status::kNotCreated);
  EXPECT_EQ(none.set_body(0, {}), Status::kNotCreated);
  EXPECT_EQ(none.set_pose(0, {}, {}), Status::kNotCreated);
  EXPECT_EQ(none.set_air(0, {}), Status::kNotCreated);
  EXPECT_EQ(none.set_gusts({}), Status::kNotCreated);
  EXPECT_EQ(none.set_dynamics(0, {}), Status::kNotCreated);
  EXPECT_EQ(none.choose_dynamics(0, 0), Status::kNotCreated);
  EXPECT_EQ(none.set_detail(0, {}), Status::kNotCreated);
  EXPECT_EQ(none.push(0, {}), Status::kNotCreated);
  EXPECT_EQ(none.set_heads({}), Status::kNotCreated);
  EXPECT_EQ(none.set_head(0, {}), Status::kNotCreated);
  EXPECT_EQ(none.settle({}, 1, {}), Status::kNotCreated);
  EXPECT_EQ(none.gusts_way(), 0.0);
}

}  // namespace coif::not_asked_test
