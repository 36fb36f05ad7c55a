// A crowd's state as bytes: going back to it is as if nothing had been since.

#include "models/playback.h"
#include "models/test_rig.h"

#include <coif/hair.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <vector>

namespace coif::saved_state_test {

using Bytes = std::vector<std::byte>;
using Palettes = std::vector<Mat34>;

TestRig rig_with_levels() {
  TestRig rig = nine_bone_rig();
  rig.levels = {0, 4, 3, 1, 4, 3, 1, 4, 3, 1};
  return rig;
}

Bytes saved(const TestHair& test) {
  Bytes bytes(test.hair.saved_bytes());
  EXPECT_EQ(test.hair.save(bytes), Status::kOk);
  return bytes;
}

/// Heads that walk, stand, jump, sleep, are seen from near and far and not at all.
void run(TestHair& test, int first, int count, std::uint32_t longest_interval = 1) {
  for (int frame = first; frame < first + count; ++frame) {
    for (std::uint32_t i = 0; i < test.hair.instance_count(); ++i) {
      const double t = frame / 60.0 + i, stands = i % 3 == 2 ? 0 : 1;
      const HeadPose pose{{stands * std::sin(t) + i, 1.6 + stands * 0.1 * std::sin(3 * t), 0}, {}};
      ASSERT_EQ(frame % 50 == 49 && stands > 0 ? test.hair.teleport(i, pose) : test.hair.set_head(i, pose),
                Status::kOk);
      if (frame % 20 == 10) {
        const auto turn = std::uint32_t(frame / 20) + i;
        const std::uint32_t interval = longest_interval > 1 && turn % 2 == 0 ? longest_interval : 1;
        ASSERT_EQ(test.hair.set_detail(i, {.level = turn % 3, .interval = interval, .simulated = turn % 5 != 0}),
                  Status::kOk);
      }
    }
    ASSERT_EQ(test.hair.step({.dt = frame % 7 == 0 ? 1.0f / 30 : 1.0f / 60}), Status::kOk);
  }
}

Palettes palettes_of(const TestHair& test) {
  Palettes all;
  for (std::uint32_t i = 0; i < test.hair.instance_count(); ++i) {
    all.insert(all.end(), test.hair.palette(i).begin(), test.hair.palette(i).end());
  }
  return all;
}

bool same(const Palettes& a, const Palettes& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(Mat34)) == 0;
}

std::vector<HairDesc> crowds() {
  std::vector<HairDesc> all;
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    for (const std::uint32_t heads : {1u, 5u, 40u})
      all.push_back({.instances = heads, .solver = solver, .longest_interval = 4});
  }
  return all;
}

TEST(SavedState, IsGoneBackToAsIfNothingHadBeenSince) {
  for (const HairDesc& desc : crowds()) {
    TestHair test(rig_with_levels(), desc);
    run(test, 0, 133, 4);
    const HeadPose far{{30, 0, 0}, {}}, near{{0.3, 1.6, 0}, {}};  // told, and not stepped yet
    ASSERT_EQ(test.hair.teleport(0, far), Status::kOk);
    ASSERT_EQ(test.hair.set_head(desc.instances - 1, near, {{1, 0, 0}, {}}), Status::kOk);
    const Bytes then = saved(test);
    const auto go_on = [&] {
      ASSERT_EQ(test.hair.step({.teleport_distance = 1000}), Status::kOk);
      run(test, 133, 100, 4);
    };
    go_on();
    const Palettes after = palettes_of(test);
    ASSERT_EQ(test.hair.restore(then), Status::kOk);
    EXPECT_TRUE(saved(test) == then) << "the same state has the same bytes";
    go_on();
    EXPECT_TRUE(same(palettes_of(test), after)) << desc.instances << " heads";
  }
}

TEST(SavedState, GoesOnToTheSameBitsUnderEveryInstructionSet) {
  for (HairDesc desc : crowds()) {
    TestHair here(rig_with_levels(), desc);
    run(here, 0, 77, 4);
    const Bytes bytes = saved(here);
    run(here, 77, 60, 4);
    for (const InstructionSet set :
         {InstructionSet::kScalar, InstructionSet::kSse4, InstructionSet::kAvx2, InstructionSet::kAvx512}) {
      if (!can_run(set)) continue;
      desc.instruction_set = set;
      TestHair there(rig_with_levels(), desc);
      run(there, 0, 5, 4);  // whatever it did before
      ASSERT_EQ(there.hair.restore(bytes), Status::kOk);
      run(there, 77, 60, 4);
      EXPECT_TRUE(same(palettes_of(there), palettes_of(here))) << int(set);
      EXPECT_TRUE(saved(there) == saved(here)) << int(set);
    }
  }
}

TEST(SavedState, KeepsWhoSleeps) {
  TestHair test(nine_bone_rig(), {.instances = 20});
  for (int frame = 0; frame < 1200; ++frame) ASSERT_EQ(test.hair.step({}), Status::kOk);
  ASSERT_TRUE(test.hair.is_asleep(7));
  ASSERT_EQ(test.hair.set_head(7, {{0, 0.1, 0}, {}}), Status::kOk);
  const Bytes bytes = saved(test);
  TestHair other(nine_bone_rig(), {.instances = 20});
  ASSERT_EQ(other.hair.restore(bytes), Status::kOk);
  for (std::uint32_t i = 0; i < 20; ++i) EXPECT_EQ(other.hair.is_asleep(i), i != 7) << i;
  ASSERT_EQ(test.hair.step({}), Status::kOk);
  ASSERT_EQ(other.hair.step({}), Status::kOk);
  EXPECT_TRUE(same(palettes_of(other), palettes_of(test)));
}

