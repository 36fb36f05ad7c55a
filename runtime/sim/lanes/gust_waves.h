#pragma once
// The gusts of coif/air.h in the form that steps read.

#include "lane_layout.h"

#include <coif/air.h>

#include <cstdint>

namespace coif {

inline constexpr std::uint32_t kGustWaves = 6;

/// Coefficients of sin(2 pi f) for |f| <= 1/2: up to f's sign a polynomial in |f| (1/2 - |f|), from the highest power
/// down to the first, to 1e-5. Least squares at Chebyshev points.
inline constexpr float kGustSine[] = {77.9606934f, 50.02286f, 12.5689141f};

/// Plane waves. Each moves air by `air` sin(2 pi (turns place - turns_per_way way + begin)).
struct GustWaves {
  double turns[kGustWaves][3] = {};  ///< Per metre of place, world.
  double turns_per_way[kGustWaves] = {};
  double begin[kGustWaves] = {};
  Vec3 turns_near[kGustWaves];  ///< As `turns`, for places relative to a head.
  Vec3 air[kGustWaves];         ///< m/s.
};

struct GustField {
  Gusts told;
  double way = 0;  ///< How far the air has come, metres.
  GustWaves waves;
};

/// The gusts at sixteen heads, during a part of a step.
struct GustLanes {
  Lanes turns[kGustWaves];  ///< The phase of each wave at the head's position, from its place and `begin`; below 1.
  Lanes scale;              ///< The head's scale: world metres for each of the hair's.
  Lanes strength;           ///< Factor from the gusts' air to the hair's: exposure over scale.
};

/// The fractional part of `turns`, -1/2..1/2; 0 from 1e15 turns on, where doubles have hardly any digits left.
[[nodiscard]] float part_turn(double turns);

/// Whether set_gusts() accepts these gusts, `amplitude` included.
[[nodiscard]] bool are_gusts(const Gusts& gusts);
[[nodiscard]] GustWaves waves_of(const Gusts& gusts);

}  // namespace coif
