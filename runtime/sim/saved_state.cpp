// A world's state as bytes. All changing state is written head by head, in the order of their numbers. So equal states
// have equal bytes, whatever blocks the heads are in, and nothing that is read back is an address or an index.

#include <coif/hair_world.h>

#include "float_environment.h"
#include "mixer.h"
#include "saved_collider.h"
#include "saved_lane.h"

#include <cstring>

namespace coif {
namespace {

constexpr std::uint64_t kMagic = 0x7461'7473'6669'6F63;  // "coifstat", little-endian
constexpr std::uint32_t kVersion = 5;

struct SavedHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint32_t heads;
  std::uint64_t world;  ///< Identifies the world, see signature_of().
  std::uint64_t hash;   ///< Hash of everything that follows.
};

void add_asset(const WorldRules& rules, const WornAsset& worn, Mixer& mixer) {
  const Asset& asset = worn.asset;
  mixer.add(&asset.skeleton(), sizeof(SkeletonRecord));
  mixer.add(asset.bones());
  mixer.add(asset.chains());
  mixer.add(asset.dynamics());
  mixer.add(asset.asked());
  mixer.add(asset.colliders());
  mixer.add(asset.lod_bones());
  const std::uint64_t own[] = {worn.places, worn.body_colliders};
  mixer.add(own, sizeof own);
  if (worn.body_colliders != 0) mixer.add(asset.body_colliders());
  if (!asset.limits().empty()) mixer.add(asset.limits());
  for (const ChainRecord& chain : asset.chains()) {
    const Solver& solver = solver_for(*rules.solver, chain);
    const std::uint64_t kind[] = {solver.state_bytes, solver.coefficient_bytes, std::uint64_t{solver.carries_frames},
                                  std::uint64_t{solver.reads_asked}};
    mixer.add(kind, sizeof kind);
  }
}

/// Equal for worlds whose numbers mean the same: the same heads with the bones of the same assets, under the same
/// solvers.
std::uint64_t signature_of(WorldState& world) {
  Mixer mixer(kVersion);
  const WorldRules& rules = world.rules;
  const std::uint64_t asked[] = {rules.intervals, rules.sets, std::uint64_t{rules.follows_poses},
                                 std::uint64_t{rules.has_own_air}, std::uint64_t{rules.feels_gusts}};
  mixer.add(asked, sizeof asked);
  for (const WornAsset& worn : world.assets) {
    if (worn.heads != 0) add_asset(rules, worn, mixer);
  }
  for_each_head(world, [&](std::uint32_t index) {
    const WornHead& head = world.heads[index];
    const std::uint32_t name[] = {index, head.generation, head.asset};
    mixer.add(name, sizeof name);
  });
  return mixer.hash();
}

// Written as they lie in memory, so there must be no padding.
static_assert(sizeof(Gusts) == 28 && sizeof(HeadAir) == 16 && sizeof(GustWaves) == 384);
static_assert(sizeof(StepSettings) == 19 * sizeof(float) && sizeof(HeadDetail) == 5 && sizeof(HeadPose) == 48);

/// Counting, writing and reading walk through the state by the same code, so that they cannot disagree.
struct Counting {
  std::size_t size = 0;
  void pass(const void*, std::size_t bytes) { size += bytes; }
};
struct Writing {
  std::byte* to;
  void pass(const void* from, std::size_t bytes) {
    if (bytes == 0) return;  // An empty source may have no address.
    std::memcpy(to, from, bytes);
    to += bytes;
  }
};
struct Reading {
  const std::byte* from;
  void pass(void* to, std::size_t bytes) {
    if (bytes == 0) return;
    std::memcpy(to, from, bytes);
    from += bytes;
  }
};

/// Passes lane `i` of `bytes` bytes of Lanes.
template <typename Tape>
void pass_lane(Tape& tape, void* lanes, std::uint32_t i, std::size_t bytes) {
  Lanes* const all = static_cast<Lanes*>(lanes);
  for (std::size_t n = 0; n < bytes / sizeof(Lanes); ++n) tape.pass(&all[n].v[i], sizeof(float));
}

template <typename Tape>
void pass_bit(Tape& tape, std::uint16_t& bits, std::uint32_t i) {
  std::uint8_t bit = std::uint8_t(bits >> i & 1u);
  tape.pass(&bit, sizeof bit);
  bits = std::uint16_t((bits & ~(1u << i)) | (bit & 1u) << i);
}

template <typename Tape>
void pass_time(WorldState& world, Tape& tape) {
  tape.pass(&world.settings, sizeof world.settings);
  tape.pass(world.last_dts, sizeof world.last_dts);
  tape.pass(&world.step_index, sizeof world.step_index);
}

template <typename Tape>
void pass_details(WorldState& world, Tape& tape) {
  for_each_head(world, [&](std::uint32_t head) { tape.pass(&world.heads[head].detail, sizeof(HeadDetail)); });
  if (world.rules.sets == 1) return;
  for_each_head(world, [&](std::uint32_t head) { tape.pass(&world.heads[head].set, sizeof(std::uint8_t)); });
}

/// The air and the dynamics that hosts set, and how far gusts have come.
template <typename Tape>
void pass_air(WorldState& world, Tape& tape) {
  if (world.rules.sets > 1) tape.pass(world.dynamics_sets.data(), world.dynamics_sets.size_bytes());
  if (!world.airs.empty()) {
    for_each_head(world, [&](std::uint32_t head) { tape.pass(&world.airs[head], sizeof(HeadAir)); });
  }
  for (GustField& field : world.gusts) {
    tape.pass(&field.told, sizeof field.told);
    tape.pass(&field.way, sizeof field.way);
    tape.pass(&field.waves, sizeof field.waves);
  }
}

template <typename Tape>
void pass_character(WorldState& world, WornHead& head, Tape& tape) {
  const std::uint32_t places = world.worn_by(head).places;
  for (std::uint32_t place = 0; place < places; ++place) {
    ToldCollider& told = world.told_colliders(head)[place];
    std::uint64_t& there = world.colliders_of(head).there;
    const std::uint64_t bit = std::uint64_t{1} << place;
    SavedCollider saved = (there & bit) != 0 ? packed(told) : SavedCollider{};
    tape.pass(&saved, sizeof saved);
    told = unpacked(saved);
    there = (saved.flags & 1u) != 0 ? there | bit : there & ~bit;
  }
  if (!world.rules.follows_poses) return;
  std::uint8_t posed = head.is_posed ? 1 : 0;
  tape.pass(&posed, sizeof posed);
  head.is_posed = posed != 0;
}

template <typename Tape>
void pass_head(WorldState& world, std::uint32_t index, Tape& tape) {
  WornHead& head = world.heads[index];
  Block& block = *head.block;
  pass_lane(tape, &block.heads, head.lane, offsetof(HeadLanes, next_position));
  for (auto& axis : block.heads.next_position) tape.pass(&axis[head.lane], sizeof(double));
  for (std::uint16_t* const bits : {&block.teleports, &block.is_lost, &block.may_sleep}) {
    pass_bit(tape, *bits, head.lane);
  }
  tape.pass(&world.told[index], sizeof(HeadPose));
  tape.pass(world.palette(head).data(), world.palette(head).size_bytes());
  pass_character(world, head, tape);
  const auto chains = world.worn_by(head).asset.chains();
  for_each_chain(world, index, [&](const Solver& solver, std::uint32_t c, const ChainLane& chain) {
    const std::uint32_t bones = chains[c].bone_count, lane = chain.state_lane;
    pass_lane(tape, chain.state, lane, bones * solver.state_bytes);
    if (chain.poses != nullptr) pass_lane(tape, chain.poses, lane, bones * sizeof(PoseLanes));
    if (chain.twist != nullptr) pass_lane(tape, chain.twist, lane, bones * sizeof(TwistState));
  });
}

template <typename Tape>
void pass_all(WorldState& world, Tape& tape) {
  pass_details(world, tape);
  pass_time(world, tape);
  pass_air(world, tape);
  for_each_head(world, [&](std::uint32_t head) { pass_head(world, head, tape); });
}

std::uint32_t head_count(const WorldState& world) {
  std::uint32_t count = 0;
  for (const WornAsset& worn : world.assets) count += worn.heads;
  return count;
}

/// Heads of one asset need equally many bytes.
std::size_t size_of(WorldState& world) {
  Counting all;
  pass_details(world, all);
  pass_time(world, all);
  pass_air(world, all);
  std::size_t size = 0;
  std::uint32_t last = kNone;
  for_each_head(world, [&](std::uint32_t head) {
    if (world.heads[head].asset != last) {
      Counting one;
      pass_head(world, head, one);
      size = one.size;
      last = world.heads[head].asset;
    }
    all.size += size;
  });
  return sizeof(SavedHeader) + all.size;
}

SavedHeader header_of(WorldState& world, std::span<const std::byte> content) {
  Mixer mixer(kVersion);
  mixer.add(content);
  return {kMagic, kVersion, head_count(world), signature_of(world), mixer.hash()};
}

/// Puts each head into the treatment that it had, then reads its numbers.
void read_all(WorldState& world, Reading tape) {
  for_each_head(world, [&](std::uint32_t head) {
    if (world.heads[head].has_lanes) world.shared->leave_lanes(world, head);
  });
  pass_details(world, tape);
  pass_time(world, tape);
  pass_air(world, tape);
  world.has_asked = false;
  for_each_head(world, [&](std::uint32_t head) {
    sort_in(world, head);
    const WornHead& worn = world.heads[head];
    const bool is_shared = world.crowd_of(worn).order == LaneOrder::kShared;
    if (is_shared && !worn.has_lanes && worn.block->treatment != kIdle) world.shared->enter(world, head);
    if (worn.detail.interval_power != worn.detail.asked_power) world.has_asked = true;
  });
  for_each_head(world, [&](std::uint32_t head) { pass_head(world, head, tape); });
  world.job_count = 0;
}

}  // namespace

