// coif.h does what coif/hair.h does, and takes what C callers may do wrong.

#include "c/in_c.h"
#include "models/playback.h"
#include "models/small_asset.h"
#include "models/test_rig.h"

#include <coif.h>

#include <gtest/gtest.h>

#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace coif::c_simulation_test {

class CSimulation : public testing::Test {
 protected:
  void SetUp() override {
    coif_hair_desc_init(&desc_);
    desc_.instances = 2;
    coif_step_settings_init(&settings_);
  }

  coif_status create() {
    allocate(coif_hair_memory_need(asset(), asset_bytes(), &desc_));
    return create_in(memory(), memory_->bytes().size());
  }

  /// As TestHair does it: from here on, poses are movement.
  void stand_upright() {
    const coif_head_pose upright = in_c({});
    for (std::uint32_t i = 0; i < desc_.instances; ++i) ASSERT_EQ(coif_hair_reset(hair_, i, &upright), COIF_OK);
  }

  coif_status create_in(void* memory, std::size_t bytes) {
    return coif_hair_create(asset(), asset_bytes(), &desc_, memory, bytes, &hair_);
  }

  void allocate(std::size_t bytes) { memory_ = std::make_unique<AlignedBytes>(std::vector<std::byte>(bytes)); }

  [[nodiscard]] const void* asset() { return file_.bytes().data(); }
  [[nodiscard]] std::byte* memory() { return memory_->bytes().data(); }
  [[nodiscard]] std::size_t asset_bytes() { return file_.bytes().size(); }

  AlignedBytes file_{write_asset(nine_bone_rig().contents())};
  std::unique_ptr<AlignedBytes> memory_;
  coif_hair_desc desc_{};
  coif_step_settings settings_{};
  coif_hair* hair_ = nullptr;
};

TEST_F(CSimulation, SetsAllHeadsAtOnce) {
  ASSERT_EQ(create(), COIF_OK);
  stand_upright();
  TestHair same(nine_bone_rig(), {.instances = 2});
  for (int frame = 0; frame < 20; ++frame) {
    const HeadPose poses[] = {{{0.03 * frame, 0, 0}, {}}, {{5, 0, 0}, {}}};
    const coif_head_pose its[] = {in_c(poses[0]), in_c(poses[1])};
    ASSERT_EQ(coif_hair_set_heads(hair_, its, 2), COIF_OK);
    ASSERT_EQ(same.hair.set_heads(poses), Status::kOk);
    ASSERT_EQ(coif_hair_step(hair_, &settings_), COIF_OK);
    ASSERT_EQ(same.hair.step({}), Status::kOk);
  }
  for (std::uint32_t i = 0; i < 2; ++i) {
    EXPECT_EQ(std::memcmp(coif_hair_palette(hair_, i), same.hair.palette(i).data(), same.hair.palette(i).size_bytes()),
              0);
  }
  const coif_head_pose one = in_c({});
  EXPECT_EQ(coif_hair_set_heads(hair_, &one, 1), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_hair_set_heads(hair_, nullptr, 2), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_hair_set_heads(nullptr, &one, 1), COIF_NOT_CREATED);
}

TEST_F(CSimulation, GoesBackToASavedState) {
  ASSERT_EQ(create(), COIF_OK);
  std::vector<std::byte> then(coif_hair_saved_bytes(hair_)), now(then.size());
  const coif_head_pose there = in_c({{0.2, 0, 0}, {}});
  ASSERT_EQ(coif_hair_save(hair_, then.data(), then.size()), COIF_OK);
  ASSERT_EQ(coif_hair_set_head(hair_, 0, &there), COIF_OK);
  ASSERT_EQ(coif_hair_step(hair_, &settings_), COIF_OK);
  ASSERT_EQ(coif_hair_save(hair_, now.data(), now.size()), COIF_OK);
  EXPECT_NE(now, then);
  ASSERT_EQ(coif_hair_restore(hair_, then.data(), then.size()), COIF_OK);
  ASSERT_EQ(coif_hair_save(hair_, now.data(), now.size()), COIF_OK);
  EXPECT_TRUE(now == then);
  now[40] ^= std::byte{1};
  EXPECT_EQ(coif_hair_restore(hair_, now.data(), now.size()), COIF_DAMAGED_STATE);
  EXPECT_EQ(coif_hair_restore(hair_, nullptr, now.size()), COIF_DAMAGED_STATE);
  EXPECT_EQ(coif_hair_save(hair_, nullptr, now.size()), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_hair_save(hair_, now.data(), now.size() - 1), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_hair_saved_bytes(nullptr), 0u);
  EXPECT_EQ(coif_hair_restore(nullptr, now.data(), now.size()), COIF_NOT_CREATED);
}

