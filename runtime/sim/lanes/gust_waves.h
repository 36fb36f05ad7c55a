#pragma once
// The gusts of coif/air.h as steps read them.

#include "lane_layout.h"

#include <coif/air.h>

#include <cstdint>

namespace coif {

inline constexpr std::uint32_t kGustWaves = 6;

/// sin(2 pi f) for |f| <= 1/2 is, but for f's sign, a polynomial in |f| (1/2 - |f|): from the highest power down to the
/// first, to 1e-5. Least squares in Chebyshev's points.
inline constexpr float kGustSine[] = {77.9606934f, 50.02286f, 12.5689141f};

/// Plane waves: each moves air by `air` sin(2 pi (turns place - turns_per_way way + begin)).
struct GustWaves {
  double turns[kGustWaves][3] = {};  ///< Per metre of place, world.
  double turns_per_way[kGustWaves] = {};
  double begin[kGustWaves] = {};
  Vec3 turns_near[kGustWaves];  ///< As `turns`, for what is near a head.
  Vec3 air[kGustWaves];         ///< m/s.
};

struct GustField {
  Gusts told;
  double way = 0;  ///< That the air has come, metres.
  GustWaves waves;
};

/// Sixteen heads in the gusts, during a part of a step.
struct GustLanes {
  Lanes turns[kGustWaves];  ///< Where each wave is at the head's position, from its place and `begin`; below 1.
  Lanes scale;              ///< Of the head: world metres for each of the hair's.
  Lanes strength;           ///< What the gusts' air is for the hair: exposure by scale.
};

/// What remains of `turns` without whole ones: -1/2..1/2; 0 from 1e15 turns on, where doubles have hardly any parts
/// left.
[[nodiscard]] float part_turn(double turns);

/// Of gusts that set_gusts() takes; `amplitude` and all.
[[nodiscard]] bool are_gusts(const Gusts& gusts);
[[nodiscard]] GustWaves waves_of(const Gusts& gusts);

}  // namespace coif
