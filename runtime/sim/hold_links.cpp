#include "chain_links.h"

#include "solver.h"
#include "vector_math.h"

#include <limits>

namespace coif {
namespace {

constexpr int kPlaceRounds = 32, kVelocityRounds = 8;
constexpr float kAtLength = 1e-3f;  ///< Share of its length within which a link is taut.
constexpr float kMargin = 1e-4f;    ///< Share of its length by which a link is brought within its lengths.
constexpr float kMostWay = 0.25f;   ///< Share of a bone's length, the bound of the linear model in one round.
constexpr float kNoLever2 = 1e-4f;  ///< Squared sine. A bone that is this nearly along its link cannot be turned by it.
constexpr float kSlowest = 1e-6f;   ///< m/s
constexpr int kPushes = 4;          ///< Rounds of a collider and a link against each other.
/// Directions around a link's end, nearest first.
constexpr struct {
  float cosine, sine;
} kAround[] = {{1, 0},  {0.70710678f, 0.70710678f},  {0.70710678f, -0.70710678f},  {0, 1},
               {0, -1}, {-0.70710678f, 0.70710678f}, {-0.70710678f, -0.70710678f}, {-1, 0}};

float within_one(float x) { return std::fabs(x) < 1.0f ? x : std::copysign(1.0f, x); }

/// The shorter bound with its margin. Where both lengths are equal, the link is kept between the margins.
float inner_shortest(const ChainLink& link) {
  const float within = link.shortest * (1 + kMargin), most = link.longest * (1 - kMargin);
  return within < most ? within : most;
}

/// Every second round starts from the other end, so that no end of a sheet leads.
const ChainLink& to_and_fro(std::span<const ChainLink> links, int round, std::size_t i) {
  return links[round % 2 == 0 ? i : links.size() - 1 - i];
}

/// The gap between the particles of a link.
struct Gap {
  Vec3 towards;      ///< Unit, from `bone` to `to`.
  float size = 0;    ///< Metres.
  float excess = 0;  ///< How much shorter the link has to become (negative: longer); 0 within its lengths.
};

class LinkedHead {
 public:
  LinkedHead(const LinkState& links, const LinkWork& work, std::int32_t lane)
      : links_(links),
        code_(*links.code->bones),
        steps_(work.steps, links.row_count),
        held_(work.held, links.bones.size()),
        moved_(work.moved, links.chains.size()),
        lane_(lane) {}

  float run() {
    for (char& moved : moved_) moved = 0;
    float motion = 0;
    for (const LinkLevel& level : links_.levels) {
      const std::uint32_t end = level.first_bone + level.bone_count;
      first_of_depth_ = level.first_bone;
      for (std::uint32_t b = level.first_bone; b < end; ++b) begin(b);
      hold_places(level);
      hold_velocities(level);
      for (std::uint32_t b = level.first_bone; b < end; ++b) {
        if (held_[b].is_turned) need_frames(b);
      }
      for (std::uint32_t b = level.first_bone; b < end; ++b) {
        if (moved_[links_.bones[b].chain] != 0) code_.finish(at(b), links_.bones[b].bone, parent_of(b), held_[b]);
        if (!links_.bones[b].has_children) motion += dot(held_[b].end_velocity, held_[b].end_velocity);
      }
    }
    return motion;
  }

 private:
  [[nodiscard]] LinkedLane at(std::uint32_t b) const {
    const LinkedChain& chain = links_.chains[links_.bones[b].chain];
    const LinkedRowStep& row = steps_[chain.row];
    return {&row.step, lane_ < 0 ? chain.lane : std::uint32_t(lane_), row.solver->carries_frames};
  }

  [[nodiscard]] const HeldBone* parent_of(std::uint32_t b) const {
    const std::int32_t parent = links_.bones[b].parent;
    return parent < 0 ? nullptr : &held_[std::size_t(parent)];
  }

  [[nodiscard]] std::span<const ChainLink> links_of(const LinkLevel& level) const {
    return links_.links.subspan(level.first_link, level.link_count);
  }

  void begin(std::uint32_t b);
  void place_end(HeldBone& bone) const {
    bone.end = bone.start + bone.direction * bone.length;
    bone.end_velocity = bone.start_velocity + bone.velocity;
  }
  void clear(std::uint32_t b) {
    need_frames(b);
    code_.clear(at(b), links_.bones[b].bone, parent_of(b), held_[b]);
    place_end(held_[b]);
  }
  void need_frames(std::uint32_t b);

  [[nodiscard]] Gap gap_of(const ChainLink& link) const;
  bool shorten(const ChainLink& link);
  void aim(HeldBone& bone, const Vec3& place, float wanted, float cosine_around, float sine_around);
  void close(const ChainLink& link);
  void turn_to(HeldBone& bone, const Vec3& direction);
  void turn(HeldBone& bone, const Vec3& way);
  void hold_places(const LinkLevel& level);
  float slow(const ChainLink& link);
  void hold_velocities(const LinkLevel& level);

