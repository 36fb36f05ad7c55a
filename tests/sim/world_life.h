#pragma once
// A world that is called by lot, and checks of what must hold after each call.

#include "sim/guarded_memory.h"
#include "sim/hair_town.h"
#include "sim/odd_numbers.h"
#include "sim/saved_bytes.h"

#include <coif/hair_world.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <memory>
#include <optional>
#include <vector>

namespace coif::world_calls_test {

using hair_town::Kind;
using Kinds = std::vector<std::unique_ptr<Kind>>;

/// What all lives together have come to.
struct Tally {
  long without_memory = 0, stepped = 0, asleep = 0, refused_bytes = 0, taken_bytes = 0;
};

/// One world from its creation to its end.
class Life {
 public:
  /// With `has_choices` calls come from threads with other rounding modes, and whose exceptions trap, and the world may
  /// have another instruction set.
  Life(const Kinds& kinds, const WorldDesc& desc, std::uint32_t number, bool has_choices)
      : kinds_(kinds),
        desc_(desc),
        has_choices_(has_choices),
        lot_(number + 1),
        host_(number),
        memory_(HairWorld::memory_need(desc_).bytes) {
    if (!has_choices) desc_.instruction_set = InstructionSet::kBest;
    EXPECT_EQ(world_.create(desc_, memory_.bytes()), Status::kOk);
    at_first_ = fill();
    clear();
  }
  /// In the end nothing is left, and there is room for all that there was room for at first.
  ~Life() {
    clear();
    EXPECT_EQ(fill(), at_first_) << "memory was lost";
    EXPECT_TRUE(memory_.unharmed()) << "something was written in front of the world";
  }
  Life(const Life&) = delete;
  Life& operator=(const Life&) = delete;

  void call() {
    kept_.reset();
    if (lot_.one_in(12)) kept_ = saved();
    switch (lot_.below(30)) {
      case 0: return add_asset();
      case 1: return remove_asset();
      case 2:
      case 3:
      case 4: return add_head();
      case 5:
      case 6: return remove_head();
      case 7:
      case 8: return move_head();
      case 9: return put_head();
      case 10: return set_detail();
      case 11: return choose_dynamics();
      case 12: return lot_.one_in(2) ? set_dynamics() : set_gusts();
      case 13: return push();
      case 14: return set_air();
      case 15: return set_pose();
      case 16: return set_body();
      case 17: return set_colliders();
      case 18: return settle();
      case 19: return go_back();
      case 20: return restore_other_bytes();
      case 21: return ask();
      case 22: return begin_and_run();
      default: return step();
    }
  }

  /// Hashes of the world after each step.
  [[nodiscard]] const std::vector<std::uint64_t>& history() const { return history_; }
  Tally tally;

 private:
  struct Head {
    WorldHead name;
    std::size_t kind = 0;
  };
  struct Here {
    WorldAsset name;
    std::size_t kind = 0;
  };

  /// Makes a call as a host would, and checks its answer.
  template <typename Call>
  Status answer(const char* what, const Call& call, std::initializer_list<Status> documented) {
    Status status{};
    const std::uint32_t choice = host_.below(8);
    {
      const HostsChoice chosen(has_choices_ ? choice : 0);
      status = call();
    }
    EXPECT_TRUE(status == Status::kOk || std::ranges::count(documented, status) == 1)
        << what << ": " << describe(status);
    tally.without_memory += status == Status::kMemoryTooSmall ? 1 : 0;
    if (status != Status::kOk && kept_.has_value()) {
      EXPECT_TRUE(saved() == *kept_) << what << " refused and changed something";
    }
    return status;
  }
  /// The same for a call for one head.
  template <typename Call>
  Status answer(const char* what, const Head& head, const Call& call, std::initializer_list<Status> documented) {
    const bool is_there = world_.has(head.name);
    const Status status = answer(what, call, documented);
    EXPECT_EQ(status == Status::kBadIndex, !is_there) << what;
    return status;
  }

  [[nodiscard]] SavedState saved() const {
    SavedState bytes(world_.saved_bytes());
    EXPECT_EQ(world_.save(bytes), Status::kOk);
    return bytes;
  }

