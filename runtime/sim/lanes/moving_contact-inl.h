// Bones against moving colliders, and against those of their head at the same time. Compiled once per instruction set.
// The result of a lane depends only on its own numbers, never on its neighbours'.

#include <new>
#include <type_traits>

#include "coif_bone-inl.h"
#include "obstacles-inl.h"
#include "row.h"

#if defined(COIF_SIM_LANES_MOVING_CONTACT_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_MOVING_CONTACT_INL_H_
#undef COIF_SIM_LANES_MOVING_CONTACT_INL_H_
#else
#define COIF_SIM_LANES_MOVING_CONTACT_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// A bit for each lane, the first lane lowest.
template <class D>
HWY_INLINE std::uint32_t bits_of(D d, hn::Mask<D> mask) {
  alignas(64) float lanes[kLanes];
  hn::Store(hn::IfThenElseZero(mask, hn::Set(d, 1.0f)), d, lanes);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) bits |= lanes[i] > 0.0f ? 1u << i : 0u;
  return bits;
}

template <class D>
HWY_INLINE hn::Mask<D> lanes_of(D d, std::uint32_t bits) {
  alignas(64) float lanes[kLanes];
  for (std::size_t i = 0; i < hn::Lanes(d); ++i) lanes[i] = ((bits >> i) & 1u) != 0 ? 1.0f : 0.0f;
  return hn::Gt(hn::Load(d, lanes), hn::Zero(d));
}

/// The path of a pushed bone's end during a part of a step, head space: its places after each eighth of it. Its
/// children follow this path; on the straight way they would pass through the obstacle.
template <class D>
struct TailPath {
  static constexpr int kEighths = 8;
  V3<D> at[kEighths];
  hn::Mask<D> bent;      ///< The lanes with such a path; in the others the end moved straight.
  bool is_bent = false;  ///< Set if any lane is; else neither `at` nor `bent` is set.
};

/// A bone's way through a part of a step, as its colliders need it, head space.
template <class D>
struct BoneWay {
  V3<D> start[2];                           ///< At the part's start and end.
  V3<D> direction[2];                       ///< Unit; of the free motion.
  const TailPath<D>* start_path = nullptr;  ///< The start's path in between; null: straight.

  HWY_INLINE V3<D> start_at(D d, float s) const {
    const float eighths = s * float(TailPath<D>::kEighths);
    const V3<D> straight = add_scaled(d, start[0], sub(d, start[1], start[0]), hn::Set(d, s));
    if (start_path == nullptr) return straight;
    const int next = eighths < 7.0f ? int(eighths) : 7;
    const V3<D> from = next == 0 ? start[0] : start_path->at[next - 1];
    const V3<D> along = add_scaled(d, from, sub(d, start_path->at[next], from), hn::Set(d, eighths - float(next)));
    return choose<D>(start_path->bent, along, straight);
  }
};

/// Fills the eighths between the shares `from` and `to` of the part, where the tail moved straight.
template <class D>
HWY_INLINE void draw_path(D d, hn::Mask<D> own, const V3<D>& before, const V3<D>& now, float from, float to,
                          TailPath<D>& path) {
  for (int i = 0; i < TailPath<D>::kEighths; ++i) {
    const float s = float(i + 1) / float(TailPath<D>::kEighths);
    if (!(s > from && s <= to)) continue;
    const V3<D> place = add_scaled(d, before, sub(d, now, before), hn::Set(d, (s - from) / (to - from)));
    set_where(d, own, place, path.at[i]);
  }
}

/// The paths of those bones of a chain that still wait for children.
template <class D>
struct TailPaths {
  TailPath<D> of_slot[kMaxOpenBones];

  HWY_INLINE const TailPath<D>* from(const RowBone& bone) const {
    return bone.parent < 0 ? nullptr : &of_slot[bone.parent_slot];
  }
  HWY_INLINE TailPath<D>* own(const RowBone& bone) {
    return (bone.features & kRowHasChildren) != 0 ? &of_slot[bone.slot] : nullptr;
  }
};
struct NoPaths {};
template <class D>
using PathsOf = std::conditional_t<kOnCharacter<D>, TailPaths<D>, NoPaths>;