TEST(SavedState, ThatIsDamagedIsRefusedAndNothingChanges) {
  TestHair test(rig_with_levels(), {.instances = 3}), untouched(rig_with_levels(), {.instances = 3});
  run(test, 0, 30);
  run(untouched, 0, 30);
  TestHair source(rig_with_levels(), {.instances = 3});
  run(source, 0, 90);
  const Bytes good = saved(source);
  for (std::size_t at = 0; at < good.size(); at += at < 200 ? 1 : 37) {
    Bytes bad = good;
    bad[at] ^= std::byte{0x10};
    const Status status = test.hair.restore(bad);
    EXPECT_TRUE(status == Status::kDamagedState || status == Status::kForeignState) << at;
  }
  for (const std::size_t size : {std::size_t{0}, std::size_t{7}, std::size_t{31}, good.size() - 1}) {
    EXPECT_EQ(test.hair.restore(std::span(good).first(size)), Status::kDamagedState) << size;
  }
  Bytes longer = good;
  longer.push_back({});
  EXPECT_EQ(test.hair.restore(longer), Status::kDamagedState);
  run(test, 30, 40);
  run(untouched, 30, 40);
  EXPECT_TRUE(same(palettes_of(test), palettes_of(untouched)));
}

TEST(SavedState, OfAnotherCrowdIsForeign) {
  TestHair test(nine_bone_rig(), {.instances = 3});
  TestRig stiffer = nine_bone_rig();
  stiffer.dynamics[2].stiffness *= 2;
  const TestHair others[] = {TestHair(nine_bone_rig(), {.instances = 4}), TestHair(stiffer, {.instances = 3}),
                             TestHair(rig_with_levels(), {.instances = 3}),
                             TestHair(nine_bone_rig(), {.instances = 3, .solver = &kPassiveSolver}),
                             TestHair(nine_bone_rig(), {.instances = 3, .solver = &kThesisSolver})};
  for (const TestHair& other : others) EXPECT_EQ(test.hair.restore(saved(other)), Status::kForeignState);
}

TEST(SavedState, NeedsExactlyItsRoom) {
  TestHair test(nine_bone_rig(), {.instances = 2});
  Bytes bytes(test.hair.saved_bytes() + 1);
  EXPECT_EQ(test.hair.save(bytes), Status::kSizeMismatch);
  EXPECT_EQ(test.hair.save(std::span(bytes).first(bytes.size() - 2)), Status::kSizeMismatch);
  EXPECT_EQ(Hair().saved_bytes(), 0u);
  EXPECT_EQ(Hair().save({}), Status::kNotCreated);
  EXPECT_EQ(Hair().restore({}), Status::kNotCreated);
}

/// Hair on a character: a hand strokes it, a pose fades in and out.
void act(TestHair& test, int first, int count) {
  for (int frame = first; frame < first + count; ++frame) {
    for (std::uint32_t i = 0; i < test.hair.instance_count(); ++i) {
      const double t = frame / 60.0 + 0.3 * i;
      MovingCollider hand{.center = {0.15 * std::sin(4 * t), -0.05, -0.13}};
      hand.radius = 0.03f;
      const MovingCollider two[] = {hand, hand};
      ASSERT_EQ(test.hair.set_colliders(i, std::span(two).first(std::size_t(frame / 20) % 3)), Status::kOk);
      const std::vector<Quat> pose(test.hair.bone_count(), turned_about({1, 0, 0}, 0.3 * std::sin(t)));
      const float weight[] = {frame % 40 < 20 ? 0.5f : 1.0f};
      const bool follows = frame % 60 < 50;
      const Status told = follows ? test.hair.set_pose(i, pose, weight) : test.hair.set_pose(i, {}, {});
      ASSERT_EQ(told, Status::kOk);
    }
    ASSERT_EQ(test.hair.step({}), Status::kOk);
  }
}

TEST(SavedState, OfHairOnACharacterHoldsItsCollidersAndPoses) {
  HairDesc desc{.instances = 5, .solver = &kCharacterSolver, .moving_colliders = 2, .follows_poses = true};
  for (const int until : {30, 55, 71}) {
    desc.instruction_set = plainest_set();
    TestHair test(nine_bone_rig(), desc);
    act(test, 0, until);
    const Bytes state = saved(test);
    for (const InstructionSet set : runnable_sets()) {
      desc.instruction_set = set;
      TestHair other(nine_bone_rig(), desc);
      act(other, 3, 10);  // whatever it was before
      ASSERT_EQ(other.hair.restore(state), Status::kOk);
      EXPECT_EQ(saved(other), state) << name_of(set);
      TestHair straight(nine_bone_rig(), desc);
      act(straight, 0, until + 40);
      act(other, until, 40);
      EXPECT_TRUE(same(palettes_of(other), palettes_of(straight))) << name_of(set) << ' ' << until;
    }
  }
  TestHair plain(nine_bone_rig(), HairDesc{.instances = 5});
  EXPECT_EQ(plain.hair.restore(saved(TestHair(nine_bone_rig(), desc))), Status::kForeignState);
}

}  // namespace coif::saved_state_test