  /// One that is there, or was, or never was.
  Head any_head() {
    if (heads_.empty() || lot_.one_in(12)) {
      if (!gone_.empty() && lot_.one_in(2)) return gone_[lot_.below(std::uint32_t(gone_.size()))];
      return {{lot_.below(64), lot_.below(3)}, 0};
    }
    return heads_[lot_.below(std::uint32_t(heads_.size()))];
  }
  [[nodiscard]] const Asset& asset_of(const Head& head) const { return kinds_[head.kind]->asset; }
  Here any_asset() {
    if (assets_.empty() || lot_.one_in(12)) return {{lot_.below(9), lot_.below(3)}, 0};
    return assets_[lot_.below(std::uint32_t(assets_.size()))];
  }

  void add_asset() {
    constexpr std::uint32_t kCrowds[] = {0, 0, 2, 40};
    const std::size_t kind = lot_.below(std::uint32_t(kinds_.size()));
    Here here{{77, 77}, kind};
    const std::uint32_t crowd = kCrowds[lot_.below(4)];
    const bool is_open = !lot_.one_in(30);
    const Status status =
        answer("add_asset", [&] { return world_.add_asset(is_open ? kinds_[kind]->asset : Asset(), here.name, crowd); },
               {Status::kAssetLacksData, Status::kMemoryTooSmall});
    if (status == Status::kOk) assets_.push_back(here);
    EXPECT_TRUE(status == Status::kOk || (here.name.index == 77 && here.name.generation == 77));
  }
  void remove_asset() {
    const Here here = any_asset();
    const bool is_there = world_.has(here.name);
    const Status status = answer("remove_asset", [&] { return world_.remove_asset(here.name); },
                                 {Status::kBadIndex, Status::kBadArgument});
    EXPECT_EQ(status == Status::kBadIndex, !is_there);
    EXPECT_EQ(world_.has(here.name), status == Status::kBadArgument);
    std::erase_if(assets_, [&](const Here& one) { return !world_.has(one.name); });
  }
  void add_head() { (void)add_head(any_asset(), lot_.pose()); }
  Status add_head(const Here& here, const HeadPose& pose) {
    Head head{{77, 77}, here.kind};
    const Status status = answer("add_head", [&] { return world_.add_head(here.name, pose, head.name); },
                                 {Status::kBadIndex, Status::kBadPose, Status::kBadScale, Status::kMemoryTooSmall});
    if (status == Status::kOk) heads_.push_back(head);
    EXPECT_TRUE(status == Status::kOk || (head.name.index == 77 && head.name.generation == 77));
    return status;
  }
  void remove_head() {
    const Head head = any_head();
    (void)answer("remove_head", head, [&] { return world_.remove_head(head.name); }, {Status::kBadIndex});
    EXPECT_FALSE(world_.has(head.name));
    if (std::erase_if(heads_, [&](const Head& one) { return !world_.has(one.name); }) != 0) gone_.push_back(head);
  }

