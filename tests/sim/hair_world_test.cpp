// Heads of many assets that come and go: each has the bits that it has alone.

#include "sim/hair_town.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace coif::hair_world_test {

using namespace hair_town;

/// Frames of all lengths, none and too long among them; wind and stiffness change now and then.
StepSettings settings_of(int frame, Violence& random) {
  StepSettings settings{.dt = float(random.between(0.012, 0.04))};
  if (frame % 4 == 0) settings.dt = 1.0f / 60;
  if (frame % 23 == 22) settings.dt = 0;
  if (frame % 41 == 40) settings.dt = 0.8f;
  if (frame % 31 == 30) settings.dt = 0.2f;
  settings.substeps = frame / 16 % 3 == 1 ? 2 : 0;
  settings.inertia = frame / 20 % 3 == 1 ? 0.6f : 1.0f;
  settings.environment.air_follow = 0.7f;
  if (frame / 60 % 2 == 1) settings.environment.wind = {2, 0, -1};
  if (frame / 45 % 2 == 1) settings.dynamics.stiffness = 2;
  settings.sleep_after = 0.05f;
  settings.sleep_speed = 1.5f;
  return settings;
}

struct Order {
  enum class What : std::uint8_t { kSet, kSetWithVelocity, kTeleport, kReset } what = What::kSet;
  HeadPose pose;
  HeadVelocity velocity;
};

/// What a head is told in a frame: mostly it wanders or stands.
Order order_of(std::uint32_t index, int frame, Violence& random) {
  const std::uint32_t when = std::uint32_t(frame) + index * 5;
  Order order;
  order.pose = wander(when / 12 % 3 == 0 ? double(when / 36) : 0.02 * frame + index);
  if (when % 47 == 46) order = {Order::What::kTeleport, random.next(), {}};
  if (when % 61 == 60) order = {Order::What::kReset, random.next(), {}};
  if (when % 53 == 52) order.pose = random.next();
  if (when % 67 == 66) order.pose.position[0] = 1e17;  // too far for anything
  if (when % 13 == 12) order.what = Order::What::kSetWithVelocity;
  order.velocity = {{0.1f, -0.2f, 0.3f}, {0.5f, 0, -1}};
  return order;
}

void give(const Order& order, HairWorld& world, WorldHead head, Hair& twin) {
  switch (order.what) {
    case Order::What::kSet: EXPECT_EQ(world.set_head(head, order.pose), twin.set_head(0, order.pose)); break;
    case Order::What::kSetWithVelocity:
      EXPECT_EQ(world.set_head(head, order.pose, order.velocity), twin.set_head(0, order.pose, order.velocity));
      break;
    case Order::What::kTeleport: EXPECT_EQ(world.teleport(head, order.pose), twin.teleport(0, order.pose)); break;
    case Order::What::kReset: EXPECT_EQ(world.reset(head, order.pose), twin.reset(0, order.pose)); break;
  }
}

/// Assets are said to be worn by few heads, by some and by many.
constexpr std::uint32_t kCrowds[] = {0, 2, 40};

/// Assets and heads come and go, more of them come than go for a while, then the other way around.
void move_about(Town& town, std::size_t kinds, int frame, std::mt19937& lot) {
  const auto one_of = [&](std::size_t count) { return std::size_t(lot() % count); };
  for (int i = 0; i < 3; ++i) {
    const std::size_t kind = one_of(kinds);
    const bool grows = frame / 40 % 2 == 0 ? lot() % 4 != 0 : lot() % 4 == 0;
    if (grows) {
      EXPECT_EQ(town.is_here(kind) ? Status::kOk : town.come(kind, kCrowds[lot() % 3]), Status::kOk);
      EXPECT_EQ(town.move_in(kind, wander(0.1 * frame)), Status::kOk);
    }
    if (grows || town.residents.empty()) continue;
    town.move_out(one_of(town.residents.size()));
    const Status left = town.leave(kind);
    EXPECT_TRUE(town.heads_of(kind) == 0 || left == Status::kBadArgument);
  }
}

void live(const Solver& solver, InstructionSet set, int frames, std::uint32_t seed) {
  const auto kinds = opened(many_kinds());
  Town town(kinds, {.assets = std::uint32_t(kinds.size()),
                    .heads = 300,
                    .hair_bytes = 64u << 20,
                    .solver = &solver,
                    .instruction_set = set});
  Violence random(seed);
  std::mt19937 lot(seed);
  constexpr JobOrder kOrders[] = {JobOrder::kAscending, JobOrder::kDescending, JobOrder::kTwoThreads};
  int asleep = 0, awake = 0;
  for (int frame = 0; frame < frames; ++frame) {
    move_about(town, kinds.size(), frame, lot);
    for (std::size_t i = 0; i < town.residents.size(); ++i) {
      const Resident& one = town.residents[i];
      give(order_of(one.head.index, frame, random), town.world, one.head, one.twin->hair);
    }
    town.step(settings_of(frame, random), kOrders[frame % 3]);
    ASSERT_EQ(town.strangers(), 0) << "frame " << frame << " of " << town.residents.size() << " heads";
    for (const Resident& one : town.residents) (town.world.is_asleep(one.head) ? asleep : awake) += 1;
  }
  EXPECT_GT(awake, 10 * frames) << "or few heads were ever there";
  EXPECT_GT(asleep, frames) << "or sleep was not tried";
}

