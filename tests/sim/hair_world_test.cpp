// Heads of many assets that come and go: each has the bits that it has alone.

#include "models/playback.h"

#include <coif/hair_world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace coif::hair_world_test {

TestRig passive_strands(std::uint32_t strands, int bones, float substep_rate) {
  TestRig rig;
  rig.model = ChainModel::kPassive;
  rig.substep_rate = substep_rate;
  for (std::uint32_t i = 0; i < strands; ++i) {
    rig.add_strand(bones, {.joint = {0.02f * float(i), 0, -0.09f},
                           .rest_direction = {0, -0.8f, -0.6f},
                           .length = 0.3f / float(bones),
                           .friction = 0.4f * float(i % 3),
                           .hit_radius = 0.004f,
                           .stiffness = 60 + 20 * float(i),
                           .damping = 5,
                           .torsion = kShortestArc});
  }
  return rig;
}

/// Hair of every kind: both models, twisting and not, bounded and not, with few and with many colliders, tuned for several rates, without any
/// chain. Several have chains of one shape.
std::vector<AssetContents> many_kinds() {
  std::vector<AssetContents> kinds;
  kinds.push_back(feature_rig().contents());
  TestRig tuned = feature_rig();
  tuned.levels.clear();
  tuned.substep_rate = 90;
  kinds.push_back(tuned.contents());
  kinds.push_back(nine_bone_rig().contents());
  TestRig other = nine_bone_rig();
  other.add_capsule({-0.1f, -0.2f, -0.1f}, {0.1f, -0.2f, -0.1f}, 0.04f);
  for (DynamicsRecord& bone : other.dynamics) bone.friction = 1.5f;
  kinds.push_back(other.contents());
  TestRig limited = passive_strands(3, 3, 0);
  limited.add_sphere({0, 0, 0}, 0.1f);
  for (std::uint32_t bone = 1; bone < limited.bones.size(); ++bone) {
    limited.limit(bone, LimitKind::kCone, 0.2f + 0.05f * float(bone));
  }
  kinds.push_back(limited.contents());
  TestRig soft = passive_strands(5, 3, 90);
  soft.add_sphere({0, 0, 0}, 0.1f);
  soft.add_plane({0, -0.3f, 0}, {0, 1, 0});
  kinds.push_back(soft.contents());
  kinds.push_back(passive_strands(2, 12, 90).contents());
  AssetContents mixed = passive_strands(4, 3, 0).contents();
  mixed.chains[1].model = mixed.chains[2].model = ChainModel::kCascade;
  mixed.skeleton.air_lag = 0.5f;
  kinds.push_back(mixed);
  TestRig crowded = nine_bone_rig();
  while (crowded.colliders.size() < kMaxColliders - 3) {
    const float place = 0.02f * float(crowded.colliders.size());
    crowded.add_sphere({0.3f - place, -0.1f - 0.3f * place, -0.1f}, 0.03f);
  }
  for (BoneRecord& bone : crowded.bones) bone.colliders = bone.chain == kNone ? 0 : 0x1FFFFFFF;
  kinds.push_back(crowded.contents());
  kinds.push_back(TestRig().contents());
  return kinds;
}

/// An asset, opened.
struct Kind {
  explicit Kind(const AssetContents& contents) : file(write_asset(contents)) { EXPECT_TRUE(asset.open(file.bytes())); }
  AlignedBytes file;
  Asset asset;
};

AlignedBytes memory_of(std::size_t bytes) { return AlignedBytes(std::vector<std::byte>(bytes, std::byte{0xFF})); }

/// The same head in a crowd of its own.
struct Twin {
  Twin(const Asset& asset, const Solver& solver, const HeadPose& pose)
      : memory(memory_of(Hair::memory_need(asset, {.solver = &solver}).bytes)) {
    EXPECT_EQ(hair.create(asset, {.solver = &solver}, memory.bytes()), Status::kOk);
    EXPECT_EQ(hair.reset(0, pose), Status::kOk);
  }
  AlignedBytes memory;
  Hair hair;
};

struct Resident {
  std::size_t kind = 0;
  WorldHead head;
  std::unique_ptr<Twin> twin;
};

