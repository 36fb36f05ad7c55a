#pragma once
// The air around heads and what it does to hair, besides the wind that blows everywhere: see Hair in coif/hair.h,
// "Air".

#include <coif/export.h>
#include <coif/math.h>
#include <coif/status.h>

#include <cstdint>
#include <span>

namespace coif {

inline constexpr std::uint32_t kMaxDynamicsSets = 8;
inline constexpr float kMostGust = 1000.0f;    ///< The most that Gusts::amplitude and Gusts::speed may be, m/s.
inline constexpr float kShortestGust = 0.05f;  ///< The least that Gusts::length may be, metres,
inline constexpr float kLongestGust = 1e4f;    ///< and the most.

/// The air around one head.
struct HeadAir {
  Vec3 wind{};            ///< Besides the weather's, world, m/s: of a fan, a vehicle, a draught.
  float exposure = 1.0f;  ///< 0..1: of the weather, which is the settings' wind and the gusts, this share reaches the
                          ///< head; 0 indoors.
};

/// Turbulence that the wind carries along: a pattern that stands still in air that moves at `speed` in `direction`, so
/// that a gust that bends one chain bends the next one down the wind as much later as the way takes. It is a sum of six
/// plane waves. Wave i = 0..5:
///
///     wavelength   length / 1.6^i            from gusts to flutter
///     runs         at an angle a(i) from `direction`, at most 40 degrees, to both sides and up and down
///     moves air    along `direction`, and 0.4 as much across, to the left or right
///     amplitude    in proportion to wavelength^(1/3): Kolmogorov's law for differences of velocity over a distance
///     phase        and angles by `seed`
///
/// Its mean over time is zero in every place, and nowhere does it exceed `amplitude`; half of that is a strong gust,
/// 0.28 of it the root mean square along `direction`.
struct Gusts {
  float amplitude = 0;       ///< m/s, 0..kMostGust; 0: none.
  float length = 1.5f;       ///< Metres, kShortestGust..kLongestGust.
  float speed = 3.0f;        ///< m/s, 0..kMostGust; that of the wind, say.
  Vec3 direction{0, 0, -1};  ///< World, any length > 0; that of the wind, say.
  std::uint32_t seed = 0;
};

/// Velocity of the gusts' air at a world place (metres), m/s, when it has come `way` metres since its beginning: its
/// speed times the time, as Hair::gusts_way() tells. What hair feels there, to 1e-4 of the amplitude. Zero for gusts
/// that set_gusts() would refuse.
[[nodiscard]] COIF_API Vec3 gust_at(const Gusts& gusts, double way, const double (&place)[3]);

/// The same at many places, given from one near them, for a game's cloth and grass: a tenth of the time each.
/// kSizeMismatch, or kBadArgument for gusts that set_gusts() would refuse; then `air` stays.
COIF_API Status gusts_near(const Gusts& gusts, double way, const double (&place)[3], std::span<const Vec3> offsets,
                           std::span<Vec3> air);

/// What changes the speed of hair at once, within `radius` of a ball or capsule: by most at its middle, by nothing at
/// its surface, evenly in between. World space.
struct Impulse {
  double center[3] = {0, 0, 0};  ///< The ball's centre, or one end of the capsule's segment, metres.
  Vec3 axis{};                   ///< To the segment's other end, metres; none for a ball.
  float radius = 1;              ///< Metres, > 0.
  float speed = 0;               ///< m/s, away from the middle: of an explosion; negative: towards it.
  Vec3 velocity{};               ///< m/s: of a blow, or of a hand.
  /// False: `velocity` is added to what the hair has. True: the hair takes it on, as under a hand that strokes it.
  bool strokes = false;
};

}  // namespace coif
