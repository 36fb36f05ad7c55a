// Everything that a host may tell a head of a world, whatever way its chains are kept: each head has the bits that it
// has alone.

#include "sim/hair_town.h"
#include "sim/linked_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace coif::world_features_test {

using hair_town::Kind;
using hair_town::memory_of;
using hair_town::opened;

/// A soft strand with levels of detail, and an arm beside it.
TestRig rig_with_arm(ChainModel model, int strands) {
  TestRig rig = hair_town::passive_strands(std::uint32_t(strands), 4, 90);
  rig.model = model;
  rig.levels = {0};
  for (int i = 0; i < strands; ++i) rig.levels.insert(rig.levels.end(), {3, 3, 2, 1});
  rig.body_bones.push_back({0, {0.3f, -0.1f, -0.1f}, {0, 0, 0.28f, 0.96f}});
  rig.add_body_sphere({0.05f, -0.1f, -0.15f}, 0.05f);
  return rig;
}

std::vector<AssetContents> kinds_on_characters() {
  std::vector<AssetContents> kinds;
  for (const TestRig& rig :
       {feature_rig(), nine_bone_rig(), rig_with_arm(ChainModel::kPassive, 3), rig_with_arm(ChainModel::kCascade, 5),
        links_test::sheet_rig(), links_test::sheet_rig({.model = ChainModel::kPassive, .strands = 3}),
        hair_town::limited_strands(), hair_town::passive_strands(2, 4, 90)}) {
    kinds.push_back(rig.contents());
  }
  return kinds;
}

/// What one head is told in one frame; both have functions of the same names.
class Teller {
 public:
  Teller(std::uint32_t head, int frame) : frame_(frame), head_(head) {}

  template <typename Told, typename Name>
  void tell(const Asset& asset, Told& hair, const Name& name) {
    const int when = frame_ + int(head_) * 5;
    const HeadPose pose = wander(when / 40 % 3 == 2 ? double(when / 40) : 0.02 * frame_ + head_);
    ASSERT_EQ(hair.set_head(name, pose), Status::kOk);
    if (when % 17 == 0) {
      const auto levels = std::uint32_t(asset.stored_lods().empty() ? 1 : asset.stored_lods().size());
      ASSERT_EQ(hair.set_detail(
                    name, {std::uint32_t(when) % levels, 1u << (when / 17 % 3), when % 34 != 0 || when % 51 == 0}),
                Status::kOk);
    }
    if (when % 23 == 0)
      ASSERT_EQ(hair.set_air(name, {{float(when % 5), 0, 1}, when % 2 == 0 ? 0.3f : 1.0f}), Status::kOk);
    if (when % 29 == 0) ASSERT_EQ(hair.choose_dynamics(name, std::uint32_t(when / 29) % 3), Status::kOk);
    if (when % 31 == 0) {
      Impulse blow{.radius = 0.4f, .speed = 3, .velocity = {0.5f, 1, 0}};
      for (int axis = 0; axis < 3; ++axis) blow.center[axis] = pose.position[axis];
      ASSERT_EQ(hair.push(name, blow), Status::kOk);
    }
    tell_colliders(asset, hair, name, pose, when);
    if (when / 30 % 2 == 1) ASSERT_EQ(hair.set_pose(name, animation(asset), std::vector{0.6f}), Status::kOk);
    if (when % 60 == 0) ASSERT_EQ(hair.set_pose(name, {}, {}), Status::kOk);
    if (when % 43 == 0) ASSERT_EQ(hair.teleport(name, wander(when)), Status::kOk);
    if (when % 71 == 0) ASSERT_EQ(hair.reset(name, wander(-when)), Status::kOk);
  }

