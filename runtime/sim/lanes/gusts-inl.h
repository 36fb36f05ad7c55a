// Gusts at the start of a bone. Compiled once per instruction set.

#include "lane_math-inl.h"
#include "row.h"

#include <type_traits>

#if defined(COIF_SIM_LANES_GUSTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef COIF_SIM_LANES_GUSTS_INL_H_
#undef COIF_SIM_LANES_GUSTS_INL_H_
#else
#define COIF_SIM_LANES_GUSTS_INL_H_
#endif

HWY_BEFORE_NAMESPACE();
namespace coif {
namespace HWY_NAMESPACE {

/// False for hair that is not on a character, and where no gusts blow.
template <class D>
HWY_INLINE bool feels_gusts(D, const RowStep& row) {
  if constexpr (!kOnCharacter<D>)
    return false;
  else
    return row.character->gusts != nullptr;
}

/// The gusts' velocity, in the hair's metres per second, at `offset` from the head's position: world axes, the hair's
/// metres.
template <class D>
HWY_NOINLINE V3<D> gust_at(D d, const RowCharacter& character, std::size_t lane, const V3<D>& offset) {
  const GustLanes& heads = *character.gusts;
  const GustWaves& waves = *character.waves;
  const std::int32_t head = character.only_head;
  const auto of_head = [&](const Lanes& lanes) { return head < 0 ? load(d, lanes, lane) : hn::Set(d, lanes.v[head]); };
  const V3<D> place = scale(d, offset, of_head(heads.scale));
  const auto half = hn::Set(d, 0.5f), zero = hn::Zero(d);
  V3<D> sum{zero, zero, zero};
  for (std::uint32_t i = 0; i < kGustWaves; ++i) {
    const auto turns = hn::Add(of_head(heads.turns[i]), dot(d, place, same(d, waves.turns_near[i])));
    const auto part = hn::Sub(turns, hn::Round(turns)), size = hn::Abs(part), q = hn::Mul(size, hn::Sub(half, size));
    auto sine = hn::Add(hn::Mul(hn::Set(d, kGustSine[0]), q), hn::Set(d, kGustSine[1]));
    sine = hn::Mul(hn::Add(hn::Mul(sine, q), hn::Set(d, kGustSine[2])), q);
    sum = add_scaled(d, sum, same(d, waves.air[i]), hn::CopySign(sine, part));
  }
  return scale(d, sum, of_head(heads.strength));
}

/// The air at one bone of the passive model, which needs it several times.
template <class D>
struct BoneAir {
  V3<D> air;
  V3<D> end;  ///< End of the bone before the step, from the head's position, world axes.
};
struct NoBoneAir {};
template <class D>
using BoneAirOf = std::conditional_t<kOnCharacter<D>, BoneAir<D>, NoBoneAir>;

/// Finds the air at the start of bone `i` of `bones`, parents first. The start is as it was before the step, turned
/// with the head.
template <class D, class Bone>
HWY_INLINE void feel_air(D d, const RowStep& row, std::size_t lane, std::size_t i, const M3<D>& turn,
                         const V3<D>& direction, Bone* bones) {
  if constexpr (kOnCharacter<D>) {
    if (!feels_gusts(d, row)) return;
    const RowBone& shape = row.bones[i];
    const BoneLanes& constants = row.constants[i];
    BoneAir<D>& felt = bones[i].felt;
    const V3<D> start =
        shape.parent < 0 ? rotate(d, turn, load(d, constants.joint, lane)) : bones[shape.parent].felt.end;
    felt.end = add_scaled(d, start, direction, load(d, constants.length, lane));
    felt.air = load(d, row.move->air, lane);
    if ((shape.features & kRowFeelsAir) != 0) felt.air = add(d, felt.air, gust_at(d, *row.character, lane, start));
  }
}

/// Velocity of the air at the bone.
template <class D, class Bone>
HWY_INLINE V3<D> air_of(D d, const RowStep& row, std::size_t lane, const Bone& bone) {
  if constexpr (kOnCharacter<D>) {
    if (feels_gusts(d, row)) return bone.felt.air;
  }
  return load(d, row.move->air, lane);
}

}  // namespace HWY_NAMESPACE
}  // namespace coif
HWY_AFTER_NAMESPACE();

#endif
