// A crowd's state as bytes. All changing state is written head by head, in the order of the instances. So equal states
// have equal bytes, whatever blocks the heads are in, and nothing that is read back is an address or an index.

#include <coif/hair.h>

#include "crowd_step.h"
#include "float_environment.h"
#include "mixer.h"
#include "saved_collider.h"
#include "saved_lane.h"

#include <cstring>

namespace coif {
namespace {

constexpr std::uint64_t kMagic = 0x7461'7473'6669'6F63;  // "coifstat", little-endian
constexpr std::uint32_t kVersion = 4;

struct SavedHeader {
  std::uint64_t magic;
  std::uint32_t version;
  std::uint32_t instances;
  std::uint64_t crowd;  ///< Identifies the crowd, see signature_of().
  std::uint64_t hash;   ///< Hash of everything that follows.
};

/// Equal for crowds whose numbers mean the same: the bones of one asset, under the same solvers.
std::uint64_t signature_of(const CrowdState& crowd) {
  Mixer mixer(kVersion);
  const Asset& asset = crowd.asset;
  mixer.add(&asset.skeleton(), sizeof(SkeletonRecord));
  mixer.add(asset.bones());
  mixer.add(asset.chains());
  mixer.add(asset.dynamics());
  mixer.add(asset.asked());
  mixer.add(asset.colliders());
  mixer.add(asset.lod_bones());
  const CharacterState& character = crowd.character;
  const std::uint64_t worn[] = {character.places, character.body_colliders, std::uint64_t{!character.poses.empty()}};
  mixer.add(worn, sizeof worn);
  if (character.body_colliders != 0) mixer.add(asset.body_colliders());
  if (!asset.limits().empty()) mixer.add(asset.limits());
  for (const Row& row : crowd.rows) {
    const Solver& solver = *row.solver;
    const std::uint64_t kind[] = {solver.state_bytes,   solver.coefficient_bytes,
                                  row.bone_count,       row.first_chain,
                                  row.chain_count,      std::uint64_t{solver.carries_frames},
                                  crowd.interval_count, std::uint64_t{solver.reads_asked}};
    mixer.add(kind, sizeof kind);
  }
  const std::uint64_t asked[] = {crowd.sets.empty() ? 0 : crowd.dynamics_sets.size(),
                                 std::uint64_t{!character.airs.empty()}, character.gusts.size()};
  if (asked[0] + asked[1] + asked[2] != 0) mixer.add(asked, sizeof asked);
  return mixer.hash();
}

// Written as they lie in memory, so there must be no padding.
static_assert(sizeof(Gusts) == 28 && sizeof(HeadAir) == 16 && sizeof(GustWaves) == 384);
static_assert(sizeof(StepSettings) == 19 * sizeof(float) && sizeof(InstanceDetail) == 5 && sizeof(HeadPose) == 48);

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
void pass_time(CrowdState& crowd, Tape& tape) {
  tape.pass(&crowd.settings, sizeof crowd.settings);
  tape.pass(crowd.last_dts, sizeof crowd.last_dts);
  tape.pass(&crowd.step_index, sizeof crowd.step_index);
}

template <typename Tape>
void pass_details(CrowdState& crowd, Tape& tape) {
  tape.pass(crowd.details.data(), crowd.details.size_bytes());
  tape.pass(crowd.sets.data(), crowd.sets.size_bytes());
}

/// The air and the dynamics that hosts set, and how far gusts have come.
template <typename Tape>
void pass_air(CrowdState& crowd, Tape& tape) {
  if (!crowd.sets.empty()) {
    for (DynamicsSet& set : crowd.dynamics_sets) tape.pass(&set.scale, sizeof set.scale);
  }
  tape.pass(crowd.character.airs.data(), crowd.character.airs.size_bytes());
  for (GustField& field : crowd.character.gusts) {
    tape.pass(&field.told, sizeof field.told);
    tape.pass(&field.way, sizeof field.way);
    tape.pass(&field.waves, sizeof field.waves);
  }
}

template <typename Tape>
void pass_character(CrowdState& crowd, std::uint32_t instance, Tape& tape) {
  CharacterState& character = crowd.character;
  for (std::uint32_t place = 0; place < character.places; ++place) {
    ToldCollider& told = character.told[std::size_t(instance) * character.places + place];
    std::uint64_t& there = character.there[instance];
    const std::uint64_t bit = std::uint64_t{1} << place;
    SavedCollider saved = (there & bit) != 0 ? packed(told) : SavedCollider{};
    tape.pass(&saved, sizeof saved);
    told = unpacked(saved);
    there = (saved.flags & 1u) != 0 ? there | bit : there & ~bit;
  }
  if (character.is_posed.empty()) return;
  std::uint8_t posed = character.is_posed[instance];
  tape.pass(&posed, sizeof posed);
  character.is_posed[instance] = posed == 0 ? std::uint8_t{0} : std::uint8_t{1};
}

template <typename Tape>
void pass_head(CrowdState& crowd, std::uint32_t instance, Tape& tape) {
  const std::uint32_t slot = crowd.slots[instance], i = slot % kLanes;
  Block& block = crowd.blocks[slot / kLanes];
  pass_lane(tape, &block.heads, i, offsetof(HeadLanes, next_position));
  for (auto& axis : block.heads.next_position) tape.pass(&axis[i], sizeof(double));
  for (std::uint16_t* const bits : {&block.teleports, &block.is_lost, &block.may_sleep}) pass_bit(tape, *bits, i);
  tape.pass(&crowd.told[instance], sizeof(HeadPose));
  tape.pass(crowd.palette(instance).data(), crowd.palette(instance).size_bytes());
  pass_character(crowd, instance, tape);
  PoseLanes* const poses = crowd.character.poses.data();
  const std::size_t first = crowd.first_state(slot);
  for (const Row& row : crowd.rows) {
    const std::size_t bone = first + row.first_bone;
    // With kChains a row belongs to this head and has a lane for each chain; values of idle lanes are not saved.
    const bool by_heads = crowd.order == LaneOrder::kHeads;
    const std::uint32_t begin = by_heads ? i : 0, end = by_heads ? i + 1 : row.chain_count;
    for (std::uint32_t k = begin; k < end; ++k) {
      pass_lane(tape, &crowd.states[bone * crowd.state_bytes], k, row.bone_count * crowd.state_bytes);
      if (poses != nullptr) pass_lane(tape, poses + bone, k, row.bone_count * sizeof(PoseLanes));
      if (!crowd.twists.empty()) pass_lane(tape, &crowd.twists[bone], k, row.bone_count * sizeof(TwistState));
    }
  }
}

template <typename Tape>
void pass_all(CrowdState& crowd, Tape& tape) {
  pass_details(crowd, tape);
  pass_time(crowd, tape);
  pass_air(crowd, tape);
  for (std::uint32_t instance = 0; instance < crowd.instance_count(); ++instance) pass_head(crowd, instance, tape);
}

std::size_t size_of(CrowdState& crowd) {
  Counting head, once;
  pass_head(crowd, 0, head);
  pass_details(crowd, once);
  pass_time(crowd, once);
  pass_air(crowd, once);
  return sizeof(SavedHeader) + once.size + head.size * crowd.instance_count();
}

SavedHeader header_of(const CrowdState& crowd, std::span<const std::byte> content) {
  Mixer mixer(kVersion);
  mixer.add(content);
  return {kMagic, kVersion, crowd.instance_count(), signature_of(crowd), mixer.hash()};
}

/// Puts each head into the treatment that it had, then reads its numbers.
void read_all(CrowdState& crowd, Reading tape) {
  pass_details(crowd, tape);
  pass_time(crowd, tape);
  pass_air(crowd, tape);
  crowd.has_asked = false;
  for (std::uint32_t instance = 0; instance < crowd.instance_count(); ++instance) {
    sort_in(crowd, instance);
    const InstanceDetail& detail = crowd.details[instance];
    if (detail.interval_power != detail.asked_power) crowd.has_asked = true;
  }
  for (std::uint32_t instance = 0; instance < crowd.instance_count(); ++instance) pass_head(crowd, instance, tape);
  crowd.job_count = 0;
}

}  // namespace

std::size_t Hair::saved_bytes() const { return crowd_ == nullptr ? 0 : size_of(*crowd_); }

Status Hair::save(std::span<std::byte> bytes) const {
  if (crowd_ == nullptr) return Status::kNotCreated;
  if (bytes.size() != size_of(*crowd_)) return Status::kSizeMismatch;
  const std::span<std::byte> content = bytes.subspan(sizeof(SavedHeader));
  Writing tape{content.data()};
  pass_all(*crowd_, tape);
  const SavedHeader header = header_of(*crowd_, content);
  std::memcpy(bytes.data(), &header, sizeof header);
  return Status::kOk;
}

Status Hair::restore(std::span<const std::byte> bytes) {
  if (crowd_ == nullptr) return Status::kNotCreated;
  SavedHeader header{};
  if (bytes.size() < sizeof header) return Status::kDamagedState;
  std::memcpy(&header, bytes.data(), sizeof header);
  if (header.magic != kMagic) return Status::kDamagedState;
  if (header.version != kVersion || header.instances != crowd_->instance_count()) return Status::kForeignState;
  if (header.crowd != signature_of(*crowd_)) return Status::kForeignState;
  const std::span<const std::byte> content = bytes.subspan(sizeof header);
  const SavedHeader whole = header_of(*crowd_, content);
  if (bytes.size() != size_of(*crowd_) || header.hash != whole.hash) return Status::kDamagedState;
  const FloatEnvironment plain;
  if (!could_be_saved(*crowd_, content)) return Status::kDamagedState;
  read_all(*crowd_, {content.data()});
  return Status::kOk;
}

}  // namespace coif