  const LinkState& links_;
  const LinkedBoneCode& code_;
  const std::span<const LinkedRowStep> steps_;
  const std::span<HeldBone> held_;
  const std::span<char> moved_;
  const std::int32_t lane_;
  std::uint32_t first_of_depth_ = 0;  ///< First bone of the present depth; bones before it are done.
};

/// Reads a bone as the row's step left it, and places it on its parent's present end.
void LinkedHead::begin(std::uint32_t b) {
  const LinkedBone& linked = links_.bones[b];
  const LinkedLane lane = at(b);
  const Solver& solver = *steps_[links_.chains[linked.chain].row].solver;
  const auto* const state = static_cast<const std::byte*>(lane.row->state) + linked.bone * solver.state_bytes;
  HeldBone& bone = held_[b];
  bone.direction = coif::lane(*reinterpret_cast<const Lanes3*>(state), lane.lane);
  bone.velocity = coif::lane(*reinterpret_cast<const Lanes3*>(state + solver.velocity_at), lane.lane);
  bone.length = lane.row->constants[linked.bone].length.v[lane.lane];
  bone.mobility = code_.is_rigid(lane, linked.bone) ? 0.0f : linked.mobility;
  bone.is_turned = bone.is_forced = false;
  bone.turning_change = {};
  bone.free_swing = cross(bone.direction, bone.velocity) * (1.0f / bone.length);
  const HeldBone* const parent = parent_of(b);
  if (parent == nullptr) {
    code_.hang(lane, linked.bone, bone);
  } else {
    bone.start = parent->end;
    bone.start_velocity = parent->end_velocity;
  }
  bone.free_end = (parent == nullptr ? bone.start : parent->free_end) + bone.direction * bone.length;
  bone.free_velocity = (parent == nullptr ? bone.start_velocity : parent->free_velocity) + bone.velocity;
  if (parent != nullptr && moved_[linked.chain] != 0) code_.follow(lane, linked.bone, *parent, bone);
  place_end(bone);
}

/// Limits and children of a turned bone need all frames above it, so the chain's frames are kept from here on.
void LinkedHead::need_frames(std::uint32_t b) {
  const std::uint32_t chain = links_.bones[b].chain;
  if (moved_[chain] != 0) return;
  moved_[chain] = 1;
  const LinkedChain& linked = links_.chains[chain];
  for (std::uint32_t i = 0; i < linked.bone_count; ++i) {
    const std::uint32_t above = links_.places[linked.first + i];
    if (above < first_of_depth_) code_.finish(at(above), i, parent_of(above), held_[above]);
  }
}

Gap LinkedHead::gap_of(const ChainLink& link) const {
  const Vec3 way = held_[link.to].end - held_[link.bone].end;
  Gap gap;
  gap.size = length(way);
  gap.towards = unit_or(way, any_perpendicular(held_[link.bone].direction));
  if (gap.size > link.longest) gap.excess = gap.size - link.longest * (1 - kMargin);
  if (gap.size < link.shortest) gap.excess = gap.size - inner_shortest(link);
  return gap;
}

void LinkedHead::turn_to(HeldBone& bone, const Vec3& direction) {
  bone.direction = direction;
  bone.velocity = across(bone.velocity, direction);
  bone.is_turned = true;
  place_end(bone);
}

void LinkedHead::turn(HeldBone& bone, const Vec3& way) {
  const float most = kMostWay * bone.length, size2 = dot(way, way);
  const Vec3 part = size2 > most * most ? way * (most / std::sqrt(size2)) : way;
  turn_to(bone, unit_or(bone.direction + part * (1.0f / bone.length), bone.direction));
}

/// Turns both bones by the least that brings the link to its length, to first order. True where it was beyond.
bool LinkedHead::shorten(const ChainLink& link) {
  HeldBone &bone = held_[link.bone], &to = held_[link.to];
  const Gap gap = gap_of(link);
  if (gap.excess == 0.0f) return false;
  Vec3 side = across(gap.towards, bone.direction), to_side = across(gap.towards, to.direction);
  // Where a bone points along its link, any side is as good; the bone's own direction chooses one.
  if (dot(side, side) < kNoLever2) side = any_perpendicular(bone.direction);
  if (dot(to_side, to_side) < kNoLever2) to_side = any_perpendicular(to.direction);
  const float yields = bone.mobility * dot(side, side) + to.mobility * dot(to_side, to_side);
  if (!(yields > 0.0f)) return true;
  const float pull = gap.excess / yields;
  if (bone.mobility > 0.0f) turn(bone, side * (pull * bone.mobility));
  if (to.mobility > 0.0f) turn(to, to_side * (-pull * to.mobility));
  return true;
}

/// Turns one bone alone, by the least, so that its end is at the distance `wanted` from `place`.
void LinkedHead::aim(HeldBone& bone, const Vec3& place, float wanted, float cosine_around, float sine_around) {
  const Vec3 way = place - bone.start;
  const float distance = length(way);
  if (!(distance > 1e-9f)) return;
  const Vec3 axis = way * (1.0f / distance);
  const float sides = bone.length * bone.length + distance * distance - wanted * wanted;
  const float cosine = within_one(sides / (2 * bone.length * distance)), sine = std::sqrt(1.0f - cosine * cosine);
  const Vec3 side = unit_or(across(bone.direction, axis), any_perpendicular(axis));
  const Vec3 other = cross(axis, side);
  turn_to(bone, unit_or(axis * cosine + (side * cosine_around + other * sine_around) * sine, axis));
  bone.is_forced = true;
}

/// Turns one bone of the link alone: the one that hangs on the other, since bones that hang on it come later. Where a
/// collider or a limit is in the way, the bone is turned around the other's end until it is clear: otherwise two
/// strands would hang on either side of a neck.
void LinkedHead::close(const ChainLink& link) {
  const Gap gap = gap_of(link);
  if (gap.excess == 0.0f) return;
  const std::uint32_t b = held_[link.bone].mobility > 0.0f ? link.bone : link.to;
  HeldBone& bone = held_[b];
  const Vec3 place = held_[b == link.bone ? link.to : link.bone].end;
  if (!(bone.mobility > 0.0f)) return;
  const HeldBone before = bone;
  HeldBone best = bone;
  float least = std::numeric_limits<float>::infinity();
  // First at the length that it exceeds, then half way to its other length, which leaves colliders room to push.
  for (const float wanted : {gap.size - gap.excess, 0.5f * (link.longest + link.shortest)}) {
    for (const auto& around : kAround) {
      bone = before;
      for (int push = 0; push < kPushes; ++push) {
        aim(bone, place, wanted, push == 0 ? around.cosine : 1.0f, push == 0 ? around.sine : 0.0f);
        clear(b);
        const float left = std::fabs(gap_of(link).excess);
        if (left == 0.0f) return;
        if (left < least) best = bone;
        least = left < least ? left : least;
      }
    }
  }
  bone = best;
}

/// Goes to and fro through the links, then solves what remains bone by bone. Colliders come first: hair in a head shows
/// more.
void LinkedHead::hold_places(const LinkLevel& level) {
  const auto links = links_of(level);
  for (int round = 0; round < kPlaceRounds; ++round) {
    bool is_beyond = false;
    for (std::size_t i = 0; i < links.size(); ++i) {
      is_beyond = shorten(to_and_fro(links, round, i)) || is_beyond;
    }
    if (!is_beyond) return;
    for (std::uint32_t b = level.first_bone; b < level.first_bone + level.bone_count; ++b) {
      if (held_[b].is_turned) clear(b);
    }
  }
  for (HeldBone& bone : held_.subspan(level.first_bone, level.bone_count)) bone.is_forced = bone.is_turned;
  for (const ChainLink& link : links) close(link);
}

/// Keeps a link at its longest length from growing, and one at its shortest from shrinking. Returns the lost speed.
float LinkedHead::slow(const ChainLink& link) {
  HeldBone &bone = held_[link.bone], &to = held_[link.to];
  const Gap gap = gap_of(link);
  const float growing = dot(to.end_velocity - bone.end_velocity, gap.towards);
  const bool is_long = gap.size >= link.longest * (1 - kAtLength) && growing > 0.0f;
  const bool is_short = gap.size <= link.shortest * (1 + kAtLength) && growing < 0.0f;
  if (!is_long && !is_short) return 0;
  const Vec3 side = across(gap.towards, bone.direction), to_side = across(gap.towards, to.direction);
  const float yields = bone.mobility * dot(side, side) + to.mobility * dot(to_side, to_side);
  if (!(yields > kNoLever2 * (bone.mobility + to.mobility))) return 0;
  const float push = growing / yields;
  bone.velocity = bone.velocity + side * (push * bone.mobility);
  to.velocity = to.velocity - to_side * (push * to.mobility);
  bone.is_turned = to.is_turned = true;
  place_end(bone);
  place_end(to);
  return std::fabs(growing);
}

void LinkedHead::hold_velocities(const LinkLevel& level) {
  const auto links = links_of(level);
  for (int round = 0; round < kVelocityRounds; ++round) {
    float fastest = 0;
    for (std::size_t i = 0; i < links.size(); ++i) {
      if (const float taken = slow(to_and_fro(links, round, i)); taken > fastest) fastest = taken;
    }
    if (!(fastest > kSlowest)) return;
  }
}

}  // namespace

float hold_links(const LinkState& links, const LinkWork& work, std::int32_t lane) {
  return LinkedHead(links, work, lane).run();
}

}  // namespace coif
