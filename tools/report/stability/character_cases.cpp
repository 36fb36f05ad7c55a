#include "report/stability/measure_stability.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace coif::report {
namespace {

using Eigen::Vector3d;

constexpr double kHalfTurn = std::numbers::pi;
constexpr float kHand = 0.04f;    // Metres, the radius of a hand: a fist; half of it for things 4 cm thick.
constexpr double kWayOut = 0.25;  // metres from the hair's middle to where a hand waits

HeadPose standing_head(double /*seconds*/) { return {}; }

Quat turn_about(const Vector3d& axis, double radians) {
  const Vector3d part = axis.normalized() * std::sin(radians / 2);
  return {float(part.x()), float(part.y()), float(part.z()), float(std::cos(radians / 2))};
}

Vec3 narrow(const Vector3d& v) { return {float(v.x()), float(v.y()), float(v.z())}; }

MovingCollider at(ColliderShape shape, const Vector3d& place) {
  MovingCollider collider;
  collider.shape = shape;
  for (int i = 0; i < 3; ++i) collider.center[i] = place[i];
  return collider;
}

MovingCollider ball(const Vector3d& place, double radius) {
  MovingCollider collider = at(ColliderShape::kSphere, place);
  collider.radius = float(radius);
  return collider;
}

/// With its middle at `place`.
MovingCollider bar(const Vector3d& place, const Vector3d& axis, double radius, double end_radius) {
  const bool is_tapered = end_radius != radius;
  MovingCollider collider =
      at(is_tapered ? ColliderShape::kTaperedCapsule : ColliderShape::kCapsule, place - 0.5 * axis);
  collider.axis = narrow(axis);
  collider.radius = float(radius);
  collider.end_radius = float(end_radius);
  return collider;
}

MovingCollider block(const Vector3d& place, const Vector3d& half_extents, double rounding, const Quat& rotation) {
  MovingCollider collider = at(ColliderShape::kBox, place);
  collider.half_extents = narrow(half_extents);
  collider.radius = float(rounding);
  collider.rotation = rotation;
  return collider;
}

/// Level, across the way out.
Vector3d sideways(const lab::HairPlace& hair) { return Vector3d::UnitY().cross(hair.outward); }

/// From -1 to 1 and back at an even speed; `way`: how many times it has gone from one end to the other.
double there_and_back(double way) {
  const double phase = std::fmod(way, 2.0);
  return phase < 1 ? 2 * phase - 1 : 3 - 2 * phase;
}

using Colliders = std::vector<MovingCollider>;

Stress with_colliders(std::string name, std::string description,
                      std::function<Colliders(const lab::HairPlace&, double)> colliders) {
  Stress stress;
  stress.about = {std::move(name), std::move(description)};
  stress.head = standing_head;
  stress.colliders = std::move(colliders);
  return stress;
}

/// The place of something that goes to and fro through the hair at this speed, m/s.
Vector3d passing(const lab::HairPlace& hair, double seconds, double speed) {
  return hair.middle + sideways(hair) * (kWayOut * there_and_back(speed * seconds / (2 * kWayOut)));
}

void add_hands(std::vector<Stress>& all) {
  constexpr double kSpeed = 3;
  const std::pair<const char*, std::function<MovingCollider(const lab::HairPlace&, const Vector3d&)>> shapes[] = {
      {"sphere", [](const lab::HairPlace&, const Vector3d& place) { return ball(place, kHand / 2); }},
      {"capsule", [](const lab::HairPlace& hair,
                     const Vector3d& place) { return bar(place, 0.2 * hair.outward, kHand / 2, kHand / 2); }},
      {"tapered capsule", [](const lab::HairPlace& hair,
                             const Vector3d& place) { return bar(place, 0.2 * hair.outward, kHand / 2, kHand / 3); }},
      {"box",
       [](const lab::HairPlace&, const Vector3d& place) {
         return block(place, {0.015, 0.015, 0.06}, 0.005, turn_about({0.3, 1, 0.2}, 0.7));
       }},
  };
  for (const auto& [shape, made] : shapes) {
    Stress stress = with_colliders(std::string("hand at 3 m/s, ") + shape,
                                   "4 cm thick, to and fro through the hair at 30 frames per second",
                                   [made = made](const lab::HairPlace& hair, double seconds) {
                                     return Colliders{made(hair, passing(hair, seconds, kSpeed))};
                                   });
    stress.dt = {1.0 / 30};
    stress.steps = 120;
    all.push_back(std::move(stress));
  }
}

void add_squeezes(std::vector<Stress>& all) {
  all.push_back(with_colliders(
      "between hand and head", "a fist pushes the hair against the head, half a centimetre into it, and lets go",
      [](const lab::HairPlace& hair, double seconds) {
        const double height =
            std::clamp(hair.middle.y() - hair.head.y(), -0.5 * hair.head_radius, 0.5 * hair.head_radius);
        const double level = std::sqrt(hair.head_radius * hair.head_radius - height * height);
        const double pushed = kWayOut * (0.5 + 0.5 * std::cos(kHalfTurn * seconds));
        const Vector3d contact = hair.head + Vector3d(0, height, 0) + hair.outward * level;
        return Colliders{ball(contact + hair.outward * (kHand - 0.005 + pushed), kHand)};
      }));
  all.push_back(with_colliders("pinched by two", "two fists that close on the hair until they overlap by 4 mm",
                               [](const lab::HairPlace& hair, double seconds) {
                                 const double apart = kHand - 0.002 + 0.1 * (0.5 + 0.5 * std::cos(kHalfTurn * seconds));
                                 const Vector3d way = sideways(hair) * apart;
                                 return Colliders{ball(hair.middle - way, kHand), ball(hair.middle + way, kHand)};
                               }));
  all.push_back(with_colliders("larger than the head",
                               "a ball of half a metre that rises to the middle of the hair from outside and below",
                               [](const lab::HairPlace& hair, double seconds) {
                                 constexpr double kRadius = 0.5;
                                 const double off = 0.4 * (0.5 + 0.5 * std::cos(kHalfTurn * seconds));
                                 const Vector3d way = (hair.outward - Vector3d::UnitY()).normalized();
                                 return Colliders{ball(hair.middle + way * (kRadius + off), kRadius)};
                               }));
}

void add_jumps(std::vector<Stress>& all) {
  all.push_back(with_colliders("appears in the hair", "a ball of 3 cm that is there every other half second",
                               [](const lab::HairPlace& hair, double seconds) {
                                 const bool is_there = std::fmod(seconds, 1.0) >= 0.5;
                                 return is_there ? Colliders{ball(hair.middle, 0.03)} : Colliders{};
                               }));
  all.push_back(with_colliders("collider teleports",
                               "from one side of the hair's middle into it and to the other side, four times a second",
                               [](const lab::HairPlace& hair, double seconds) {
                                 const double place = std::floor(std::fmod(4 * seconds, 3.0)) - 1;
                                 return Colliders{ball(hair.middle + sideways(hair) * (2 * place), kHand)};
                               }));
  all.push_back(with_colliders("collider not a number", "a hand to and fro whose place fails now and then",
                               [](const lab::HairPlace& hair, double seconds) {
                                 MovingCollider hand = ball(passing(hair, seconds, 1), kHand);
                                 if (std::fmod(seconds, 0.5) > 0.45)
                                   hand.center[1] = std::numeric_limits<double>::quiet_NaN();
                                 return Colliders{hand};
                               }));
  all.push_back(with_colliders("colliders of no radius",
                               "a point, a line, a plate and a cone with a point, through the hair",
                               [](const lab::HairPlace& hair, double seconds) {
                                 const Vector3d place = passing(hair, seconds, 1);
                                 return Colliders{ball(place, 0), bar(place, 0.1 * hair.outward, 0, 0),
                                                  block(place, {0.05, 0, 0.05}, 0, turn_about(hair.outward, 0.5)),
                                                  bar(place, 0.1 * hair.outward, 0, 0.02)};
                               }));
}

void add_turns(std::vector<Stress>& all) {
  all.push_back(with_colliders("collider spins 30 rad/s", "a bar of 40 cm, 3 cm thick, level, turning in the hair",
                               [](const lab::HairPlace& hair, double seconds) {
                                 const double angle = 30 * seconds;
                                 const Vector3d axis(std::cos(angle), 0, std::sin(angle));
                                 const Vector3d place = hair.middle + hair.outward * 0.1;
                                 return Colliders{bar(place, 0.4 * axis, 0.015, 0.015)};
                               }));
  Stress spin = with_colliders("head spins among colliders", "at 20 rad/s, with a fist, a post and a block beside it",
                               [](const lab::HairPlace& hair, double) {
                                 const Vector3d out = (hair.middle - hair.head).cwiseProduct(Vector3d(1, 0, 1));
                                 const Vector3d across = Vector3d::UnitY().cross(out);
                                 return Colliders{
                                     ball(hair.middle, kHand),
                                     bar(hair.middle - out + across, Vector3d(0, 0.3, 0), 0.02, 0.02),
                                     block(hair.middle - out - across, {0.03, 0.1, 0.03}, 0.01, {}),
                                 };
                               });
  spin.head = [](double seconds) {
    HeadPose head;
    head.rotation = turn_about(Vector3d::UnitY(), 20 * seconds);
    return head;
  };
  spin.top_speed = 20;
  all.push_back(std::move(spin));
}

void add_sizes(std::vector<Stress>& all) {
  Stress crowd = with_colliders(
      "sixteen colliders", "balls of 1 to 4 cm on ways of their own through the hair, the head shaken",
      [](const lab::HairPlace& hair, double seconds) {
        Colliders balls;
        for (std::uint32_t i = 0; i < kMaxMovingColliders; ++i) {
          const double own = double(i), t = seconds * (1 + 0.2 * own);
          const Vector3d off(std::sin(2 * t + own), std::sin(1.3 * t + 2 * own), std::cos(1.7 * t + own));
          balls.push_back(ball(hair.middle + 0.15 * off, 0.01 + 0.002 * own));
        }
        return balls;
      });
  crowd.head = moving(motion::Motion::kTurn);
  all.push_back(std::move(crowd));
  const auto scale_at = [](double seconds) { return std::exp2(-std::cos(kHalfTurn * seconds)); };
  Stress growing = with_colliders("head grows beside a hand",
                                  "from half its size to twice, while a fist goes to and fro through its hair",
                                  [scale_at](const lab::HairPlace& hair, double seconds) {
                                    return Colliders{ball(passing(hair, seconds, 1) * scale_at(seconds), kHand)};
                                  });
  growing.head = [scale_at](double seconds) {
    HeadPose head;
    head.scale = float(scale_at(seconds));
    return head;
  };
  all.push_back(std::move(growing));
}

}  // namespace

std::vector<Stress> character_cases() {
  std::vector<Stress> all;
  add_hands(all);
  add_squeezes(all);
  add_jumps(all);
  add_turns(all);
  add_sizes(all);
  return all;
}

}  // namespace coif::report