 private:
  template <typename Told, typename Name>
  void tell_colliders(const Asset& asset, Told& hair, const Name& name, const HeadPose& pose, int when) {
    std::vector<MovingCollider> hands(std::size_t(when / 13 % 3));
    for (std::size_t i = 0; i < hands.size(); ++i) {
      hands[i].radius = 0.05f;
      for (int axis = 0; axis < 3; ++axis) hands[i].center[axis] = pose.position[axis];
      hands[i].center[2] -= 0.15;
      hands[i].center[0] += 0.2 * std::sin(0.3 * when + double(i));
    }
    ASSERT_EQ(hair.set_colliders(name, hands), Status::kOk);
    if (asset.body_colliders().empty()) return;
    BodyPose arm{.rotation = turned_about({0, 1, 0}, 0.02 * when)};
    for (int axis = 0; axis < 3; ++axis) arm.position[axis] = pose.position[axis] - 0.1;
    ASSERT_EQ(hair.set_body(name, std::vector{arm}), Status::kOk);
  }

  std::vector<Quat> animation(const Asset& asset) const {
    std::vector<Quat> rotations(asset.bones().size());
    for (std::size_t bone = 1; bone < rotations.size(); ++bone) {
      rotations[bone] = turned_about({0.6f, 0, 0.8f}, 0.3 * std::sin(0.05 * frame_ + 0.3 * double(bone)));
    }
    return rotations;
  }

  int frame_;
  std::uint32_t head_;
};

WorldDesc desc_of(const Solver& solver, InstructionSet set) {
  return {.assets = 8,
          .heads = 16,
          .hair_bytes = 24u << 20,
          .solver = &solver,
          .instruction_set = set,
          .longest_interval = 4,
          .dynamics_sets = 3,
          .links = &kCharacterLinks,
          .moving_colliders = 2,
          .follows_body = true,
          .follows_poses = true,
          .has_own_air = true,
          .feels_gusts = true};
}

/// A crowd of its own with the same features.
struct LoneHead {
  LoneHead(const Asset& asset, const WorldDesc& world)
      : desc{.instances = 1,
             .solver = world.solver,
             .longest_interval = world.longest_interval,
             .dynamics_sets = world.dynamics_sets,
             .links = world.links,
             .moving_colliders = world.moving_colliders,
             .follows_body = world.follows_body,
             .follows_poses = world.follows_poses,
             .has_own_air = world.has_own_air,
             .feels_gusts = world.feels_gusts},
        memory(memory_of(Hair::memory_need(asset, desc).bytes)) {
    EXPECT_EQ(hair.create(asset, desc, memory.bytes()), Status::kOk);
  }
  HairDesc desc;
  AlignedBytes memory;
  Hair hair;
};