TEST_F(CSimulation, MovesHairToTheSameBits) {
  for (const coif_solver solver : {COIF_SOLVER_COIF, COIF_SOLVER_THESIS, COIF_SOLVER_PASSIVE}) {
    desc_.solver = solver;
    ASSERT_EQ(create(), COIF_OK);
    stand_upright();
    HairDesc desc{.instances = 2};
    if (solver == COIF_SOLVER_THESIS) desc.solver = &kThesisSolver;
    if (solver == COIF_SOLVER_PASSIVE) desc.solver = &kPassiveSolver;
    TestHair same(nine_bone_rig(), desc);
    ASSERT_EQ(coif_hair_bone_count(hair_), same.hair.bone_count());
    StepSettings settings;
    settings.environment.true_gravity = settings_.true_gravity = solver == COIF_SOLVER_PASSIVE ? 1 : 0;
    for (int frame = 1; frame <= 30; ++frame) {
      HeadPose pose = wander(frame / 60.0);
      pose.scale = 1.25f;
      const coif_head_pose pose_in_c = in_c(pose);
      if (frame % 3 == 0) {
        const coif_head_velocity velocity{{1, 2, 3}, {0.1f, 0.2f, 0.3f}};
        ASSERT_EQ(coif_hair_set_moving_head(hair_, 1, &pose_in_c, &velocity), COIF_OK);
        ASSERT_EQ(same.hair.set_head(1, pose, {{1, 2, 3}, {0.1f, 0.2f, 0.3f}}), Status::kOk);
      } else {
        ASSERT_EQ(coif_hair_set_head(hair_, 1, &pose_in_c), COIF_OK);
        ASSERT_EQ(same.hair.set_head(1, pose), Status::kOk);
      }
      ASSERT_EQ(coif_hair_step(hair_, &settings_), COIF_OK);
      ASSERT_EQ(same.hair.step(settings), Status::kOk);
    }
    const auto palette = same.hair.palette(1);
    EXPECT_EQ(std::memcmp(coif_hair_palette(hair_, 1), palette.data(), palette.size_bytes()), 0);
    std::vector<coif_vec3> ends(palette.size());
    std::vector<Vec3> same_ends(palette.size());
    ASSERT_EQ(coif_hair_bone_ends(hair_, 1, ends.data(), std::uint32_t(ends.size())), COIF_OK);
    ASSERT_EQ(same.hair.bone_ends(1, same_ends), Status::kOk);
    EXPECT_EQ(std::memcmp(ends.data(), same_ends.data(), ends.size() * sizeof ends[0]), 0);
  }
}

TEST_F(CSimulation, StepsInParts) {
  ASSERT_EQ(create(), COIF_OK);
  const coif_head_pose pose = in_c(wander(0.1));
  ASSERT_EQ(coif_hair_teleport(hair_, 0, &pose), COIF_OK);
  ASSERT_EQ(coif_hair_begin_step(hair_, &settings_), COIF_OK);
  ASSERT_EQ(coif_hair_job_count(hair_), 1u);
  coif_hair_run_job(hair_, 0);
  coif_hair_finish_step(hair_);
  const coif_detail unseen{0, 1, 0};
  EXPECT_EQ(coif_hair_set_detail(hair_, 0, &unseen), COIF_OK);
  EXPECT_EQ(coif_hair_is_asleep(hair_, 7), 0);
}

TEST_F(CSimulation, DefaultsAreThoseOfTheOtherInterface) {
  const StepSettings usual;
  EXPECT_EQ(settings_.dt, usual.dt);
  EXPECT_EQ(settings_.gravity.y, usual.environment.gravity.y);
  EXPECT_EQ(settings_.air_follow, usual.environment.air_follow);
  EXPECT_EQ(settings_.stiffness, usual.dynamics.stiffness);
  EXPECT_EQ(settings_.teleport_angle, usual.teleport_angle);
  EXPECT_EQ(settings_.sleep_speed, usual.sleep_speed);
  EXPECT_EQ(settings_.true_gravity, usual.environment.true_gravity);
  coif_head_pose pose;
  coif_head_pose_init(&pose);
  EXPECT_EQ(pose.rotation[3], HeadPose{}.rotation.w);
  EXPECT_EQ(pose.scale, HeadPose{}.scale);
  EXPECT_EQ(pose.position[1] + pose.rotation[0] + pose.reserved, 0);
  coif_hair_desc_init(&desc_);
  EXPECT_EQ(desc_.instances, HairDesc{}.instances);
  EXPECT_EQ(desc_.longest_interval, HairDesc{}.longest_interval);
}