  void move_head() {
    const Head head = any_head();
    const HeadPose pose = lot_.pose();
    const HeadVelocity velocity{lot_.vector(3), lot_.vector(6)};
    const bool is_fast = lot_.one_in(4);
    (void)answer(
        "set_head", head,
        [&] { return is_fast ? world_.set_head(head.name, pose, velocity) : world_.set_head(head.name, pose); },
        {Status::kBadIndex, Status::kBadPose, Status::kBadScale});
  }
  void put_head() {
    const Head head = any_head();
    const HeadPose pose = lot_.pose();
    const bool resets = lot_.one_in(2);
    (void)answer("reset or teleport", head,
                 [&] { return resets ? world_.reset(head.name, pose) : world_.teleport(head.name, pose); },
                 {Status::kBadIndex, Status::kBadPose, Status::kBadScale});
  }
  void set_detail() {
    const Head head = any_head();
    const Detail detail{lot_.below(lot_.one_in(9) ? 300 : 2), 1u << lot_.below(lot_.one_in(9) ? 6 : 3),
                        !lot_.one_in(3)};
    (void)answer("set_detail", head, [&] { return world_.set_detail(head.name, detail); },
                 {Status::kBadIndex, Status::kBadArgument});
  }
  void choose_dynamics() {
    const Head head = any_head();
    const std::uint32_t set = lot_.below(lot_.one_in(9) ? 300 : desc_.dynamics_sets);
    const Status status = answer("choose_dynamics", head, [&] { return world_.choose_dynamics(head.name, set); },
                                 {Status::kBadIndex, Status::kNotAsked});
    EXPECT_TRUE(status == Status::kBadIndex || (status == Status::kOk) == (set < desc_.dynamics_sets));
  }
  void set_dynamics() {
    const std::uint32_t set = lot_.below(desc_.dynamics_sets + (lot_.one_in(9) ? 1 : 0));
    const DynamicsScale scale = lot_.dynamics();
    (void)answer("set_dynamics", [&] { return world_.set_dynamics(set, scale); },
                 {Status::kNotAsked, Status::kBadArgument});
  }
  void set_gusts() {
    const Gusts gusts{.amplitude = lot_.one_in(2) ? lot_.number(0, 5) : 0,
                      .length = lot_.number(0.1f, 3),
                      .speed = lot_.number(0, 5),
                      .direction = lot_.vector(1),
                      .seed = lot_.below(3)};
    (void)answer("set_gusts", [&] { return world_.set_gusts(gusts); }, {Status::kNotAsked, Status::kBadArgument});
  }
  void push() {
    const Head head = any_head();
    const Impulse impulse = lot_.impulse();
    (void)answer("push", head, [&] { return world_.push(head.name, impulse); },
                 {Status::kBadIndex, Status::kBadArgument});
  }
  void set_air() {
    const Head head = any_head();
    const HeadAir air{lot_.vector(4), lot_.number(0, 1)};
    (void)answer("set_air", head, [&] { return world_.set_air(head.name, air); },
                 {Status::kBadIndex, Status::kNotAsked, Status::kBadArgument});
  }
  void set_pose() {
    const Head head = any_head();
    std::vector<Quat> rotations(asset_of(head).bones().size() + (lot_.one_in(20) ? 1 : 0));
    std::vector<float> weights(lot_.one_in(2) ? 1 : asset_of(head).chains().size());
    for (Quat& rotation : rotations) rotation = lot_.one_in(4) ? lot_.rotation() : Quat{};
    for (float& weight : weights) weight = lot_.one_in(20) ? lot_.number(0, 1) : lot_.between(0, 1);
    if (lot_.one_in(4)) rotations.clear(), weights.clear();
    (void)answer("set_pose", head, [&] { return world_.set_pose(head.name, rotations, weights); },
                 {Status::kBadIndex, Status::kNotAsked, Status::kSizeMismatch, Status::kBadPose, Status::kBadArgument});
  }
  void set_body() {
    const Head head = any_head();
    std::vector<BodyPose> bones(asset_of(head).body_bones().size() + (lot_.one_in(20) ? 1 : 0));
    for (BodyPose& bone : bones) bone = {{lot_.metres(0.3), lot_.metres(0.3), lot_.metres(0.3)}, lot_.rotation()};
    (void)answer("set_body", head, [&] { return world_.set_body(head.name, bones); },
                 {Status::kBadIndex, Status::kNotAsked, Status::kSizeMismatch, Status::kBadPose});
  }
  void set_colliders() {
    const Head head = any_head();
    std::vector<MovingCollider> all(lot_.below(lot_.one_in(9) ? 20 : std::min(desc_.moving_colliders + 1, 4u)));
    for (MovingCollider& one : all) one = lot_.collider();
    (void)answer("set_colliders", head, [&] { return world_.set_colliders(head.name, all); },
                 {Status::kBadIndex, Status::kNotAsked, Status::kBadArgument, Status::kBadPose});
  }

  void settle() {
    std::vector<WorldHead> names(lot_.below(4));
    for (WorldHead& name : names)
      name = lot_.one_in(3) ? any_head().name : heads_.empty() ? WorldHead{} : heads_[0].name;
    const float seconds = lot_.one_in(20) ? lot_.odd() : lot_.between(0, 0.1f);
    const StepSettings settings = lot_.settings();
    (void)answer("settle", [&] { return world_.settle(names, seconds, settings); },
                 {Status::kBadIndex, Status::kBadTimeStep, Status::kBadArgument});
    expect_sound();
  }
  void step() {
    const StepSettings settings = lot_.settings();
    const JobOrder order = JobOrder(lot_.below(3));
    const bool in_parts = lot_.one_in(2);
    (void)answer("step", [&] { return in_parts ? step_in_parts(settings, order) : world_.step(settings); },
                 {Status::kBadTimeStep, Status::kBadArgument});
    EXPECT_EQ(world_.job_count(), 0u);
    expect_sound();
  }
  Status step_in_parts(const StepSettings& settings, JobOrder order) {
    const Status status = world_.begin_step(settings);
    hair_town::run_jobs(world_, order);
    world_.run_job(world_.job_count());  // There is none.
    world_.finish_step();
    return status;
  }
  /// A step that has not begun has no jobs and no end.
  void begin_and_run() {
    if (!kept_.has_value()) kept_ = saved();
    EXPECT_EQ(world_.begin_step({.dt = lot_.one_in(2) ? -1.0f : std::nanf("")}), Status::kBadTimeStep);
    for (const std::uint32_t job : {0u, 1u, kNone}) world_.run_job(job);
    world_.finish_step();
    EXPECT_TRUE(saved() == *kept_);
  }