/// Sixteen heads of all kinds; every other asset is said to be worn by a crowd.
class Street {
 public:
  Street(const WorldDesc& desc, bool has_crowds)
      : kinds_(opened(kinds_on_characters())), memory_(memory_of(HairWorld::memory_need(desc).bytes)) {
    EXPECT_EQ(world.create(desc, memory_.bytes()), Status::kOk);
    std::vector<WorldAsset> names(kinds_.size());
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
      const std::uint32_t crowd = has_crowds && kind % 2 == 0 ? 20 : 0;
      EXPECT_EQ(world.add_asset(kinds_[kind]->asset, names[kind], crowd), Status::kOk);
    }
    for (std::uint32_t i = 0; i < desc.heads; ++i) {
      kind_of.push_back(i % kinds_.size());
      heads.emplace_back();
      alone.push_back(std::make_unique<LoneHead>(asset(i), desc));
      EXPECT_EQ(world.add_head(names[kind_of[i]], wander(i), heads[i]), Status::kOk);
      EXPECT_EQ(alone[i]->hair.reset(0, wander(i)), Status::kOk);
    }
  }

  [[nodiscard]] const Asset& asset(std::size_t head) const { return kinds_[kind_of[head]]->asset; }

  void tell(int frame) {
    for (std::uint32_t i = 0; i < heads.size(); ++i) {
      Teller(i, frame).tell(asset(i), world, heads[i]);
      Teller(i, frame).tell(asset(i), alone[i]->hair, 0u);
    }
    if (frame % 40 == 10)
      tell_all([&](auto& hair) { return hair.set_gusts({.amplitude = frame % 80 == 10 ? 2.0f : 0.0f}); });
    if (frame % 33 == 5)
      tell_all([&](auto& hair) { return hair.set_dynamics(1, {.stiffness = 1 + float(frame % 3)}); });
  }

  void step(const StepSettings& settings, JobOrder order) {
    ASSERT_EQ(world.begin_step(settings), Status::kOk);
    hair_town::run_jobs(world, order);
    world.finish_step();
    for (const auto& one : alone) ASSERT_EQ(one->hair.step(settings), Status::kOk);
  }

  void settle(std::uint32_t head, const StepSettings& settings) {
    ASSERT_EQ(world.settle(std::vector{heads[head], heads[head]}, 0.3f, settings), Status::kOk);
    ASSERT_EQ(alone[head]->hair.settle(0, 0.3f, settings), Status::kOk);
  }

  /// Heads that are not to the bit as they are alone.
  [[nodiscard]] int strangers() const {
    int count = 0;
    for (std::size_t i = 0; i < heads.size(); ++i) {
      const auto here = world.palette(heads[i]), own = alone[i]->hair.palette(0);
      const bool is_same = here.size() == own.size() && std::memcmp(here.data(), own.data(), here.size_bytes()) == 0;
      std::vector<Vec3> ends(here.size()), own_ends(own.size());
      EXPECT_EQ(world.bone_ends(heads[i], ends), alone[i]->hair.bone_ends(0, own_ends));
      const bool ends_there = std::memcmp(ends.data(), own_ends.data(), ends.size() * sizeof(Vec3)) == 0;
      if (!(is_same && ends_there))
        std::printf("head %zu kind %zu same %d ends %d\n", i, kind_of[i], is_same, ends_there);
      if (world.is_asleep(heads[i]) != alone[i]->hair.is_asleep(0))
        std::printf("head %zu kind %zu sleep %d %d\n", i, kind_of[i], world.is_asleep(heads[i]),
                    alone[i]->hair.is_asleep(0));
      count += is_same && ends_there && world.is_asleep(heads[i]) == alone[i]->hair.is_asleep(0) ? 0 : 1;
    }
    return count;
  }

  [[nodiscard]] std::vector<Mat34> matrices() const {
    std::vector<Mat34> all;
    for (const WorldHead head : heads) all.insert(all.end(), world.palette(head).begin(), world.palette(head).end());
    return all;
  }

  HairWorld world;
  std::vector<WorldHead> heads;
  std::vector<std::size_t> kind_of;
  std::vector<std::unique_ptr<LoneHead>> alone;

 private:
  template <typename Call>
  void tell_all(const Call& call) {
    ASSERT_EQ(call(world), Status::kOk);
    for (const auto& one : alone) ASSERT_EQ(call(one->hair), Status::kOk);
  }

  std::vector<std::unique_ptr<Kind>> kinds_;
  AlignedBytes memory_;
};

StepSettings settings_of(int frame) {
  StepSettings settings{.dt = frame % 4 == 0 ? 1.0f / 60 : 0.012f + 0.001f * float(frame % 7)};
  if (frame % 37 == 36) settings.dt = 0;
  if (frame % 53 == 52) settings.dt = 0.7f;
  settings.inertia = frame / 20 % 3 == 1 ? 0.6f : 1.0f;
  settings.environment.wind = {frame / 50 % 2 == 1 ? 1.0f : 0.0f, 0, 0};
  settings.sleep_after = 0.05f;
  settings.sleep_speed = 1.5f;
  return settings;
}

void live(const Solver& solver, InstructionSet set, bool has_crowds, int frames) {
  constexpr JobOrder kOrders[] = {JobOrder::kAscending, JobOrder::kDescending, JobOrder::kTwoThreads};
  Street street(desc_of(solver, set), has_crowds);
  int asleep = 0;
  for (int frame = 1; frame <= frames; ++frame) {
    const StepSettings settings = settings_of(frame);
    street.tell(frame);
    if (frame % 19 == 0) street.settle(std::uint32_t(frame) % 16, settings);
    street.step(settings, kOrders[frame % 3]);
    ASSERT_EQ(street.strangers(), 0) << "frame " << frame << (has_crowds ? " with crowds" : "");
    for (const WorldHead head : street.heads) asleep += street.world.is_asleep(head) ? 1 : 0;
  }
  EXPECT_GT(asleep, frames / 4) << "or sleep was not tried";
}