TEST(HairWorld, EachHeadHasTheBitsThatItHasAlone) {
  for (const InstructionSet set : runnable_sets()) live(kCoifSolver, set, 100, 5);
}

TEST(HairWorld, SoItHasUnderTheOtherSolvers) {
  live(kCascadeSolver, InstructionSet::kBest, 100, 6);
  live(kPassiveSolver, InstructionSet::kBest, 60, 7);
}

TEST(HairWorld, SoItHasWhereAChainMovesBeforeItsFirstStep) {
  // More heads than a bundle has lanes; the last one, of an asset that has not been stepped yet, takes the place of one
  // that leaves.
  std::vector<AssetContents> contents;
  for (const float stiffness : {50.0f, 90.0f}) {
    TestRig rig;
    rig.add_strand(3, {.rest_direction = {0, -0.8f, -0.6f}, .length = 0.1f, .stiffness = stiffness, .damping = 4});
    contents.push_back(rig.contents());
  }
  const auto kinds = opened(contents);
  Town town(kinds, {.assets = 2, .heads = 20});
  ASSERT_EQ(town.come(0), Status::kOk);
  for (int i = 0; i < 17; ++i) ASSERT_EQ(town.move_in(0, {}), Status::kOk);
  town.step({});
  ASSERT_EQ(town.come(1), Status::kOk);
  ASSERT_EQ(town.move_in(1, {}), Status::kOk);
  town.move_out(0);
  for (int frame = 0; frame < 3; ++frame) town.step({});
  EXPECT_EQ(town.strangers(), 0);
}

/// A head that sleeps and is put where it stands has to be seen to again, in a world as in a crowd.
TEST(HairWorld, ResetAndTeleportWakeAHeadThatStandsThereAlready) {
  const auto kinds = opened({nine_bone_rig().contents()});
  Town town(kinds, {.assets = 1, .heads = 1});
  ASSERT_EQ(town.come(0), Status::kOk);
  ASSERT_EQ(town.move_in(0, {}), Status::kOk);
  const WorldHead head = town.residents[0].head;
  Hair& twin = town.residents[0].twin->hair;
  for (const bool resets : {false, true}) {
    for (int frame = 0; frame < 900 && !town.world.is_asleep(head); ++frame) town.step({});
    ASSERT_TRUE(town.world.is_asleep(head) && twin.is_asleep(0));
    ASSERT_EQ(town.world.set_head(head, {}), Status::kOk);
    ASSERT_EQ(twin.set_head(0, {}), Status::kOk);
    EXPECT_TRUE(town.world.is_asleep(head) && twin.is_asleep(0)) << "nothing new";
    ASSERT_EQ(resets ? town.world.reset(head, {}) : town.world.teleport(head, {}), Status::kOk);
    ASSERT_EQ(resets ? twin.reset(0, {}) : twin.teleport(0, {}), Status::kOk);
    EXPECT_FALSE(town.world.is_asleep(head) || twin.is_asleep(0)) << resets;
    town.step({});
    EXPECT_EQ(town.strangers(), 0);
  }
}

TEST(HairWorld, AHeadWithoutChainsSettlesAsOthersDo) {
  const auto kinds = opened({TestRig().contents()});
  Town town(kinds, {.assets = 1, .heads = 1});
  ASSERT_EQ(town.come(0), Status::kOk);
  ASSERT_EQ(town.move_in(0, {}), Status::kOk);
  town.step({});
  const Resident& one = town.residents[0];
  ASSERT_EQ(town.world.settle(std::vector{one.head}, 2, {}), Status::kOk);
  ASSERT_EQ(one.twin->hair.settle(0, 2, {}), Status::kOk);
  EXPECT_TRUE(town.world.is_asleep(one.head));
  EXPECT_EQ(town.strangers(), 0);
}

/// Without hair that shows it.
TEST(HairWorld, AHeadWhoseNumbersOverflowIsPutToRest) {
  const auto kinds = opened({TestRig().contents()});
  Town town(kinds, {.assets = 1, .heads = 1});
  ASSERT_EQ(town.come(0), Status::kOk);
  ASSERT_EQ(town.move_in(0, {}), Status::kOk);
  const WorldHead head = town.residents[0].head;
  ASSERT_EQ(town.world.teleport(head, {}), Status::kOk);
  ASSERT_EQ(town.world.set_head(head, {}, {{}, {0, std::numeric_limits<float>::max(), 0}}), Status::kOk);
  ASSERT_EQ(town.world.step({}), Status::kOk);
  std::vector<std::byte> saved(town.world.saved_bytes());
  ASSERT_EQ(town.world.save(saved), Status::kOk);
  EXPECT_EQ(town.world.restore(saved), Status::kOk);
}

TEST(HairWorld, SoItHasInALongLife) { live(kCoifSolver, InstructionSet::kBest, 600, 8); }

}  // namespace coif::hair_world_test