std::size_t HairWorld::saved_bytes() const {
  if (world_ == nullptr) return 0;
  const FloatEnvironment plain;
  return size_of(*world_);
}

Status HairWorld::save(std::span<std::byte> bytes) const {
  if (world_ == nullptr) return Status::kNotCreated;
  const FloatEnvironment plain;
  if (bytes.size() != size_of(*world_)) return Status::kSizeMismatch;
  const std::span<std::byte> content = bytes.subspan(sizeof(SavedHeader));
  Writing tape{content.data()};
  pass_all(*world_, tape);
  const SavedHeader header = header_of(*world_, content);
  std::memcpy(bytes.data(), &header, sizeof header);
  return Status::kOk;
}

Status HairWorld::restore(std::span<const std::byte> bytes) {
  if (world_ == nullptr) return Status::kNotCreated;
  SavedHeader header{};
  if (bytes.size() < sizeof header) return Status::kDamagedState;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.magic != kMagic) return Status::kDamagedState;
  if (header.version != kVersion || header.heads != head_count(*world_)) return Status::kForeignState;
  if (header.world != signature_of(*world_)) return Status::kForeignState;
  const std::span<const std::byte> content = bytes.subspan(sizeof header);
  const SavedHeader whole = header_of(*world_, content);
  const FloatEnvironment plain;
  if (bytes.size() != size_of(*world_) || header.hash != whole.hash) return Status::kDamagedState;
  if (!could_be_saved(*world_, content)) return Status::kDamagedState;
  read_all(*world_, {content.data()});
  return Status::kOk;
}

}  // namespace coif