TEST_F(CSimulation, StatusesAreTheSameNumbers) {
  for (int code = COIF_OK; code <= COIF_BAD_SCALE; ++code) {
    EXPECT_STREQ(coif_describe(coif_status(code)), describe(Status(code)));
  }
  EXPECT_EQ(int(COIF_BAD_SCALE), int(Status::kBadScale));
  EXPECT_STREQ(coif_describe(COIF_BAD_POSE), describe(Status::kBadPose));
  EXPECT_STREQ(coif_describe(COIF_SIZE_MISMATCH), describe(Status::kSizeMismatch));
}

TEST_F(CSimulation, AScaleThatNobodySetIsNamed) {
  ASSERT_EQ(create(), COIF_OK);
  coif_head_pose unset = in_c({});
  unset.scale = 0;
  const coif_head_velocity still{};
  EXPECT_EQ(coif_hair_set_head(hair_, 0, &unset), COIF_BAD_SCALE);
  EXPECT_EQ(coif_hair_set_moving_head(hair_, 0, &unset, &still), COIF_BAD_SCALE);
  EXPECT_EQ(coif_hair_reset(hair_, 0, &unset), COIF_BAD_SCALE);
  EXPECT_EQ(coif_hair_teleport(hair_, 0, &unset), COIF_BAD_SCALE);
  const coif_head_pose both[] = {unset, unset};
  EXPECT_EQ(coif_hair_set_heads(hair_, both, 2), COIF_BAD_SCALE);
  EXPECT_NE(std::strstr(coif_describe(COIF_BAD_SCALE), "scale is outside of 0.05 to 20"), nullptr);
}

TEST_F(CSimulation, TheFirstPosePutsTheHeadThere) {
  ASSERT_EQ(create(), COIF_OK);
  settings_.gravity = {0, 0, 0};
  const coif_head_pose far = in_c({{3, 1.6, -2.5}, {}});
  std::vector<coif_vec3> before(coif_hair_bone_count(hair_)), after(before.size());
  ASSERT_EQ(coif_hair_bone_ends(hair_, 1, before.data(), std::uint32_t(before.size())), COIF_OK);
  ASSERT_EQ(coif_hair_set_head(hair_, 1, &far), COIF_OK);
  for (int frame = 0; frame < 10; ++frame) ASSERT_EQ(coif_hair_step(hair_, &settings_), COIF_OK);
  ASSERT_EQ(coif_hair_bone_ends(hair_, 1, after.data(), std::uint32_t(after.size())), COIF_OK);
  for (std::size_t i = 0; i < before.size(); ++i) {
    EXPECT_NEAR(after[i].x, before[i].x, 1e-5f);
    EXPECT_NEAR(after[i].y, before[i].y, 1e-5f);
  }
}