  /// What the world saves is always good, and going back to it changes nothing.
  void go_back() {
    const SavedState now = saved();
    EXPECT_EQ(answer("restore", [&] { return world_.restore(now); }, {}), Status::kOk);
    EXPECT_TRUE(saved() == now);
    if (earlier_.empty() || lot_.one_in(3)) earlier_ = now;
  }
  void restore_other_bytes() {
    SavedState bytes = lot_.one_in(2) || earlier_.empty() ? saved() : earlier_;
    for (std::uint32_t i = lot_.below(4); i > 0; --i)
      bytes[lot_.below(std::uint32_t(bytes.size()))] = std::byte(lot_.below(256));
    if (lot_.one_in(2) && bytes.size() > kContentAt) hash_anew(bytes);
    if (lot_.one_in(6)) bytes.resize(lot_.below(std::uint32_t(bytes.size())));
    const Status status =
        answer("restore", [&] { return world_.restore(bytes); }, {Status::kForeignState, Status::kDamagedState});
    (status == Status::kOk ? tally.taken_bytes : tally.refused_bytes) += 1;
    expect_sound();
  }
  void ask() {
    const Head head = any_head();
    std::vector<Vec3> ends(world_.palette(head.name).size() + (lot_.one_in(9) ? 1 : 0));
    (void)answer("bone_ends", head, [&] { return world_.bone_ends(head.name, ends); },
                 {Status::kBadIndex, Status::kSizeMismatch});
    SavedState bytes(world_.saved_bytes() + 1);
    (void)answer("save", [&] { return world_.save(bytes); }, {Status::kSizeMismatch});
    EXPECT_TRUE(std::isfinite(world_.gusts_way()));
    EXPECT_GT(HairWorld::bytes_for(kinds_[head.kind]->asset, lot_.below(kNone), desc_, lot_.below(50)), 0u);
  }

  void expect_sound() {
    for (const Head& head : heads_) {
      float sum = 0;
      for (const Mat34& matrix : world_.palette(head.name)) {
        for (const auto& row : matrix.m) {
          for (const float value : row) sum += value * 0;
        }
      }
      std::vector<Vec3> ends(world_.palette(head.name).size());
      EXPECT_EQ(world_.bone_ends(head.name, ends), Status::kOk);
      for (const Vec3& end : ends) sum += end.x * 0 + end.y * 0 + end.z * 0;
      (world_.is_asleep(head.name) ? tally.asleep : tally.stepped) += 1;
      EXPECT_EQ(sum, 0) << "a matrix or a bone's end is not finite";
    }
    Mixer mixer(0);
    mixer.add(std::span<const std::byte>(saved()));
    history_.push_back(mixer.hash());
  }

  /// Adds assets and heads until no more fit; returns how many did.
  std::vector<std::size_t> fill() {
    kept_.reset();
    std::vector<std::size_t> counts;
    for (std::size_t kind = 0; kind < kinds_.size(); ++kind) {
      Here here{{}, kind};
      counts.push_back(0);
      if (world_.add_asset(kinds_[kind]->asset, here.name, kind % 3 == 0 ? 20 : 0) != Status::kOk) continue;
      assets_.push_back(here);
      for (int i = 0; i < 9 && add_head(here, {}) == Status::kOk; ++i) ++counts.back();
    }
    return counts;
  }
  void clear() {
    for (const Head& head : heads_) EXPECT_EQ(world_.remove_head(head.name), Status::kOk);
    for (const Here& here : assets_) EXPECT_EQ(world_.remove_asset(here.name), Status::kOk);
    heads_.clear();
    assets_.clear();
  }

  const Kinds& kinds_;
  WorldDesc desc_;
  bool has_choices_;
  OddNumbers lot_, host_;
  GuardedMemory memory_;
  HairWorld world_;
  std::vector<std::size_t> at_first_;
  std::vector<Head> heads_, gone_;
  std::vector<Here> assets_;
  std::optional<SavedState> kept_;  ///< The world before the present call, now and then.
  SavedState earlier_;
  std::vector<std::uint64_t> history_;
};

}  // namespace coif::world_calls_test
