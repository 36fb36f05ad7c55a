// Saved bytes that were changed and hashed anew: restore() takes what a crowd could have saved, and nothing else.

#include "models/playback.h"
#include "models/test_rig.h"
#include "sim/saved_bytes.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <string>
#include <vector>

namespace coif::damaged_state_test {

using Bytes = SavedState;

constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// Everything that moves in a crowd: bones that twist and such that fork, colliders of the game and of a body, poses,
/// gusts.
TestRig rig() {
  TestRig rig = nine_bone_rig();
  for (std::size_t i = 1; i < rig.dynamics.size(); ++i) rig.dynamics[i].torsion = i % 2 == 0 ? 4.0f : kShortestArc;
  rig.body_bones.push_back({0, {0, -0.3f, 0}, {0, 0, 0, 1}});
  rig.add_body_sphere({0, -0.3f, 0}, 0.05f);
  return rig;
}

std::vector<HairDesc> crowds() {
  std::vector<HairDesc> all;
  for (const Solver* const solver : {&kCascadeSolver, &kPassiveSolver, &kThesisSolver}) {
    for (const std::uint32_t heads : {1u, 2u}) {  // chains beside each other, and heads
      all.push_back({.instances = heads, .solver = solver, .longest_interval = 4, .dynamics_sets = heads});
    }
  }
  for (const Solver* const solver : {&kCharacterSolver, &kCharacterCascadeSolver}) {
    all.push_back({.instances = 2,
                   .solver = solver,
                   .dynamics_sets = 2,
                   .moving_colliders = 2,
                   .follows_body = true,
                   .follows_poses = true,
                   .has_own_air = true,
                   .feels_gusts = true});
  }
  return all;
}

void tell_all(Hair& hair, std::uint32_t head, double t) {
  MovingCollider hand{.center = {0.1 * std::sin(4 * t), -0.05, -0.13}};
  hand.radius = 0.03f;
  hand.velocity.linear.x = kNaN;  // not known, and so not read
  const BodyPose arm{{0, -0.3, 0.1 * t}, {}};
  const std::vector<Quat> pose(hair.bone_count(), turned_about({1, 0, 0}, 0.3 * std::sin(t)));
  const float weight = 0.5f;
  ASSERT_EQ(hair.set_colliders(head, {&hand, 1}), Status::kOk);
  ASSERT_EQ(hair.set_body(head, {&arm, 1}), Status::kOk);
  if (head == 1) {
    ASSERT_EQ(hair.set_pose(head, pose, {&weight, 1}), Status::kOk);
  }
  ASSERT_EQ(hair.set_air(head, {.wind = {1, 0, 0}, .exposure = 0.5f}), Status::kOk);
  ASSERT_EQ(hair.set_gusts({.amplitude = 2}), Status::kOk);
}

void run(TestHair& test, const HairDesc& desc, int first, int count) {
  for (int frame = first; frame < first + count; ++frame) {
    for (std::uint32_t i = 0; i < desc.instances; ++i) {
      const double t = frame / 60.0 + i;
      const HeadVelocity velocity{{1, 0, 0}, {0, 1, 0}};
      ASSERT_EQ(i == 1 ? test.hair.set_head(i, wander(t), velocity) : test.hair.set_head(i, wander(t)), Status::kOk);
      if (desc.feels_gusts) tell_all(test.hair, i, t);
    }
    ASSERT_EQ(test.hair.step({}), Status::kOk);
  }
}

bool are_finite(const Hair& hair) {
  for (std::uint32_t i = 0; i < hair.instance_count(); ++i) {
    for (const Mat34& matrix : hair.palette(i)) {
      for (const auto& row : matrix.m) {
        for (const float number : row) {
          if (!std::isfinite(number)) return false;
        }
      }
    }
  }
  return true;
}

/// Restores damaged bytes into a crowd, looks what became of it, and makes it whole again.
class Victim {
 public:
  explicit Victim(const HairDesc& desc) : test_(rig(), desc) {
    run(test_, desc, 40, 9);
    own_ = saved(test_.hair);
  }