TEST(WorldFeatures, EachHeadHasTheBitsThatItHasAlone) {
  for (const bool has_crowds : {false, true}) live(kCharacterSolver, InstructionSet::kBest, has_crowds, 300);
}

TEST(WorldFeatures, SoItHasOnEveryInstructionSet) {
  for (const InstructionSet set : runnable_sets()) live(kCharacterSolver, set, false, 100);
}

TEST(WorldFeatures, SoItHasUnderTheCascadeAlone) { live(kCharacterCascadeSolver, InstructionSet::kBest, true, 80); }

/// A game goes back to an earlier frame and plays it again.
TEST(WorldFeatures, ARestoredWorldGoesOnWithTheSameBits) {
  for (const bool has_crowds : {false, true}) {
    Street street(desc_of(kCharacterSolver, InstructionSet::kBest), has_crowds);
    const auto play = [&](int from, int to) {
      for (int frame = from; frame < to; ++frame) {
        for (std::uint32_t i = 0; i < street.heads.size(); ++i) {
          Teller(i, frame).tell(street.asset(i), street.world, street.heads[i]);
        }
        ASSERT_EQ(street.world.step(settings_of(frame)), Status::kOk);
      }
    };
    play(1, 40);
    std::vector<std::byte> saved(street.world.saved_bytes()), again(saved.size());
    ASSERT_EQ(street.world.save(saved), Status::kOk);
    play(40, 90);
    const std::vector<Mat34> first = street.matrices();
    ASSERT_EQ(street.world.restore(saved), Status::kOk);
    ASSERT_EQ(street.world.save(again), Status::kOk);
    EXPECT_TRUE(saved == again) << "what was restored is saved in the same way";
    play(40, 90);
    const std::vector<Mat34> second = street.matrices();
    EXPECT_EQ(std::memcmp(first.data(), second.data(), first.size() * sizeof(Mat34)), 0);
    // A state says which heads it is of.
    ASSERT_EQ(street.world.remove_head(street.heads.back()), Status::kOk);
    EXPECT_EQ(street.world.restore(saved), Status::kForeignState);
    EXPECT_LT(street.world.saved_bytes(), saved.size());
  }
}

/// Where an asset's heads share their lanes with those of others, and where they do not.
TEST(WorldFeatures, AsksForWhatTheDescriptionLacks) {
  const auto kinds = opened({nine_bone_rig().contents()});
  AlignedBytes memory = memory_of(HairWorld::memory_need({}).bytes);
  HairWorld world;
  ASSERT_EQ(world.create({}, memory.bytes()), Status::kOk);
  WorldAsset asset;
  WorldHead head;
  ASSERT_EQ(world.add_asset(kinds[0]->asset, asset), Status::kOk);
  ASSERT_EQ(world.add_head(asset, {}, head), Status::kOk);
  EXPECT_EQ(world.set_air(head, {}), Status::kNotAsked);
  EXPECT_EQ(world.set_gusts({}), Status::kNotAsked);
  EXPECT_EQ(world.set_pose(head, {}, {}), Status::kNotAsked);
  EXPECT_EQ(world.set_body(head, {}), Status::kNotAsked);
  EXPECT_EQ(world.set_colliders(head, std::vector<MovingCollider>(1)), Status::kNotAsked);
  EXPECT_EQ(world.set_colliders(head, {}), Status::kOk);
  EXPECT_EQ(world.choose_dynamics(head, 1), Status::kNotAsked);
  EXPECT_EQ(world.set_dynamics(0, {}), Status::kNotAsked);
  EXPECT_EQ(world.set_detail(head, {.interval = 2}), Status::kBadArgument);
  ASSERT_EQ(world.remove_head(head), Status::kOk);
  EXPECT_EQ(world.set_air(head, {}), Status::kBadIndex);
  EXPECT_EQ(world.push(head, {}), Status::kBadIndex);
  EXPECT_EQ(world.settle(std::vector{head}, 1, {}), Status::kBadIndex);
}

}  // namespace coif::world_features_test
