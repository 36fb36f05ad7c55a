#include "motion/motion.h"

#include <cmath>
#include <iterator>
#include <numbers>

namespace coif {
namespace {

constexpr double kTwoPi = 2.0 * std::numbers::pi;
constexpr double kGravity = 9.81;

constexpr MotionInfo kMotions[] = {
    {Motion::kStill, "still", "no movement: the hair sags under gravity and settles"},
    {Motion::kNod, "nod", "nods 40 deg up and down about X at 0.77 Hz"},
    {Motion::kTurn, "turn", "shakes the head 57 deg to each side about Y at 1.54 Hz"},
    {Motion::kCharge, "charge", "from 0 to 8 m/s forward (+Z) in 0.3 s, then steady"},
    {Motion::kRun, "run", "bobs 6 cm and nods 6 deg at 2.4 Hz while swaying forward and back at up to 3 m/s"},
    {Motion::kJump, "jump", "crouches 25 cm, jumps 45 cm high, lands and rises; repeats"},
    {Motion::kTumble, "tumble", "a forward somersault about X in 0.8 s with a hop of 1 m; repeats every 1.5 s"},
    {Motion::kTeleport, "teleport", "still, but for a jump of 10 m (+X) at 1 s and a turn of 180 deg about Y at 2 s"},
};

/// From 0 to 1 within about a second: an oscillation times this starts without a kick.
double ramp(double seconds) { return 1.0 - std::exp(-4.0 * seconds); }

double wave(double hertz, double seconds) { return ramp(seconds) * std::sin(kTwoPi * hertz * seconds); }

Quat about_x(double radians) { return {float(std::sin(radians / 2)), 0, 0, float(std::cos(radians / 2))}; }
Quat about_y(double radians) { return {0, float(std::sin(radians / 2)), 0, float(std::cos(radians / 2))}; }

HeadPose nod(double t) { return {{0, 0, 0}, about_x(0.7 * wave(0.77, t))}; }

HeadPose turn(double t) { return {{0, 0, 0}, about_y(1.0 * wave(1.54, t))}; }

HeadPose charge(double t) {
  constexpr double kSpeed = 8.0, kSpeedUp = 0.3;
  const double way = t < kSpeedUp ? 0.5 * kSpeed / kSpeedUp * t * t : kSpeed * (t - 0.5 * kSpeedUp);
  return {{0, 0, way}, {}};
}

HeadPose run(double t) {
  constexpr double kStride = 2.387, kSway = 0.385;  // Hz
  const double sway = 3.0 / (kTwoPi * kSway) * wave(kSway, t);
  return {{0, 0.06 * wave(kStride, t), sway}, about_x(0.1 * wave(kStride, t))};
}

/// A point of a path in time. Between two points the path is the cubic that meets both heights and speeds, which
/// for constant acceleration (pushing off, flying, landing) is the exact parabola.
struct Knot {
  double seconds, height, speed;
};

double between(const Knot& a, const Knot& b, double t) {
  const double span = b.seconds - a.seconds;
  const double u = (t - a.seconds) / span;
  const double u2 = u * u, u3 = u2 * u;
  return (2 * u3 - 3 * u2 + 1) * a.height + (u3 - 2 * u2 + u) * span * a.speed + (3 * u2 - 2 * u3) * b.height +
         (u3 - u2) * span * b.speed;
}

HeadPose jump(double t) {
  constexpr double kCrouch = 0.25, kHeight = 0.45;  // metres
  const double take_off = std::sqrt(2 * kGravity * kHeight);
  const double push = 2 * kCrouch / take_off;  // seconds at constant acceleration
  const double flight = 2 * take_off / kGravity;
  const double lift = 0.4 + push;
  const double landing = lift + flight;
  const Knot knots[] = {
      {0, 0, 0},
      {0.4, -kCrouch, 0},
      {lift, 0, take_off},
      {landing, 0, -take_off},
      {landing + push, -kCrouch, 0},
      {landing + push + 0.5, 0, 0},
      {landing + push + 0.8, 0, 0},
  };
  const double time = std::fmod(t, std::end(knots)[-1].seconds);
  const Knot* next = knots + 1;
  while (next->seconds < time) ++next;
  return {{0, between(next[-1], *next, time), 0}, {}};
}

HeadPose tumble(double t) {
  constexpr double kPeriod = 1.5, kRoll = 0.8;
  const double u = std::fmin(std::fmod(t, kPeriod) / kRoll, 1.0);
  const double hop = std::sin(std::numbers::pi * u);
  return {{0, hop * hop, 0}, about_x(kTwoPi * u * u * (3 - 2 * u))};
}

HeadPose teleport(double t) { return {{t < 1 ? 0.0 : 10.0, 0, 0}, about_y(t < 2 ? 0.0 : std::numbers::pi)}; }

}  // namespace

std::span<const MotionInfo> all_motions() { return kMotions; }

std::optional<Motion> find_motion(std::string_view name) {
  for (const MotionInfo& info : kMotions) {
    if (name == info.name) return info.motion;
  }
  return std::nullopt;
}

HeadPose head_pose(Motion motion, double seconds) {
  const double t = std::fmax(seconds, 0.0);
  switch (motion) {
    case Motion::kStill: return {};
    case Motion::kNod: return nod(t);
    case Motion::kTurn: return turn(t);
    case Motion::kCharge: return charge(t);
    case Motion::kRun: return run(t);
    case Motion::kJump: return jump(t);
    case Motion::kTumble: return tumble(t);
    case Motion::kTeleport: return teleport(t);
  }
  return {};
}

}  // namespace coif