/// Moves one head's bones in the lanes of `own` through the part, with as many looks as the fastest collider needs.
template <class D>
COIF_RARE hn::Mask<D> pass_through(D d, const RowStep& row, std::size_t lane, std::size_t index, const BoneWay<D>& way,
                                   hn::Mask<D> own, Met<D>& met, LimitedBone<V<D>>* limited, TouchingBone<D>& bone,
                                   TailPath<D>& path) {
  const RowCharacter& character = *row.character;
  std::uint32_t looks = 1;
  const float share = character.to - character.from;
  for (std::uint32_t k = 0; k < met.count; ++k) {
    const auto needed = std::uint32_t(float(met.ways[k]->looks) * share + 0.999f);
    looks = needed > looks ? needed : looks;
  }
  const Obstacles<D> obstacles{row.colliders, row.bones[index].colliders, row.constants[index], lane, &met, met.count};
  auto moved = hn::AndNot(own, own);
  V3<D> free = way.direction[0], last = way.direction[0];
  V3<D> tail = add_scaled(d, way.start[0], last, bone.length);
  for (std::uint32_t look = 1; look <= looks; ++look) {
    const float s = float(look) / float(looks);
    const auto ahead = hn::Set(d, s);
    for (std::uint32_t k = 0; k < met.count; ++k) {
      place_at(*met.ways[k], character.from + s * share, *new (static_cast<void*>(&met.placed[k])) PlacedCollider);
    }
    copy(d, look == looks ? way.start[1] : way.start_at(d, s), bone.start);
    const V3<D> aim = add_scaled(d, way.direction[0], sub(d, way.direction[1], way.direction[0]), ahead);
    const V3<D> next = look == looks ? way.direction[1] : direction_or(d, aim, way.direction[1]);
    // From the place it was pushed to, it continues with its free motion.
    const V3<D> pushed = direction_or(d, add(d, last, sub(d, next, free)), next);
    copy(d, choose<D>(moved, pushed, next), bone.direction);
    copy(d, last, bone.before);
    // Its frame in between is not known.
    bone.limited = look == looks ? limited : nullptr;
    const int rounds = bone.limited == nullptr ? 2 * kContactRounds : kLimitedRounds;
    const auto touched = keep_clear_of_all(d, obstacles, own, rounds, bone);
    moved = hn::Or(moved, touched);
    if (!hn::AllFalse(d, touched)) leave_gap(d, obstacles, touched, bone);
    if (bone.limited != nullptr) keep_in_limit(d, moved, bone);
    copy(d, next, free);
    copy(d, bone.direction, last);
    const V3<D> now = add_scaled(d, bone.start, last, bone.length);
    draw_path(d, own, tail, now, float(look - 1) / float(looks), s, path);
    copy(d, now, tail);
  }
  return moved;
}

/// Lanes in which the bone may touch a moving collider: all, unless it is one of the asset's on the body.
template <class D>
HWY_INLINE hn::Mask<D> may_touch_body(D d, const RowCharacter& character, std::size_t lane, std::size_t index,
                                      const ColliderWay& way) {
  const auto zero = hn::Zero(d);
  if (way.place >= kMaxBodyColliders) return hn::Eq(zero, zero);
  const hn::RebindToUnsigned<D> du;
  const auto sets = hn::Load(du, character.body_sets + index * kLanes + lane);
  return hn::RebindMask(d, hn::TestBit(sets, hn::Set(du, 1u << way.place)));
}

/// The first lane of `all`, and the lanes of the same head that meet the same colliders. So the number of looks, and
/// with it every lane's bits, does not depend on the other lanes of the vector.
HWY_INLINE std::uint32_t alike(const RowCharacter& character, const std::uint32_t* bits, std::uint32_t all) {
  const std::uint32_t first = all & (0u - all);
  if (character.only_head < 0) return first;
  for (std::uint32_t k = 0; k < character.collider_count; ++k) all &= (bits[k] & first) != 0 ? bits[k] : ~bits[k];
  return all;
}

/// Collects the head's colliders that come near the bone in some lane of `own`. `bits` has a bit for each lane and near
/// collider.
template <class D>
HWY_INLINE void meet(D d, const RowStep& row, std::size_t lane, std::size_t index, const ColliderWay* ways,
                     const std::uint32_t* bits, std::uint32_t count, hn::Mask<D> own, std::uint32_t own_bits,
                     Met<D>& met) {
  const RowCharacter& character = *row.character;
  met.count = 0;
  for (std::uint32_t k = 0; k < count; ++k) {
    if ((bits[k] & own_bits) == 0) continue;
    const auto may_touch =
        hn::And(hn::And(own, lanes_of(d, bits[k])), may_touch_body(d, character, lane, index, ways[k]));
    if (hn::AllFalse(d, may_touch)) continue;
    met.ways[met.count] = &ways[k];
    met.lanes[met.count] = may_touch;
    ++met.count;
  }
}

/// Lanes in which the bone comes near the moving collider `k` of its head, in any direction.
template <class D>
HWY_INLINE hn::Mask<D> is_near(D d, const RowCharacter& character, std::size_t lane, std::uint32_t k,
                               const V3<D>& start, V<D> reach) {
  const ColliderBounds& bounds = character.bounds[k];
  V3<D> center;
  auto radius = hn::Zero(d);
  if (character.only_head >= 0) {
    const auto i = std::uint32_t(character.only_head);
    copy(d, same(d, coif::lane(bounds.center, i)), center);
    radius = hn::Set(d, bounds.radius.v[i]);
  } else {
    copy(d, load(d, bounds.center, lane), center);
    radius = load(d, bounds.radius, lane);
  }
  const V3<D> offset = sub(d, start, center);
  const auto farthest = hn::Add(radius, reach);
  return hn::Lt(dot(d, offset, offset), hn::Mul(farthest, farthest));
}