TEST_F(CSimulation, WhatHairWasNotCreatedForIsRefusedWithNothingWithNullAndWithTooMany) {
  ASSERT_EQ(create(), COIF_OK);
  coif_moving_collider ball;
  coif_moving_collider_init(&ball);
  const coif_body_pose bone{{0, 0, 0}, {0, 0, 0, 1}};
  const coif_quat turn{0, 0, 0, 1};
  const float weight = 1;
  coif_head_air air;
  coif_head_air_init(&air);
  coif_gusts gusts;
  coif_gusts_init(&gusts);
  EXPECT_EQ(coif_hair_set_colliders(hair_, 0, nullptr, 0), COIF_OK);
  EXPECT_EQ(coif_hair_set_colliders(hair_, 0, &ball, 0), COIF_OK);
  EXPECT_EQ(coif_hair_set_colliders(hair_, 0, nullptr, 1), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_colliders(hair_, 0, &ball, 1), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_set_body(hair_, 0, nullptr, 0), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_set_body(hair_, 0, nullptr, 1), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_body(hair_, 0, &bone, 1), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_set_pose(hair_, 0, nullptr, 0, nullptr, 0), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_set_pose(hair_, 0, nullptr, 1, &weight, 1), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_pose(hair_, 0, &turn, 1, nullptr, 1), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_pose(hair_, 0, &turn, 1, &weight, 1), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_set_air(hair_, 0, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_air(hair_, 0, &air), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_set_gusts(hair_, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_gusts(hair_, &gusts), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_gusts_way(hair_), 0);
  EXPECT_EQ(coif_hair_set_dynamics(hair_, 0, 1, 1, 1), COIF_NOT_ASKED);
  EXPECT_EQ(coif_hair_choose_dynamics(hair_, 0, 0), COIF_OK);
  EXPECT_EQ(coif_hair_choose_dynamics(hair_, 0, 1), COIF_NOT_ASKED);
  const coif_detail rare{0, 2, 1};
  EXPECT_EQ(coif_hair_set_detail(hair_, 0, &rare), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_set_detail(hair_, 0, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_settle(hair_, nullptr, 0, 1, &settings_), COIF_OK);
  EXPECT_EQ(coif_hair_settle(hair_, nullptr, 1, 1, &settings_), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_push(hair_, 0, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_step(hair_, &settings_), COIF_OK);
}

TEST_F(CSimulation, RefusesMemoryThatDoesNotDo) {
  const std::size_t need = coif_hair_memory_need(asset(), asset_bytes(), &desc_);
  allocate(need + 64);
  for (const std::size_t bytes : {std::size_t(0), std::size_t(64), need - 1}) {
    hair_ = reinterpret_cast<coif_hair*>(memory());
    EXPECT_EQ(create_in(memory(), bytes), COIF_MEMORY_TOO_SMALL) << bytes;
    EXPECT_EQ(hair_, nullptr);
  }
  EXPECT_EQ(create_in(memory() + 8, need), COIF_MEMORY_TOO_SMALL);
  EXPECT_EQ(create_in(nullptr, need), COIF_MEMORY_TOO_SMALL);
  EXPECT_EQ(create_in(memory(), need), COIF_OK);
}

TEST_F(CSimulation, AnAssetThatIsRefusedHasNoHair) {
  EXPECT_EQ(coif_hair_memory_need(asset(), 3, &desc_), 0u);
  ASSERT_EQ(create(), COIF_OK);
  EXPECT_EQ(coif_hair_create(asset(), 3, &desc_, memory(), memory_->bytes().size(), &hair_), COIF_ASSET_LACKS_DATA);
}

TEST_F(CSimulation, DescriptionsItDoesNotKnowAreRefused) {
  ASSERT_EQ(create(), COIF_OK);
  const std::size_t bytes = memory_->bytes().size();
  for (const coif_hair_desc wrong : {coif_hair_desc{0, COIF_SOLVER_COIF, 1}, {1, 4, 1}, {1, COIF_SOLVER_COIF, 3}}) {
    desc_ = wrong;
    EXPECT_EQ(coif_hair_memory_need(asset(), asset_bytes(), &desc_), 0u);
    EXPECT_EQ(create_in(memory(), bytes), COIF_BAD_ARGUMENT);
    EXPECT_EQ(hair_, nullptr);
  }
}

TEST_F(CSimulation, NullIsAnErrorAndNoCrash) {
  const coif_head_pose pose = in_c({});
  EXPECT_EQ(coif_hair_set_head(nullptr, 0, &pose), COIF_NOT_CREATED);
  EXPECT_EQ(coif_hair_step(nullptr, &settings_), COIF_NOT_CREATED);
  EXPECT_EQ(coif_hair_bone_count(nullptr), 0u);
  EXPECT_EQ(coif_hair_palette(nullptr, 0), nullptr);
  EXPECT_STREQ(coif_hair_bone_name(nullptr, 0), "");
  EXPECT_EQ(coif_hair_memory_need(asset(), asset_bytes(), nullptr), 0u);
  ASSERT_EQ(create(), COIF_OK);
  EXPECT_EQ(coif_hair_set_head(hair_, 0, nullptr), COIF_BAD_POSE);
  EXPECT_EQ(coif_hair_set_moving_head(hair_, 0, &pose, nullptr), COIF_BAD_POSE);
  EXPECT_EQ(coif_hair_set_moving_head(nullptr, 0, &pose, nullptr), COIF_NOT_CREATED);
  EXPECT_EQ(coif_hair_set_head(hair_, 2, &pose), COIF_BAD_INDEX);
  EXPECT_EQ(coif_hair_step(hair_, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_hair_bone_ends(hair_, 0, nullptr, 12), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_hair_palette(hair_, 2), nullptr);
  EXPECT_STREQ(coif_hair_bone_name(hair_, 1000), "");
}

TEST(CVersion, LibraryAndHeadersAreOfOne) {
  EXPECT_STREQ(coif_version(), COIF_VERSION);
  const std::string joined = std::to_string(COIF_VERSION_MAJOR) + "." + std::to_string(COIF_VERSION_MINOR) + "." +
                             std::to_string(COIF_VERSION_PATCH);
  EXPECT_EQ(joined, COIF_VERSION);
#if COIF_VERSION_NUMBER < 1000  // preprocessors can compare it
  ADD_FAILURE() << "0.1.0 is the first version";
#endif
}

}  // namespace coif::c_simulation_test
