#pragma once
// The air around heads and what it does to hair, in addition to the wind that blows everywhere: see HairWorld in
// coif/hair_world.h, "Air".

#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::uint32_t kMaxDynamicsSets = 8;
inline constexpr float kMostGust = 1000.0f;    ///< Largest Gusts::amplitude and Gusts::speed, m/s.
inline constexpr float kShortestGust = 0.05f;  ///< Smallest Gusts::length, metres.
inline constexpr float kLongestGust = 1e4f;    ///< Largest Gusts::length, metres.

/// The air around one head.
struct HeadAir {
  Vec3 wind{};  ///< Added to the settings' wind, world, m/s: a fan, a vehicle, a draught.
  /// 0..1: the share of the weather (the settings' wind and the gusts) that reaches the head; 0 indoors.
  float exposure = 1.0f;
};

/// Turbulence that the wind carries along: a pattern that stands still in air that moves at `speed` in `direction`. So
/// a gust reaches a chain further down the wind later, by the time that the way takes. It is a sum of six plane waves.
/// Wave i = 0..5:
///
///     wavelength   length / 1.6^i            from gusts to flutter
///     runs         at an angle a(i) from `direction`, at most 40 degrees, to both sides and up and down
///     moves air    along `direction`, and 0.4 as much across, to the left or right
///     amplitude    in proportion to wavelength^(1/3): Kolmogorov's law for differences of velocity over a distance
///     phase        and angles by `seed`
///
/// Its mean over time is zero in every place, and it never exceeds `amplitude`. Half of that is a strong gust; the root
/// mean square along `direction` is 0.28 of it.
struct Gusts {
  float amplitude = 0;       ///< m/s, 0..kMostGust; 0: none.
  float length = 1.5f;       ///< Metres, kShortestGust..kLongestGust.
  float speed = 3.0f;        ///< m/s, 0..kMostGust; usually the wind's speed.
  Vec3 direction{0, 0, -1};  ///< World, any length > 0; usually the wind's direction.
  std::uint32_t seed = 0;
};

/// Velocity of the gusts' air at a world place (metres), m/s. `way`: how many metres the air has come since its
/// beginning, speed times time, as Hair::gusts_way() says. Hair feels the same there, to 1e-4 of the amplitude. Zero
/// for gusts that set_gusts() would refuse.
[[nodiscard]] COIF_API Vec3 gust_at(const Gusts& gusts, double way, const double (&place)[3]);

/// The same at many places, given as offsets from a near one, for a game's cloth and grass: a tenth of the time for
/// each place. On kSizeMismatch, or kBadArgument for gusts that set_gusts() would refuse, `air` is unchanged.
COIF_API Status gusts_near(const Gusts& gusts, double way, const double (&place)[3], std::span<const Vec3> offsets,
                           std::span<Vec3> air);

/// Changes the speed of hair at once, within `radius` of a ball's centre or a capsule's segment: fully in the middle,
/// not at all at the surface, linearly in between. World space.
struct Impulse {
  double center[3] = {0, 0, 0};  ///< The ball's centre, or one end of the capsule's segment, metres.
  Vec3 axis{};                   ///< To the segment's other end, metres; zero for a ball.
  float radius = 1;              ///< Metres, > 0.
  float speed = 0;               ///< m/s, away from the middle, as an explosion; negative: towards it.
  Vec3 velocity{};               ///< m/s, as a blow or a hand.
  /// False: `velocity` is added to the hair's own. True: the hair takes on `velocity`, as under a hand that strokes it.
  bool strokes = false;
};

}  // namespace coif