  /// True where the crowd took them.
  bool takes(Bytes bytes) {
    hash_anew(bytes);
    const Status status = test_.hair.restore(bytes);
    if (status != Status::kOk) {
      EXPECT_EQ(status, Status::kDamagedState);
      EXPECT_TRUE(saved(test_.hair) == own_) << "it stays as it is";
      return false;
    }
    EXPECT_TRUE(saved(test_.hair) == bytes) << "what was taken is saved again";
    EXPECT_TRUE(are_finite(test_.hair));
    for (int frame = 0; frame < 3; ++frame) {
      EXPECT_EQ(test_.hair.step({}), Status::kOk);
      EXPECT_TRUE(are_finite(test_.hair)) << frame;
    }
    EXPECT_EQ(test_.hair.restore(own_), Status::kOk);
    return true;
  }

 private:
  TestHair test_;
  Bytes own_;
};

/// What a crowd of this kind saved, and another one to restore it into.
struct Damage {
  explicit Damage(const HairDesc& desc, int frames = 30) : victim(desc) {
    TestHair source(rig(), desc);
    run(source, desc, 0, frames);
    good = saved(source.hair);
  }

  Bytes good;
  Victim victim;
};

/// So many bytes of ones reach the upper half of a float or of a double, wherever they begin: one number there is none.
constexpr std::size_t kOnes = 9;

TEST(DamagedState, WhereSomeNumberIsNoneItIsRefused) {
  for (const HairDesc& desc : crowds()) {
    auto [good, victim] = Damage(desc);
    ASSERT_TRUE(victim.takes(good));
    std::size_t taken = 0;
    std::string where;
    for (std::size_t at = kContentAt; at + kOnes <= good.size() && !HasFailure(); ++at) {
      Bytes bad = good;
      std::memset(&bad[at], 0xFF, kOnes);
      const bool is_taken = victim.takes(bad);
      taken += is_taken ? 1 : 0;
      where += is_taken ? ' ' + std::to_string(at - kContentAt) : "";
    }
    // Any bits do in what a host writes into HeadPose::reserved and where a head with a velocity is, which is not in
    // its pose.
    EXPECT_LE(taken, 3 * desc.instances) << "heads " << desc.instances << ", bytes" << where << " of "
                                         << good.size() - kContentAt;
  }
}

TEST(DamagedState, WhateverIsChangedItIsRefusedOrAStateLikeAnyOther) {
  for (const HairDesc& desc : crowds()) {
    auto [good, victim] = Damage(desc);
    std::size_t taken = 0, tried = 0;
    for (std::size_t at = kContentAt; at < good.size() && !HasFailure(); ++at) {
      for (const std::byte change : {std::byte{0x01}, std::byte{0x10}, std::byte{0x80}}) {
        Bytes bad = good;
        bad[at] ^= change;
        ++tried;
        taken += victim.takes(bad) ? 1 : 0;
      }
    }
    EXPECT_LT(taken, tried * 9 / 10);
    EXPECT_GT(taken, tried / 10) << "velocities may be any";
  }
}

TEST(DamagedState, PartsThatDoNotBelongTogetherAreRefused) {
  HairDesc desc = crowds().back();
  auto [good, victim] = Damage(desc);
  std::size_t taken = 0, tried = 0;
  Violence random(5);
  for (int i = 0; i < 3000 && !HasFailure(); ++i) {  // words that stand where others belong
    const std::size_t words = (good.size() - kContentAt) / 4;
    const auto from = kContentAt + 4 * std::size_t(random.between(0, double(words))),
               to = kContentAt + 4 * std::size_t(random.between(0, double(words)));
    if (std::memcmp(&good[from], &good[to], 4) == 0) continue;
    Bytes bad = good;
    std::memcpy(&bad[to], &good[from], 4);
    ++tried;
    taken += victim.takes(bad) ? 1 : 0;
  }
  EXPECT_GT(tried, 1000u);
  EXPECT_LT(taken, tried * 2 / 5);
}

/// The last digit of where a head goes, or of where it was told to be.
TEST(DamagedState, AHeadGoesNowhereButWhereItWasTold) {
  TestHair test(rig(), {.instances = 2});
  const double place = 123.456;
  ASSERT_EQ(test.hair.set_head(1, {{0, place, 0}, {}}), Status::kOk);
  const Bytes good = saved(test.hair);
  Victim victim({.instances = 2});
  int found = 0;
  for (std::size_t at = kContentAt; at + sizeof place <= good.size(); ++at) {
    if (std::memcmp(&good[at], &place, sizeof place) != 0) continue;
    ++found;
    Bytes bad = good;
    bad[at] ^= std::byte{1};
    EXPECT_FALSE(victim.takes(bad)) << found;
  }
  EXPECT_EQ(found, 2);
}

TEST(DamagedState, OfBytesFromNowhereNoneAreTaken) {
  for (const HairDesc& desc : crowds()) {
    auto [bytes, victim] = Damage(desc, 5);
    Violence random(1);
    for (int i = 0; i < 50; ++i) {
      for (std::size_t at = kContentAt; at < bytes.size(); ++at) bytes[at] = std::byte(random.between(0, 256));
      EXPECT_FALSE(victim.takes(bytes));
    }
  }
}

/// What hosts may do is no damage: each state here was saved by a crowd.
TEST(DamagedState, WhatACrowdSavedIsNeverRefused) {
  for (const HairDesc& desc : crowds()) {
    TestHair test(rig(), desc), other(rig(), desc);
    for (int frame = 0; frame < 900; ++frame) {
      const auto head = std::uint32_t(frame) % desc.instances;
      HeadPose pose = wander(frame < 600 ? frame / 60.0 : 10);
      pose.scale = frame < 200 ? 1.0f : 1.5f;
      if (frame == 100) pose.position[0] = 1e200;  // lost
      if (frame % 90 == 50) {
        ASSERT_EQ(test.hair.teleport(head, pose), Status::kOk);
      } else if (frame % 7 == 3 && frame < 600) {
        ASSERT_EQ(test.hair.set_head(head, pose, {{1, 0, 0}, {0, 1e3f, 0}}), Status::kOk);
      } else {
        ASSERT_EQ(test.hair.set_head(head, pose), Status::kOk);
      }
      if (frame % 60 == 7) {
        ASSERT_EQ(test.hair.push(head, {.radius = 3, .speed = frame == 67 ? 3e38f : 5.0f}), Status::kOk);
      }
      if (desc.feels_gusts && frame < 600) tell_all(test.hair, head, frame / 60.0);
      if (desc.feels_gusts && frame == 600) {
        ASSERT_EQ(test.hair.set_gusts({}), Status::kOk);
        for (std::uint32_t i = 0; i < desc.instances; ++i) ASSERT_EQ(test.hair.set_pose(i, {}, {}), Status::kOk);
      }
      if (frame % 50 == 20 && desc.longest_interval > 1) {
        const Detail detail{.interval = frame % 100 == 20 ? 4u : 1u, .simulated = frame % 150 != 20};
        ASSERT_EQ(test.hair.set_detail(head, detail), Status::kOk);
      }
      if (frame % 40 == 39) {
        ASSERT_EQ(test.hair.settle(head, 0.1f, {}), Status::kOk);
      }
      const Bytes before = saved(test.hair);  // told, and not stepped
      ASSERT_EQ(other.hair.restore(before), Status::kOk) << frame << ", heads " << desc.instances;
      ASSERT_TRUE(saved(other.hair) == before) << frame;
      const float dt = frame % 50 == 49 ? 0.7f : frame % 11 == 10 ? 0.0f : 1.0f / 60;
      ASSERT_EQ(test.hair.step({.dt = dt, .sleep_speed = 1e-2f}), Status::kOk);
      const Bytes after = saved(test.hair);
      ASSERT_EQ(other.hair.restore(after), Status::kOk) << frame << ", heads " << desc.instances;
      ASSERT_TRUE(saved(other.hair) == after) << frame;
    }
  }
}

}  // namespace coif::damaged_state_test
