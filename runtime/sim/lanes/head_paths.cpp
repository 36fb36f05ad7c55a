#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "lanes/head_paths.cpp"
#include <hwy/foreach_target.h>

#include "head_path-inl.h"
#include "lane_code.h"

#include <limits>

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {
namespace {

template <class D>
struct Heads {
  static bool look_ahead(const HeadLanes& heads, std::uint32_t lanes, const StepParts& parts, HeadStepLanes& step) {
    const D d;
    bool some = false;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
      some = !hn::AllFalse(d, HWY_NAMESPACE::look_ahead(d, heads, parts, i, step)) || some;
    }
    return some;
  }

  static void begin(HeadLanes& heads, std::uint32_t lanes, const StepParts& parts, HeadStepLanes& step) {
    const D d;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) begin_path(d, heads, parts, i, step);
  }

  /// A part starts at the place and velocity at which the one before ended.
  static HWY_INLINE void go_on(D d, const HeadLanes& heads, float inertia, std::uint32_t part, std::size_t i,
                               MoveLanes& move) {
    if (part == 0) {
      const auto share = hn::Set(d, inertia);
      const V3<D> velocity = scale(d, load(d, heads.velocity, i), load(d, heads.per_scale, i));
      store(d, load(d, heads.rotation, i), move.rotation_before, i);
      store(d, scale(d, velocity, share), move.velocity_before, i);
      store(d, scale(d, load(d, heads.angular_velocity, i), share), move.angular_velocity_before, i);
      return;
    }
    store(d, load(d, move.rotation, i), move.rotation_before, i);
    store(d, load(d, move.velocity, i), move.velocity_before, i);
    store(d, load(d, move.angular_velocity, i), move.angular_velocity_before, i);
  }

  static void move(const HeadLanes& heads, std::uint32_t lanes, const HeadStepLanes& step, const StepParts& parts,
                   std::uint32_t part, MoveLanes& move, Lanes4& carried) {
    const D d;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
      go_on(d, heads, parts.inertia, part, i, move);
      follow_path(d, heads, step, parts, part, i, move);
      if (parts.inertia < 1.0f) store(d, share_motion(d, parts.inertia, i, move), carried, i);
      complete_move(d, parts, load(d, heads.per_scale, i), i, move);
    }
  }

  static HWY_INLINE std::uint32_t bits_of(hn::Mask<D> mask) {
    std::uint8_t bytes[8] = {};  // As many as any instruction set writes at least.
    hn::StoreMaskBits(D(), mask, bytes);
    return std::uint32_t(bytes[0] | bytes[1] << 8);
  }

  /// Where all velocities are numbers whose squares are numbers, too.
  static HWY_INLINE hn::Mask<D> is_sound(D d, const HeadLanes& heads, std::size_t i) {
    auto sum2 = hn::Zero(d);
    for (const Lanes3* const vector :
         {&heads.velocity, &heads.angular_velocity, &heads.mean_velocity, &heads.mean_angular_velocity}) {
      const V3<D> v = load(d, *vector, i);
      sum2 = hn::Add(sum2, dot(d, v, v));
    }
    return hn::Le(sum2, hn::Set(d, std::numeric_limits<float>::max()));
  }

  static RestingHeads finish(HeadLanes& heads, std::uint32_t lanes, const HeadStepLanes& step, const Lanes& motions,
                             const RestWatch& watch) {
    const D d;
    RestingHeads resting;
    for (std::size_t i = 0; i < lanes; i += hn::Lanes(d)) {
      finish_path(d, heads, i, step);
      const auto motion = load(d, motions, i);
      resting.may_sleep |= bits_of(watch_rest(d, heads, i, motion, watch)) << i;
      const auto stays = hn::And(hn::Lt(motion, hn::Set(d, kFastest2)), is_sound(d, heads, i));
      resting.flies |= bits_of(hn::Not(stays)) << i;
    }
    return resting;
  }

  static void spread(const MoveLanes& from, std::uint32_t lane, MoveLanes& to) {
    const D d;
    const Lanes* const source = reinterpret_cast<const Lanes*>(&from);
    Lanes* const goal = reinterpret_cast<Lanes*>(&to);
    for (std::size_t n = 0; n < sizeof(MoveLanes) / sizeof(Lanes); ++n) {
      const auto value = hn::Set(d, source[n].v[lane]);
      for (std::size_t i = 0; i < kLanes; i += hn::Lanes(d)) store(d, value, goal[n], i);
    }
  }
};

template <class D>
HeadCode code_of() {
  return {&Heads<D>::look_ahead, &Heads<D>::begin, &Heads<D>::move, &Heads<D>::finish, &Heads<D>::spread};
}

HeadCode follow_heads() { return code_of<Widest>(); }

#if COIF_HAS_SINGLY
HeadCode follow_heads_singly() { return code_of<Single>(); }
#endif

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace coif {
namespace {
COIF_CHOOSE(choose_code, follow_heads)
}  // namespace

HeadCode head_code(InstructionSet set) {
  const auto code = choose_code(set);
  return code != nullptr ? code() : HeadCode{};
}

}  // namespace coif
#endif
