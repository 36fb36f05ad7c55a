// coif/c/world.h: each head has the bits of a coif_hair that is told the same, and what C callers may do wrong is
// refused.

#include "c/in_c.h"
#include "models/playback.h"
#include "models/small_asset.h"
#include "sim/hair_town.h"

#include <coif.h>

#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <memory>
#include <vector>

namespace coif::c_world_test {

/// A head in the world, and the same head in a crowd of its own.
struct Wearer {
  coif_world_head head{};
  coif_hair* twin = nullptr;
};

class CWorld : public testing::Test {
 protected:
  void SetUp() override {
    coif_world_desc_init(&desc_);
    coif_step_settings_init(&settings_);
    for (const AssetContents& contents : {nine_bone_rig().contents(), hair_town::limited_strands().contents(),
                                          hair_town::half_limited_strands().contents()}) {
      files_.push_back(std::make_unique<AlignedBytes>(write_asset(contents)));
    }
  }

  std::byte* allocate(std::size_t bytes) {
    memory_.push_back(std::make_unique<AlignedBytes>(std::vector<std::byte>(bytes)));
    return memory_.back()->bytes().data();
  }

  void create() {
    const std::size_t bytes = coif_world_memory_need(&desc_);
    ASSERT_GT(bytes, 0u);
    ASSERT_EQ(coif_world_create(&desc_, allocate(bytes), bytes, &world_), COIF_OK);
    ASSERT_NE(world_, nullptr);
  }

  coif_status add_asset(std::size_t file, coif_world_asset* added, std::uint32_t crowd = 0) {
    const auto bytes = files_[file]->bytes();
    return coif_world_add_asset(world_, bytes.data(), bytes.size(), crowd, added);
  }

  /// A crowd of one head with the world's rules.
  coif_hair* twin_of(std::size_t file, const coif_head_pose& pose) {
    coif_hair_desc desc;
    coif_hair_desc_init(&desc);
    desc.solver = desc_.solver;
    desc.longest_interval = desc_.longest_interval;
    desc.moving_colliders = desc_.moving_colliders;
    desc.follows_poses = desc_.follows_poses;
    desc.has_own_air = desc_.has_own_air;
    desc.feels_gusts = desc_.feels_gusts;
    desc.dynamics_sets = desc_.dynamics_sets;
    const auto bytes = files_[file]->bytes();
    const std::size_t need = coif_hair_memory_need(bytes.data(), bytes.size(), &desc);
    coif_hair* hair = nullptr;
    EXPECT_EQ(coif_hair_create(bytes.data(), bytes.size(), &desc, allocate(need), need, &hair), COIF_OK);
    EXPECT_EQ(coif_hair_reset(hair, 0, &pose), COIF_OK);
    return hair;
  }

  void add_head(coif_world_asset asset, std::size_t file, const HeadPose& pose) {
    const coif_head_pose its = in_c(pose);
    Wearer wearer;
    ASSERT_EQ(coif_world_add_head(world_, asset, &its, &wearer.head), COIF_OK);
    wearer.twin = twin_of(file, its);
    wearers_.push_back(wearer);
  }

  void step_all() {
    ASSERT_EQ(coif_world_step(world_, &settings_), COIF_OK);
    for (const Wearer& each : wearers_) ASSERT_EQ(coif_hair_step(each.twin, &settings_), COIF_OK);
  }

  void expect_same() {
    for (const Wearer& each : wearers_) {
      const std::uint32_t bones = coif_world_bone_count(world_, each.head);
      ASSERT_EQ(bones, coif_hair_bone_count(each.twin));
      ASSERT_EQ(std::memcmp(coif_world_palette(world_, each.head), coif_hair_palette(each.twin, 0),
                            bones * sizeof(coif_mat34)),
                0);
      std::vector<coif_vec3> ends(bones), twins(bones);
      ASSERT_EQ(coif_world_bone_ends(world_, each.head, ends.data(), bones), COIF_OK);
      ASSERT_EQ(coif_hair_bone_ends(each.twin, 0, twins.data(), bones), COIF_OK);
      ASSERT_EQ(std::memcmp(ends.data(), twins.data(), bones * sizeof ends[0]), 0);
      ASSERT_EQ(coif_world_is_asleep(world_, each.head), coif_hair_is_asleep(each.twin, 0));
    }
  }