/// keep_clear_of() for moving colliders. `from_path` is the path of the carrier, `own_path` receives that for its
/// children; both may be null.
template <class D>
COIF_RARE hn::Mask<D> keep_clear_of_moving(D d, const RowStep& row, std::size_t lane, const M3<D>& turn,
                                           std::size_t index, const Carrier<D>& from, const V3<D>& before,
                                           const TailPath<D>* from_path, TailPath<D>* own_path,
                                           LimitedBone<V<D>>* limited, BoneMotion<D>& now, V3<D>& direction) {
  const RowCharacter& character = *row.character;
  const MoveLanes& move = *row.move;
  const BoneLanes& constants = row.constants[index];
  const M3<D> turn_before = load(d, move.from_head_before, lane);
  BoneWay<D> way;
  const V3<D> went = sub(d, from.way, load(d, move.way, lane));
  copy(d, rotate_back(d, turn_before, sub(d, rotate(d, turn, from.position), went)), way.start[0]);
  copy(d, from.position, way.start[1]);
  copy(d, rotate_back(d, turn_before, before), way.direction[0]);
  copy(d, direction, way.direction[1]);
  if (from_path != nullptr && from_path->is_bent) way.start_path = from_path;
  TailPath<D> path;
  TouchingBone<D> bone;
  bone.length = load(d, constants.length, lane);
  bone.hit_radius = load(d, constants.hit_radius, lane);
  copy(d, rotate_back(d, turn, now.velocity), bone.velocity);
  copy(d, rotate_back(d, turn, sub(d, from.velocity, load(d, move.velocity, lane))), bone.start_velocity);
  copy(d, rotate_back(d, turn, load(d, move.angular_velocity, lane)), bone.head_turning);

  const V3<D> start_way = sub(d, way.start[1], way.start[0]);
  auto travel = hn::Sqrt(dot(d, start_way, start_way));
  if (way.start_path != nullptr) travel = hn::IfThenElse(way.start_path->bent, hn::Add(travel, travel), travel);
  const auto reach = hn::Add(hn::Add(bone.length, bone.hit_radius), travel);
  const std::uint32_t used = (1u << row.lanes) - 1u;
  std::uint32_t bits[kMaxPlaces], all = 0;
  for (std::uint32_t k = 0; k < character.collider_count; ++k) {
    auto near = is_near(d, character, lane, k, from.position, reach);
    if (character.only_head >= 0)
      near = hn::And(near, may_touch_body(d, character, lane, index, character.of_lane[lane][k]));
    bits[k] = bits_of(d, near) & (used >> lane);
    all |= bits[k];
  }
  auto moved = hn::Lt(bone.length, hn::Zero(d));
  const V3<D> velocity = bone.velocity;
  Met<D> met;
  while (all != 0) {
    const std::uint32_t own_bits = alike(character, bits, all);
    const std::size_t first = lane + std::size_t(std::countr_zero(own_bits));
    all &= ~own_bits;
    const auto own = lanes_of(d, own_bits);
    meet(d, row, lane, index, character.of_lane[first], bits, character.counts[first], own, own_bits, met);
    if (met.count == 0) continue;
    copy(d, velocity, bone.velocity);
    if (!path.is_bent) {
      path.is_bent = true;
      path.bent = hn::AndNot(own, own);
      const V3<D> tail_before = add_scaled(d, way.start[0], way.direction[0], bone.length);
      const V3<D> tail = add_scaled(d, way.start[1], way.direction[1], bone.length);
      draw_path(d, hn::Ge(bone.length, hn::Zero(d)), tail_before, tail, 0.0f, 1.0f, path);
    }
    path.bent = hn::Or(path.bent, own);
    const auto touched = pass_through(d, row, lane, index, way, own, met, limited, bone, path);
    const auto here = hn::And(own, touched);
    moved = hn::Or(moved, here);
    set_where(d, here, bone.direction, direction);
    set_where(d, here, rotate(d, turn, bone.direction), now.direction);
    set_where(d, here, rotate(d, turn, bone.velocity), now.velocity);
  }
  if (own_path == nullptr) return moved;
  // Comes last, since it may overwrite the other path.
  own_path->is_bent = path.is_bent;
  if (path.is_bent) own_path->bent = path.bent;
  for (int i = 0; path.is_bent && i < TailPath<D>::kEighths; ++i) copy(d, path.at[i], own_path->at[i]);
  return moved;
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
