// What C tells of characters and air does what C++ does, and where hair is is told alike.

#include "models/playback.h"
#include "models/small_asset.h"
#include "models/test_rig.h"

#include <coif.h>
#include <coif/bone_transforms.h>
#include <coif/bounds.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>
#include <vector>

namespace coif::c_character_test {

/// Two heads on characters that C moves, and the same in C++.
class CCharacter : public testing::Test {
 protected:
  void SetUp() override {
    coif_hair_desc desc;
    coif_hair_desc_init(&desc);
    desc.instances = 2;
    desc.solver = COIF_SOLVER_CHARACTER;
    desc.moving_colliders = 2;
    desc.follows_poses = desc.has_own_air = desc.feels_gusts = 1;
    desc.dynamics_sets = 2;
    const void* const asset = file_.bytes().data();
    memory_ = std::make_unique<AlignedBytes>(
        std::vector<std::byte>(coif_hair_memory_need(asset, file_.bytes().size(), &desc)));
    ASSERT_EQ(
        coif_hair_create(asset, file_.bytes().size(), &desc, memory_->bytes().data(), memory_->bytes().size(), &hair_),
        COIF_OK);
    coif_head_pose upright;
    coif_head_pose_init(&upright);
    for (std::uint32_t i = 0; i < 2; ++i) ASSERT_EQ(coif_hair_reset(hair_, i, &upright), COIF_OK);
    coif_step_settings_init(&settings_);
  }

  void step_both() {
    ASSERT_EQ(coif_hair_step(hair_, &settings_), COIF_OK);
    ASSERT_EQ(same_.hair.step({}), Status::kOk);
  }
  void expect_same() {
    for (std::uint32_t i = 0; i < 2; ++i) {
      const auto palette = same_.hair.palette(i);
      EXPECT_EQ(std::memcmp(coif_hair_palette(hair_, i), palette.data(), palette.size_bytes()), 0) << i;
    }
  }