  std::vector<std::unique_ptr<AlignedBytes>> files_, memory_;
  std::vector<Wearer> wearers_;
  coif_world_desc desc_{};
  coif_step_settings settings_{};
  coif_world* world_ = nullptr;
};

TEST_F(CWorld, DefaultsAreThoseOfCpp) {
  const WorldDesc usual;
  EXPECT_EQ(desc_.assets, usual.assets);
  EXPECT_EQ(desc_.heads, usual.heads);
  EXPECT_EQ(desc_.hair_bytes, usual.hair_bytes);
  EXPECT_EQ(desc_.longest_interval, usual.longest_interval);
  EXPECT_EQ(desc_.dynamics_sets, usual.dynamics_sets);
  EXPECT_EQ(desc_.solver, std::uint32_t(COIF_SOLVER_COIF));
  Asset opened;
  ASSERT_TRUE(opened.open(files_[0]->bytes()));
  const auto bytes = files_[0]->bytes();
  EXPECT_EQ(coif_world_bytes_for(bytes.data(), bytes.size(), 5, &desc_, 3), HairWorld::bytes_for(opened, 5, {}, 3));
}

TEST_F(CWorld, EachHeadHasTheBitsOfACrowdOfItsOwn) {
  for (const coif_solver solver : {COIF_SOLVER_COIF, COIF_SOLVER_PASSIVE, COIF_SOLVER_CASCADE, COIF_SOLVER_THESIS}) {
    desc_.solver = solver;
    desc_.longest_interval = 2;
    wearers_.clear();
    create();
    std::array<coif_world_asset, 3> assets{};
    for (std::size_t i = 0; i < 3; ++i) ASSERT_EQ(add_asset(i, &assets[i], i == 2 ? 16 : 0), COIF_OK);
    for (std::size_t i = 0; i < 6; ++i) add_head(assets[i % 3], i % 3, {{0.5 * double(i), 0, 0}, {}});
    for (int frame = 1; frame <= 30; ++frame) {
      for (std::size_t i = 0; i < wearers_.size(); ++i) {
        const coif_head_pose pose = in_c(wander(frame / 60.0 + double(i)));
        const coif_head_velocity velocity{{1, 2, 3}, {0.1f, 0.2f, 0.3f}};
        const Wearer& each = wearers_[i];
        if (frame == 20) {
          ASSERT_EQ(coif_world_teleport(world_, each.head, &pose), coif_hair_teleport(each.twin, 0, &pose));
        } else if (i % 2 == 0) {
          ASSERT_EQ(coif_world_set_head(world_, each.head, &pose), coif_hair_set_head(each.twin, 0, &pose));
        } else {
          ASSERT_EQ(coif_world_set_moving_head(world_, each.head, &pose, &velocity), COIF_OK);
          ASSERT_EQ(coif_hair_set_moving_head(each.twin, 0, &pose, &velocity), COIF_OK);
        }
      }
      if (frame == 8) {
        const coif_detail unseen{0, 1, 0};
        ASSERT_EQ(coif_world_set_detail(world_, wearers_[1].head, &unseen), COIF_OK);
        ASSERT_EQ(coif_hair_set_detail(wearers_[1].twin, 0, &unseen), COIF_OK);
      }
      if (frame == 12) {  // One leaves, and one comes.
        ASSERT_EQ(coif_world_remove_head(world_, wearers_[2].head), COIF_OK);
        wearers_.erase(wearers_.begin() + 2);
        add_head(assets[0], 0, {{0, 1, 0}, {}});
      }
      step_all();
      expect_same();
    }
  }
}

TEST_F(CWorld, StepsInPartsSettlesAndGoesBackToASavedState) {
  create();
  coif_world_asset asset{};
  ASSERT_EQ(add_asset(0, &asset), COIF_OK);
  for (int i = 0; i < 3; ++i) add_head(asset, 0, {{double(i), 0, 0}, {}});
  const coif_world_head two[] = {wearers_[0].head, wearers_[2].head};
  ASSERT_EQ(coif_world_settle(world_, two, 2, 0.5f, &settings_), COIF_OK);
  for (const std::size_t i : {0u, 2u}) {
    const std::uint32_t first = 0;
    ASSERT_EQ(coif_hair_settle(wearers_[i].twin, &first, 1, 0.5f, &settings_), COIF_OK);
  }
  expect_same();
  std::vector<std::byte> then(coif_world_saved_bytes(world_)), now(then.size());
  ASSERT_EQ(coif_world_save(world_, then.data(), then.size()), COIF_OK);
  ASSERT_EQ(coif_world_begin_step(world_, &settings_), COIF_OK);
  for (std::uint32_t job = coif_world_job_count(world_); job-- > 0;) coif_world_run_job(world_, job);
  coif_world_finish_step(world_);
  for (const Wearer& each : wearers_) ASSERT_EQ(coif_hair_step(each.twin, &settings_), COIF_OK);
  expect_same();
  ASSERT_EQ(coif_world_save(world_, now.data(), now.size()), COIF_OK);
  EXPECT_NE(now, then);
  ASSERT_EQ(coif_world_restore(world_, then.data(), then.size()), COIF_OK);
  ASSERT_EQ(coif_world_save(world_, now.data(), now.size()), COIF_OK);
  EXPECT_EQ(now, then);
  now[40] ^= std::byte{1};
  EXPECT_EQ(coif_world_restore(world_, now.data(), now.size()), COIF_DAMAGED_STATE);
  EXPECT_EQ(coif_world_restore(world_, nullptr, now.size()), COIF_DAMAGED_STATE);
  EXPECT_EQ(coif_world_save(world_, now.data(), now.size() - 1), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_world_save(world_, nullptr, now.size()), COIF_SIZE_MISMATCH);
}

TEST_F(CWorld, CharactersAndAirMoveHairAlike) {
  desc_.solver = COIF_SOLVER_CHARACTER;
  desc_.moving_colliders = 1;
  desc_.follows_poses = desc_.has_own_air = desc_.feels_gusts = 1;
  desc_.dynamics_sets = 2;
  create();
  for (std::size_t i = 0; i < 2; ++i) {
    coif_world_asset asset{};
    ASSERT_EQ(add_asset(i, &asset), COIF_OK);
    add_head(asset, i, {});
  }
  const Wearer touched = wearers_[0], blown = wearers_[1];
  coif_gusts gusts;
  coif_gusts_init(&gusts);
  gusts.amplitude = 3;
  ASSERT_EQ(coif_world_set_gusts(world_, &gusts), COIF_OK);
  ASSERT_EQ(coif_world_set_dynamics(world_, 1, 0.5f, 2, 3), COIF_OK);
  for (const Wearer& each : wearers_) {
    ASSERT_EQ(coif_hair_set_gusts(each.twin, &gusts), COIF_OK);
    ASSERT_EQ(coif_hair_set_dynamics(each.twin, 1, 0.5f, 2, 3), COIF_OK);
  }
  const coif_head_air draught{{2, 0, 0}, 0.5f};
  ASSERT_EQ(coif_world_set_air(world_, blown.head, &draught), COIF_OK);
  ASSERT_EQ(coif_hair_set_air(blown.twin, 0, &draught), COIF_OK);
  ASSERT_EQ(coif_world_choose_dynamics(world_, blown.head, 1), COIF_OK);
  ASSERT_EQ(coif_hair_choose_dynamics(blown.twin, 0, 1), COIF_OK);
  coif_moving_collider ball;
  coif_moving_collider_init(&ball);
  ball.radius = 0.05f;
  coif_impulse blow;
  coif_impulse_init(&blow);
  blow.speed = 2;
  const std::vector<coif_quat> turned(coif_world_bone_count(world_, touched.head), {0.0998334f, 0, 0, 0.9950042f});
  const auto bones = std::uint32_t(turned.size());
  for (int frame = 0; frame < 40; ++frame) {
    ball.center[2] = -0.3 + 0.01 * frame;
    const float weight = 0.5f;
    ASSERT_EQ(coif_world_set_colliders(world_, touched.head, &ball, 1), COIF_OK);
    ASSERT_EQ(coif_hair_set_colliders(touched.twin, 0, &ball, 1), COIF_OK);
    ASSERT_EQ(coif_world_set_pose(world_, touched.head, turned.data(), bones, &weight, 1), COIF_OK);
    ASSERT_EQ(coif_hair_set_pose(touched.twin, 0, turned.data(), bones, &weight, 1), COIF_OK);
    if (frame == 20) {
      ASSERT_EQ(coif_world_push(world_, blown.head, &blow), COIF_OK);
      ASSERT_EQ(coif_hair_push(blown.twin, 0, &blow), COIF_OK);
    }
    step_all();
    expect_same();
  }
  EXPECT_GT(coif_world_gusts_way(world_), 0);
  EXPECT_EQ(coif_world_gusts_way(world_), coif_hair_gusts_way(blown.twin));
  EXPECT_EQ(coif_world_set_colliders(world_, touched.head, nullptr, 1), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_set_colliders(world_, touched.head, nullptr, 17), COIF_NOT_ASKED);
  EXPECT_EQ(coif_world_set_body(world_, touched.head, nullptr, 0), COIF_NOT_ASKED);
  EXPECT_EQ(coif_world_set_body(world_, touched.head, nullptr, 1), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_set_pose(world_, touched.head, nullptr, 1, nullptr, 0), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_set_air(world_, touched.head, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_set_gusts(world_, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_set_dynamics(world_, 2, 1, 1, 1), COIF_NOT_ASKED);
  EXPECT_EQ(coif_world_push(world_, touched.head, nullptr), COIF_BAD_ARGUMENT);
}

TEST_F(CWorld, DescriptionsAndMemoryThatDoNotDoAreRefused) {
  const std::size_t need = coif_world_memory_need(&desc_);
  std::byte* const memory = allocate(need + 64);
  for (const std::size_t bytes : {std::size_t(0), std::size_t(64), need - 1}) {
    world_ = reinterpret_cast<coif_world*>(memory);
    EXPECT_EQ(coif_world_create(&desc_, memory, bytes, &world_), COIF_MEMORY_TOO_SMALL) << bytes;
    EXPECT_EQ(world_, nullptr);
  }
  EXPECT_EQ(coif_world_create(&desc_, memory + 8, need, &world_), COIF_MEMORY_TOO_SMALL);
  EXPECT_EQ(coif_world_create(&desc_, nullptr, need, &world_), COIF_MEMORY_TOO_SMALL);
  EXPECT_EQ(coif_world_create(&desc_, memory, need, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_create(nullptr, memory, need, &world_), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_memory_need(nullptr), 0u);
  const auto spoiled = [this](auto member, std::uint32_t value) {
    coif_world_desc bad = desc_;
    bad.*member = value;
    return bad;
  };
  for (const coif_world_desc& bad :
       {spoiled(&coif_world_desc::assets, 0), spoiled(&coif_world_desc::heads, 0), spoiled(&coif_world_desc::solver, 9),
        spoiled(&coif_world_desc::instruction_set, 8), spoiled(&coif_world_desc::instruction_set, 256),
        spoiled(&coif_world_desc::longest_interval, 3), spoiled(&coif_world_desc::moving_colliders, 1)}) {
    EXPECT_EQ(coif_world_memory_need(&bad), 0u);
    EXPECT_EQ(coif_world_create(&bad, memory, need, &world_), COIF_BAD_ARGUMENT);
    EXPECT_EQ(coif_world_bytes_for(files_[0]->bytes().data(), files_[0]->bytes().size(), 1, &bad, 0), 0u);
  }
  EXPECT_EQ(coif_world_bytes_for(nullptr, 400, 1, &desc_, 0), 0u);
  EXPECT_EQ(coif_world_bytes_for(files_[0]->bytes().data(), 3, 1, &desc_, 0), 0u);
}

TEST_F(CWorld, NullAndHandlesThatNameNothingAreErrorsAndNoCrash) {
  const coif_head_pose pose = in_c({});
  coif_head_pose bent = pose;
  bent.rotation[3] = 2;
  coif_world_asset asset{7, 7};
  coif_world_head head{7, 7};
  const std::uint32_t before = head.generation;
  EXPECT_EQ(add_asset(0, &asset), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_add_head(nullptr, asset, &pose, &head), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_remove_head(nullptr, head), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_remove_asset(nullptr, asset), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_set_head(nullptr, head, &pose), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_step(nullptr, &settings_), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_settle(nullptr, &head, 1, 1, &settings_), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_choose_dynamics(nullptr, head, 0), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_set_dynamics(nullptr, 0, 1, 1, 1), COIF_NOT_CREATED);
  EXPECT_EQ(coif_world_has_head(nullptr, head) + coif_world_has_asset(nullptr, asset), 0);
  EXPECT_EQ(coif_world_is_asleep(nullptr, head), 0);
  EXPECT_EQ(coif_world_job_count(nullptr) + coif_world_bone_count(nullptr, head), 0u);
  EXPECT_EQ(coif_world_saved_bytes(nullptr), 0u);
  EXPECT_EQ(coif_world_gusts_way(nullptr), 0);
  EXPECT_EQ(coif_world_palette(nullptr, head), nullptr);
  coif_world_run_job(nullptr, 0);
  coif_world_finish_step(nullptr);
  create();
  EXPECT_EQ(add_asset(0, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_add_asset(world_, nullptr, 400, 0, &asset), COIF_ASSET_LACKS_DATA);
  EXPECT_EQ(coif_world_add_asset(world_, files_[0]->bytes().data(), 3, 0, &asset), COIF_ASSET_LACKS_DATA);
  EXPECT_EQ(coif_world_add_head(world_, asset, &pose, &head), COIF_BAD_INDEX);
  EXPECT_EQ(asset.generation + head.generation, 7 + before) << "no handle is written";
  ASSERT_EQ(add_asset(0, &asset), COIF_OK);
  EXPECT_EQ(coif_world_add_head(world_, asset, nullptr, &head), COIF_BAD_POSE);
  EXPECT_EQ(coif_world_add_head(world_, asset, &bent, &head), COIF_BAD_POSE);
  EXPECT_EQ(coif_world_add_head(world_, asset, &pose, nullptr), COIF_BAD_ARGUMENT);
  ASSERT_EQ(coif_world_add_head(world_, asset, &pose, &head), COIF_OK);
  EXPECT_EQ(coif_world_set_head(world_, head, nullptr), COIF_BAD_POSE);
  EXPECT_EQ(coif_world_set_moving_head(world_, head, &pose, nullptr), COIF_BAD_POSE);
  EXPECT_EQ(coif_world_set_detail(world_, head, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_step(world_, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_settle(world_, nullptr, 1, 1, &settings_), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_world_bone_ends(world_, head, nullptr, coif_world_bone_count(world_, head)), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_world_remove_asset(world_, asset), COIF_BAD_ARGUMENT) << "a head wears it";
  EXPECT_EQ(coif_world_remove_head(world_, head), COIF_OK);
  EXPECT_EQ(coif_world_has_head(world_, head), 0);
  EXPECT_EQ(coif_world_reset(world_, head, &pose), COIF_BAD_INDEX);
  EXPECT_EQ(coif_world_palette(world_, head), nullptr);
  EXPECT_EQ(coif_world_has_asset(world_, asset), 1);
  EXPECT_EQ(coif_world_remove_asset(world_, asset), COIF_OK);
  EXPECT_EQ(coif_world_remove_asset(world_, asset), COIF_BAD_INDEX);
  EXPECT_EQ(coif_world_step(world_, &settings_), COIF_OK) << "an empty world";
}

}  // namespace coif::c_world_test