/// A world, and each of its heads once more alone.
class Town {
 public:
  Town(const std::vector<std::unique_ptr<Kind>>& kinds, const WorldDesc& desc)
      : kinds_(kinds),
        solver_(*desc.solver),
        memory_(memory_of(HairWorld::memory_need(desc).bytes)),
        names_(kinds.size()) {
    EXPECT_EQ(world.create(desc, memory_.bytes()), Status::kOk);
  }

  bool is_here(std::size_t kind) const { return world.has(names_[kind]); }
  std::size_t heads_of(std::size_t kind) const {
    return std::size_t(std::ranges::count(residents, kind, [](const Resident& one) { return one.kind; }));
  }
  Status come(std::size_t kind) { return world.add_asset(kinds_[kind]->asset, names_[kind]); }
  Status leave(std::size_t kind) { return world.remove_asset(names_[kind]); }

  Status move_in(std::size_t kind, const HeadPose& pose) {
    Resident one{kind, {}, nullptr};
    const Status status = world.add_head(names_[kind], pose, one.head);
    if (status != Status::kOk) return status;
    one.twin = std::make_unique<Twin>(kinds_[kind]->asset, solver_, pose);
    residents.push_back(std::move(one));
    return Status::kOk;
  }
  void move_out(std::size_t index) {
    EXPECT_EQ(world.remove_head(residents[index].head), Status::kOk);
    EXPECT_FALSE(world.has(residents[index].head));
    EXPECT_EQ(world.remove_head(residents[index].head), Status::kBadIndex);
    residents.erase(residents.begin() + std::ptrdiff_t(index));
  }

  void step(const StepSettings& settings, bool backwards) {
    ASSERT_EQ(world.begin_step(settings), Status::kOk);
    const std::uint32_t jobs = world.job_count();
    for (std::uint32_t job = 0; job < jobs; ++job) world.run_job(backwards ? jobs - 1 - job : job);
    world.finish_step();
    for (const Resident& one : residents) ASSERT_EQ(one.twin->hair.step(settings), Status::kOk);
  }

  /// Heads that are not to the bit as they are alone.
  [[nodiscard]] int strangers() const {
    int count = 0;
    for (const Resident& one : residents) {
      const auto here = world.palette(one.head), alone = one.twin->hair.palette(0);
      const bool is_same =
          here.size() == alone.size() && std::memcmp(here.data(), alone.data(), here.size_bytes()) == 0;
      count += is_same && world.is_asleep(one.head) == one.twin->hair.is_asleep(0) ? 0 : 1;
    }
    return count;
  }

  HairWorld world;
  std::vector<Resident> residents;

 private:
  const std::vector<std::unique_ptr<Kind>>& kinds_;
  const Solver& solver_;
  AlignedBytes memory_;
  std::vector<WorldAsset> names_;
};

std::vector<std::unique_ptr<Kind>> opened(const std::vector<AssetContents>& contents) {
  std::vector<std::unique_ptr<Kind>> kinds;
  for (const AssetContents& one : contents) kinds.push_back(std::make_unique<Kind>(one));
  return kinds;
}

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

/// Assets and heads come and go, more of them come than go for a while, then the other way around.
void move_about(Town& town, std::size_t kinds, int frame, std::mt19937& lot) {
  const auto one_of = [&](std::size_t count) { return std::size_t(lot() % count); };
  for (int i = 0; i < 3; ++i) {
    const std::size_t kind = one_of(kinds);
    const bool grows = frame / 40 % 2 == 0 ? lot() % 4 != 0 : lot() % 4 == 0;
    if (grows) {
      EXPECT_EQ(town.is_here(kind) ? Status::kOk : town.come(kind), Status::kOk);
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
  int asleep = 0, awake = 0;
  for (int frame = 0; frame < frames; ++frame) {
    move_about(town, kinds.size(), frame, lot);
    for (std::size_t i = 0; i < town.residents.size(); ++i) {
      const Resident& one = town.residents[i];
      give(order_of(one.head.index, frame, random), town.world, one.head, one.twin->hair);
    }
    town.step(settings_of(frame, random), frame % 2 == 1);
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

}  // namespace coif::hair_world_test
