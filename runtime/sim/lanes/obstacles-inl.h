// The colliders of its head and moving ones that a bone on a character may touch at one moment, and the code that gets
// it clear of all. Compiled once per instruction set.

#include "contact-inl.h"
#include "escape-inl.h"
#include "row.h"
#include "solid_box-inl.h"

#if defined(COIF_SIM_LANES_OBSTACLES_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_OBSTACLES_INL_H_
#undef COIF_SIM_LANES_OBSTACLES_INL_H_
#else
#define COIF_SIM_LANES_OBSTACLES_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// The moving colliders of one head that a bone may meet, at one moment.
template <class D>
struct Met {
  Met() {}  ///< Not initialised: clearing room for all would cost more than the one collider that is mostly met.

  std::uint32_t count = 0;
  const ColliderWay* ways[kMaxPlaces];
  hn::Mask<D> lanes[kMaxPlaces];  ///< Lanes of the head's chains that may touch it.
  union {
    PlacedCollider placed[kMaxPlaces];
  };
};

/// Removes the velocity of the contact's point into a moving surface, and gives it the surface's. A surface throws a
/// bone over a lever of at least a quarter of the bone, so speeds grow at most fourfold.
template <class D>
HWY_INLINE void go_along(D d, hn::Mask<D> touches, const Contact<D>& contact, const ColliderWay& way,
                         const Vec3& center, TouchingBone<D>& bone) {
  const auto zero = hn::Zero(d), one = hn::Set(d, 1.0f);
  const auto share = hn::Max(hn::Div(contact.along, bone.length), hn::Set(d, 0.25f));
  const V3<D> side = across(d, contact.normal, bone.direction);
  const auto size2 = dot(d, side, side);
  const V3<D> point = add_scaled(d, bone.start, bone.direction, contact.along);
  const V3<D> turned = cross(d, same(d, way.turning), sub(d, point, same(d, center)));
  const V3<D> surface = add(d, cross(d, bone.head_turning, point), add(d, same(d, way.velocity), turned));
  const V3<D> velocity = add_scaled(d, sub(d, bone.start_velocity, surface), bone.velocity, share);
  const auto approach = dot(d, velocity, contact.normal);
  const auto stops = hn::And(touches, hn::And(hn::Gt(size2, hn::Set(d, 1e-3f)), hn::Lt(approach, zero)));
  const auto taken = hn::Div(approach, hn::Mul(share, hn::IfThenElse(stops, size2, one)));
  set_where(d, stops, sub_scaled(d, bone.velocity, side, taken), bone.velocity);
}

/// The colliders of its asset and the moving ones that a bone of one head may touch.
template <class D>
struct Obstacles {
  const PlacedColliders* fixed;  ///< Null: none.
  std::uint32_t fixed_set;
  const BoneLanes& constants;
  std::size_t lane;
  const Met<D>* moving;  ///< Null: none.
  std::uint32_t moving_count;
};

/// Turns bones out of one collider after the other until none touches more than one, or for the given number of rounds.
/// Returns the lanes that touched any. (One loop for both kinds, so that the code exists once.)
template <class D>
COIF_RARE hn::Mask<D> keep_clear_of_all(D d, const Obstacles<D>& obstacles, hn::Mask<D> here, int rounds,
                                        TouchingBone<D>& bone) {
  const auto one = hn::Set(d, 1.0f);
  auto takes_part = here, moved = hn::AndNot(here, here);
  for (int round = 0; round < rounds; ++round) {
    auto touched = hn::Zero(d);
    std::uint32_t left = obstacles.fixed_set;
    for (std::uint32_t k = 0; left != 0 || k < obstacles.moving_count;) {
      const bool is_fixed = left != 0;
      const std::uint32_t i = is_fixed ? std::uint32_t(std::countr_zero(left)) : k++;
      if (is_fixed) left &= left - 1u;
      const PlacedCollider& collider = is_fixed ? (*obstacles.fixed)[i] : obstacles.moving->placed[i];
      const auto may_touch =
          is_fixed ? lanes_with(d, obstacles.constants, obstacles.lane, i) : obstacles.moving->lanes[i];
      Contact<D> contact;
      const V3<D> inside = bone.direction;
      const auto touches = clear_of(d, hn::And(takes_part, may_touch), collider, bone, contact);
      if (hn::AllFalse(d, touches)) continue;
      moved = hn::Or(moved, touches);
      touched = hn::Add(touched, hn::IfThenElseZero(touches, one));
      set_where(d, touches, across(d, bone.velocity, bone.direction), bone.velocity);
      if (is_fixed) touched = hn::Add(touched, stop_at_contact(d, touches, collider, contact, inside, bone));
      if (!is_fixed) go_along(d, touches, contact, *obstacles.moving->ways[i], collider.center, bone);
    }
    if (bone.limited != nullptr) {
      const auto beyond = keep_in_limit(d, hn::And(takes_part, hn::Gt(touched, hn::Zero(d))), bone);
      touched = hn::Add(touched, hn::IfThenElseZero(beyond, one));
    }
    takes_part = hn::And(takes_part, hn::Gt(touched, one));
    bone.dt = 0;
    if (HWY_LIKELY(hn::AllFalse(d, takes_part))) break;
  }
  return moved;
}

/// For a bone that still lies in something: turns it to the nearest of the tried directions in which it does not.
template <class D>
COIF_RARE void leave_gap(D d, const Obstacles<D>& obstacles, hn::Mask<D> moved, TouchingBone<D>& bone) {
  const auto is_blocked = [&](hn::Mask<D> asked, const V3<D>& direction) {
    auto blocked = hn::AndNot(asked, asked);
    for (std::uint32_t left = obstacles.fixed_set; left != 0; left &= left - 1) {
      const std::uint32_t i = std::uint32_t(std::countr_zero(left));
      const auto those = hn::And(asked, lanes_with(d, obstacles.constants, obstacles.lane, i));
      blocked = hn::Or(blocked, lies_in(d, those, (*obstacles.fixed)[i], bone, direction));
    }
    for (std::uint32_t k = 0; k < obstacles.moving_count; ++k) {
      const auto those = hn::And(asked, obstacles.moving->lanes[k]);
      blocked = hn::Or(blocked, lies_in(d, those, obstacles.moving->placed[k], bone, direction));
    }
    if (bone.limited != nullptr) {
      TouchingBone<D> turned = bone;
      copy(d, direction, turned.direction);
      blocked = hn::Or(blocked, keep_in_limit(d, asked, turned));
    }
    return blocked;
  };
  const auto stuck = is_blocked(moved, bone.direction);
  if (HWY_LIKELY(hn::AllFalse(d, stuck))) return;
  escape(d, stuck, is_blocked, bone.direction);
  set_where(d, stuck, across(d, bone.velocity, bone.direction), bone.velocity);
}

/// keep_clear() by the code that exists anyway.
template <class D>
HWY_INLINE hn::Mask<D> keep_clear(OnCharacter<D> d, const PlacedColliders& colliders, std::uint32_t set,
                                  const BoneLanes& constants, std::size_t lane, hn::Mask<OnCharacter<D>> reached,
                                  TouchingBone<OnCharacter<D>>& bone) {
  const Obstacles<OnCharacter<D>> obstacles{&colliders, set, constants, lane, nullptr, 0};
  const int rounds = bone.limited == nullptr ? kContactRounds : kLimitedRounds;
  return keep_clear_of_all(d, obstacles, reached, rounds, bone);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