  AlignedBytes file_{write_asset(nine_bone_rig().contents())};
  std::unique_ptr<AlignedBytes> memory_;
  coif_hair* hair_ = nullptr;
  coif_step_settings settings_{};
  TestHair same_{nine_bone_rig(), HairDesc{.instances = 2,
                                           .solver = &kCharacterSolver,
                                           .dynamics_sets = 2,
                                           .moving_colliders = 2,
                                           .follows_poses = true,
                                           .has_own_air = true,
                                           .feels_gusts = true}};
};

TEST_F(CCharacter, CollidersAndPosesMoveHairAlike) {
  for (int frame = 0; frame < 60; ++frame) {
    const double x = 0.1 * std::sin(0.1 * frame);
    coif_moving_collider its;
    coif_moving_collider_init(&its);
    its.shape = COIF_CAPSULE;
    its.center[0] = x, its.center[1] = -0.05, its.center[2] = -0.2;
    its.axis = {0, 0, 0.15f};
    its.radius = 0.03f;
    MovingCollider mine{.shape = ColliderShape::kCapsule, .center = {x, -0.05, -0.2}, .axis = {0, 0, 0.15f}};
    mine.radius = 0.03f;
    ASSERT_EQ(coif_hair_set_colliders(hair_, 0, &its, 1), COIF_OK);
    ASSERT_EQ(same_.hair.set_colliders(0, {&mine, 1}), Status::kOk);
    const Quat turned = turned_about({1, 0, 0}, 0.3 * std::sin(0.05 * frame));
    const std::vector<Quat> pose(same_.hair.bone_count(), turned);
    const std::vector<coif_quat> in_c(pose.size(), {turned.x, turned.y, turned.z, turned.w});
    const float weight = 0.5f;
    ASSERT_EQ(coif_hair_set_pose(hair_, 1, in_c.data(), std::uint32_t(in_c.size()), &weight, 1), COIF_OK);
    ASSERT_EQ(same_.hair.set_pose(1, pose, {&weight, 1}), Status::kOk);
    step_both();
    expect_same();
  }
}

TEST_F(CCharacter, AirBlowsAndDynamicsMoveHairAlike) {
  coif_gusts gusts;
  coif_gusts_init(&gusts);
  gusts.amplitude = 3;
  ASSERT_EQ(coif_hair_set_gusts(hair_, &gusts), COIF_OK);
  ASSERT_EQ(same_.hair.set_gusts({.amplitude = 3}), Status::kOk);
  const coif_head_air draught = {{2, 0, 0}, 0.5f};
  ASSERT_EQ(coif_hair_set_air(hair_, 1, &draught), COIF_OK);
  ASSERT_EQ(same_.hair.set_air(1, {.wind = {2, 0, 0}, .exposure = 0.5f}), Status::kOk);
  ASSERT_EQ(coif_hair_set_dynamics(hair_, 1, 0.5f, 2, 3), COIF_OK);
  ASSERT_EQ(coif_hair_choose_dynamics(hair_, 0, 1), COIF_OK);
  ASSERT_EQ(same_.hair.set_dynamics(1, {0.5f, 2, 3}), Status::kOk);
  ASSERT_EQ(same_.hair.choose_dynamics(0, 1), Status::kOk);
  for (int frame = 0; frame < 30; ++frame) step_both();
  coif_impulse blow;
  coif_impulse_init(&blow);
  blow.speed = 2;
  ASSERT_EQ(coif_hair_push(hair_, 0, &blow), COIF_OK);
  ASSERT_EQ(same_.hair.push(0, {.speed = 2}), Status::kOk);
  for (int frame = 0; frame < 30; ++frame) step_both();
  expect_same();
  EXPECT_EQ(coif_hair_gusts_way(hair_), same_.hair.gusts_way());
  const double place[3] = {1, 2, 3};
  const Vec3 mine = gust_at({.amplitude = 3}, 4, place);
  const coif_vec3 its = coif_gust_at(&gusts, 4, place);
  EXPECT_EQ(std::memcmp(&mine, &its, sizeof its), 0);
  const std::uint32_t heads[] = {1, 0};
  ASSERT_EQ(coif_hair_settle(hair_, heads, 2, 0.5f, &settings_), COIF_OK);
  ASSERT_EQ(same_.hair.settle(heads, 0.5f, {}), Status::kOk);
  expect_same();
}

TEST_F(CCharacter, WhatIsMissingIsRefused) {
  const float weight = 2;
  const coif_head_air bad = {{0, 0, 0}, 2};
  EXPECT_EQ(coif_hair_set_colliders(nullptr, 0, nullptr, 0), COIF_NOT_CREATED);
  EXPECT_EQ(coif_hair_set_colliders(hair_, 0, nullptr, 1), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_colliders(hair_, 0, nullptr, 17), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_set_colliders(hair_, 2, nullptr, 0), COIF_BAD_INDEX);
  EXPECT_EQ(coif_hair_set_body(hair_, 0, nullptr, 0), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_set_pose(hair_, 0, nullptr, 0, &weight, 1), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_hair_set_pose(hair_, 0, nullptr, 0, nullptr, 0), COIF_OK) << "the rest pose";
  EXPECT_EQ(coif_hair_set_air(hair_, 0, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_air(hair_, 0, &bad), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_gusts(hair_, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_dynamics(hair_, 2, 1, 1, 1), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_push(hair_, 0, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_settle(hair_, nullptr, 0, 1, nullptr), COIF_BAD_ARGUMENT);
}

TEST(CObserving, BoundsBonesAndLinesAreThoseOfCpp) {
  AlignedBytes file(write_asset(small_asset()));
  Asset mine;
  ASSERT_TRUE(mine.open(file.bytes()));
  coif_asset asset;
  ASSERT_EQ(coif_asset_open(&asset, file.bytes().data(), file.bytes().size(), nullptr, 0), COIF_OK);
  const auto bones = std::uint32_t(mine.bones().size());
  const std::vector<Mat34> palette(bones);
  const auto* const in_c = reinterpret_cast<const coif_mat34*>(palette.data());
  std::vector<BoneBox> boxes(bones);
  std::vector<coif_bone_box> its_boxes(bones);
  ASSERT_EQ(find_bone_boxes(mine, boxes), Status::kOk);
  ASSERT_EQ(coif_find_bone_boxes(&asset, its_boxes.data(), bones), COIF_OK);
  EXPECT_EQ(std::memcmp(boxes.data(), its_boxes.data(), bones * sizeof(BoneBox)), 0);
  HairBounds bounds;
  coif_bounds its{};
  ASSERT_EQ(bound_hair(boxes, palette, bounds), Status::kOk);
  ASSERT_EQ(coif_bound_hair(its_boxes.data(), in_c, bones, &its), COIF_OK);
  EXPECT_EQ(std::memcmp(&bounds, &its, sizeof its), 0);
  EXPECT_EQ(coif_bound_hair(its_boxes.data(), nullptr, bones, &its), COIF_SIZE_MISMATCH);
  std::vector<BoneTransform> transforms(bones);
  std::vector<coif_bone_transform> its_transforms(bones);
  ASSERT_EQ(bone_transforms(mine, palette, transforms), Status::kOk);
  ASSERT_EQ(coif_bone_transforms(&asset, in_c, its_transforms.data(), bones), COIF_OK);
  EXPECT_EQ(std::memcmp(transforms.data(), its_transforms.data(), bones * sizeof(BoneTransform)), 0);

  coif_head_pose head;
  coif_head_pose_init(&head);
  int counts[5] = {};
  const auto count = [](const coif_debug_line* line, void* user) { ++static_cast<int*>(user)[line->kind]; };
  ASSERT_EQ(coif_draw_debug_lines(
                &asset, &head, in_c, bones,
                std::uint32_t{COIF_DRAW_BONES} | std::uint32_t{COIF_DRAW_COLLIDERS} | std::uint32_t{COIF_DRAW_LIMITS},
                count, counts),
            COIF_OK);
  EXPECT_EQ(counts[COIF_LINE_BONE] + counts[COIF_LINE_RIGID_BONE], int(bones) - 1);
  EXPECT_GT(counts[COIF_LINE_COLLIDER], 0);
  EXPECT_GT(counts[COIF_LINE_LIMIT], 0);
  EXPECT_EQ(coif_draw_debug_lines(&asset, &head, in_c, bones, COIF_DRAW_BONES, nullptr, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_draw_debug_lines(&asset, &head, in_c, 1, COIF_DRAW_BONES, count, counts), COIF_SIZE_MISMATCH);
}

}  // namespace coif::c_character_test
