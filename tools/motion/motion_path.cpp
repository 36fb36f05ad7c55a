#include "motion/motion_path.h"

#include <cmath>
#include <iterator>
#include <numbers>

namespace coif::motion {
namespace {

using Eigen::Vector3d;

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kGravity = 9.81;

/// Goes from 0 to 1 within about a second: an oscillation times this starts without a kick.
Jet ramp(const Jet& t) { return 1.0 - exp(-4.0 * t); }

Jet wave(double hertz, const Jet& t) { return ramp(t) * sin(kTwoPi * hertz * t); }

HeadMovement turning(const Vector3d& axis, const Jet& radians) {
  HeadMovement moved;
  moved.axis = axis;
  moved.turn = radians;
  return moved;
}

HeadMovement nod(const Jet& t) { return turning(Vector3d::UnitX(), 0.7 * wave(0.77, t)); }

HeadMovement turn(const Jet& t) { return turning(Vector3d::UnitY(), wave(1.54, t)); }

constexpr double kSpeedUp = 0.3;  // seconds

HeadMovement charge(const Jet& t, double inside) {
  constexpr double kSpeed = 8.0;
  HeadMovement moved;
  moved.z = inside < kSpeedUp ? 0.5 * kSpeed / kSpeedUp * t * t : kSpeed * (t - 0.5 * kSpeedUp);
  return moved;
}

HeadMovement run(const Jet& t) {
  constexpr double kStride = 2.387, kSway = 0.385;  // Hz
  HeadMovement moved = turning(Vector3d::UnitX(), 0.1 * wave(kStride, t));
  moved.y = 0.06 * wave(kStride, t);
  moved.z = 3.0 / (kTwoPi * kSway) * wave(kSway, t);
  return moved;
}

HeadMovement jog(const Jet& t) {
  constexpr double kSteps = 2.4, kBob = 0.045, kLean = std::numbers::pi / 180;  // Hz, metres, radians
  HeadMovement moved = turning(Vector3d::UnitZ(), kLean * wave(kSteps / 2, t));
  moved.y = kBob * wave(kSteps, t);
  return moved;
}

/// A point of a path in time. Between two points the path is the cubic with both heights and speeds, which for constant
/// acceleration (pushing off, flying, landing) is the exact parabola.
struct JumpKnot {
  double seconds, height, speed;
};

Jet between(const JumpKnot& a, const JumpKnot& b, const Jet& t) {
  const double span = b.seconds - a.seconds;
  const Jet u = (t - a.seconds) * (1 / span);
  const Jet u2 = u * u, u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * a.height + (u3 - 2 * u2 + u) * (span * a.speed) + (3 * u2 - 2 * u3) * b.height +
         (u3 - u2) * (span * b.speed);
}

/// One jump after the other.
struct JumpKnots {
  static constexpr double kCrouch = 0.25, kHeight = 0.45;     // metres
  const double take_off = std::sqrt(2 * kGravity * kHeight);  // m/s
  const double push = 2 * kCrouch / take_off;                 // seconds at constant acceleration
  const double lift = 0.4 + push;                             // seconds, as is the next
  const double landing = lift + 2 * take_off / kGravity;
  const JumpKnot knots[7] = {{0, 0, 0},
                             {0.4, -kCrouch, 0},
                             {lift, 0, take_off},
                             {landing, 0, -take_off},
                             {landing + push, -kCrouch, 0},
                             {landing + push + 0.5, 0, 0},
                             {landing + push + 0.8, 0, 0}};
  [[nodiscard]] double period() const { return std::end(knots)[-1].seconds; }
};

HeadMovement jump(const Jet& t, double inside) {
  const JumpKnots jumps;
  const double begun = std::floor(inside / jumps.period()) * jumps.period();
  const JumpKnot* next = jumps.knots + 1;
  while (next + 1 < std::end(jumps.knots) && next->seconds < inside - begun) ++next;
  HeadMovement moved;
  moved.y = between(next[-1], *next, t - begun);
  return moved;
}

constexpr double kTumblePeriod = 1.5, kRoll = 0.8;  // seconds

HeadMovement tumble(const Jet& t, double inside) {
  const double begun = std::floor(inside / kTumblePeriod) * kTumblePeriod;
  const Jet u = inside - begun < kRoll ? (t - begun) * (1 / kRoll) : Jet(1.0);
  const Jet hop = sin(std::numbers::pi * u);
  HeadMovement moved = turning(Vector3d::UnitX(), kTwoPi * u * u * (3 - 2 * u));
  moved.y = hop * hop;
  return moved;
}

/// Goes from 0 to 1 between the two times, without a jump of velocity.
Jet eased(const Jet& t, double inside, double from, double to) {
  if (inside < from) return 0.0;
  if (inside >= to) return 1.0;
  const Jet u = (t - from) * (1 / (to - from));
  return u * u * (3 - 2 * u);
}

/// Times at which a bow goes down, stays, and comes up; seconds.
constexpr double kBowPeriod = 2.8, kDown = 0.8, kUp = 1.4, kUpright = 2.2;

HeadMovement bow(const Jet& t, double inside) {
  const double begun = std::floor(inside / kBowPeriod) * kBowPeriod;
  const Jet u = t - begun;
  const Jet bent = eased(u, inside - begun, 0, kDown) - eased(u, inside - begun, kUp, kUpright);
  HeadMovement moved = turning(Vector3d::UnitX(), kTwoPi / 3 * bent);
  moved.y = -0.5 * bent;
  moved.z = 0.4 * bent;
  return moved;
}

constexpr double kLying = 0.8;  // seconds

HeadMovement lie(const Jet& t, double inside) {
  const Jet down = eased(t, inside, 0, kLying);
  HeadMovement moved = turning(Vector3d::UnitX(), -kTwoPi / 4 * down);
  moved.y = -1.4 * down;
  moved.z = -0.8 * down;
  return moved;
}

constexpr double kJumpAway = 1, kTurnRound = 2;  // seconds

HeadMovement teleport(double inside) {
  HeadMovement moved = turning(Vector3d::UnitY(), inside < kTurnRound ? 0.0 : std::numbers::pi);
  moved.x = inside < kJumpAway ? 0.0 : 10.0;
  return moved;
}

void repeat(const std::vector<double>& offsets, double period, double until, std::vector<PathBreak>& breaks) {
  for (int cycle = 0; cycle * period <= until; ++cycle) {
    for (const double offset : offsets) {
      if (const double at = cycle * period + offset; at <= until) breaks.push_back({at, false});
    }
  }
}

}  // namespace

HeadMovement movement(Motion motion, double seconds, double inside) {
  const Jet t = Jet::time(seconds);
  switch (motion) {
    case Motion::kStill: return {};
    case Motion::kNod: return nod(t);
    case Motion::kTurn: return turn(t);
    case Motion::kCharge: return charge(t, inside);
    case Motion::kRun: return run(t);
    case Motion::kJump: return jump(t, inside);
    case Motion::kTumble: return tumble(t, inside);
    case Motion::kTeleport: return teleport(inside);
    case Motion::kBow: return bow(t, inside);
    case Motion::kLie: return lie(t, inside);
    case Motion::kJog: return jog(t);
  }
  return {};
}

std::vector<PathBreak> breaks_of(Motion motion, double until) {
  std::vector<PathBreak> breaks;
  if (motion == Motion::kCharge && kSpeedUp <= until) breaks.push_back({kSpeedUp, false});
  if (motion == Motion::kBow) repeat({kDown, kUp, kUpright, kBowPeriod}, kBowPeriod, until, breaks);
  if (motion == Motion::kLie && kLying <= until) breaks.push_back({kLying, false});
  if (motion == Motion::kTumble) repeat({kRoll, kTumblePeriod}, kTumblePeriod, until, breaks);
  if (motion == Motion::kJump) {
    const JumpKnots jumps;
    std::vector<double> offsets;
    for (const JumpKnot* knot = jumps.knots + 1; knot != std::end(jumps.knots); ++knot)
      offsets.push_back(knot->seconds);
    repeat(offsets, jumps.period(), until, breaks);
  }
  if (motion == Motion::kTeleport) {
    for (const double at : {kJumpAway, kTurnRound}) {
      if (at <= until) breaks.push_back({at, true});
    }
  }
  return breaks;
}

}  // namespace coif::motion
