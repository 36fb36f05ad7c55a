#include "grow/strand_paths.h"

#include "base/parallel_for.h"
#include "grow/flow.h"
#include "grow/random.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace coif::grow {
namespace {

using Eigen::Vector3f;

constexpr float kStep = 0.003f;  // metres on a head of usual size

/// One strand of open hair.
class OpenStrand {
 public:
  OpenStrand(const Ground& ground, const Flow& flow, const Root& root, std::size_t number)
      : ground_(ground),
        flow_(flow),
        root_(root),
        scale_(ground.head.scale()),
        side_(flow.side_of(root.direction, number)) {
    const Dice dice(ground.style.grow_seed, Purpose::kLift);
    lift_ = 1 + 0.25f * dice.signed_unit(number);
    const Vector3f normal = ground.body.normal(root.place);
    const float wisp = root.is_wisp ? 0.4f : 1.0f;  // Too light to stand off.
    const float angle = wisp * float(ground.style.grow_lift) * kRadians * (1 + 0.15f * dice.signed_unit(number, 1));
    const Vector3f flat = flow.at(root.place, normal, side_, root.is_fringe);
    const float astray = 0.08f + 0.7f * flow.tangled_at(root.direction);
    tip_.place = root.place;
    Vector3f astray_way = dice.in_cube(number, 2);
    astray_way -= astray_way.dot(normal) * normal;
    tip_.way = (std::cos(angle) * flat + std::sin(angle) * normal + astray * astray_way).normalized();
  }

  void grow(std::span<Vector3f> points) {
    const float between = root_.length / float(points.size() - 1);
    const int steps = std::max(int(std::ceil(between / (kStep * scale_))), 1);
    points[0] = tip_.place;
    for (std::size_t k = 1; k < points.size(); ++k) {
      for (int i = 0; i < steps; ++i) step(between / float(steps));
      points[k] = tip_.place;
    }
  }

 private:
  void step(float length) {
    const cook::HairStyle& style = ground_.style;
    const float wanted = clearance(ground_, root_, lift_, tip_);
    const float away = ground_.body.distance(tip_.place);
    const float bends = 1 - float(style.grow_stiffness), radius = ground_.head.mean_radius();
    Vector3f turn = -4 * bends * bends * float(style.grow_gravity) * Vector3f::UnitY();
    const float near = 1 - ramp(wanted, wanted + 0.25f * radius, away);
    if (near > 0) {
      const Vector3f normal = ground_.body.normal(tip_.place);
      Vector3f way = flow_.at(tip_.place, normal, side_, root_.is_fringe);
      way += settling((wanted - away) / scale_) * normal;
      turn += near * (1 + 6 * bends) * (way - tip_.way);
    }
    turn += swing() + drape(away);
    advance(ground_, turn / radius, length, wanted, tip_);
  }

  /// Moves up or down to where it should lie, by the missing distance: hair follows the skull's curvature.
  [[nodiscard]] float settling(float short_of) const {
    constexpr float kFrom = 0.01f, kSteepest = 0.45f;
    const float height = ground_.head.direction(tip_.place).y();
    return ramp(-0.35f, 0.15f, height) * kSteepest * std::clamp(short_of / kFrom, -1.0f, 1.0f);
  }

  /// Moves it before or behind the shoulder: hair on top of it would slide outwards and stand over its end.
  [[nodiscard]] Vector3f drape(float away) const {
    const float below = (ground_.head.center.y() - tip_.place.y()) / ground_.head.radii.y();
    const float near = ramp(0.3f, 1.2f, below) * (1 - ramp(0.02f * scale_, 0.17f * scale_, away));
    if (near == 0) return Vector3f::Zero();
    const Vector3f normal = ground_.body.normal(tip_.place);
    const float level = ramp(0.35f, 0.75f, normal.y());
    const float aside = (tip_.place.x() - ground_.head.center.x()) / ground_.head.radii.x();
    const float inwards = 0.5f * std::copysign(ramp(1.1f, 1.8f, std::abs(aside)), -aside);
    return 9 * near * level * Vector3f(inwards, 0, root_.direction.z() > -0.1f ? 1.0f : -1.0f);
  }

  /// Outwards from the head's axis, near the tip or the line of the cut.
  [[nodiscard]] Vector3f swing() const {
    const cook::HairStyle& style = ground_.style;
    if (style.grow_swing == 0) return Vector3f::Zero();
    float near = ramp(0.6f, 0.9f, tip_.grown / root_.length);
    if (style.grow_cut) {
      const float above = (tip_.place.y() - ground_.head.center.y()) / ground_.head.radii.y() - float(*style.grow_cut);
      near = 1 - ramp(0.05f, 0.75f, above);
    }
    Vector3f out = tip_.place - ground_.head.center;
    out.y() = 0;
    return 7 * near * float(style.grow_swing) * out.normalized();
  }

  const Ground& ground_;
  const Flow& flow_;
  const Root& root_;
  float scale_, side_, lift_ = 1;
  Tip tip_;
};

}  // namespace

float clearance(const Ground& ground, const Root& root, float lift, const Tip& tip) {
  const cook::HairStyle& style = ground.style;
  const float scale = ground.head.scale();
  const float below = (ground.head.center.y() - tip.place.y()) / ground.head.radii.y();
  const float on_head = 1 - 0.85f * ramp(0.7f, 1.7f, below);
  // The hair beneath grows with the way: at the root there is only the skin.
  const float flat = 0.5f + 0.5f * ramp(0, 0.25f, root.height);  // Hair of the hairline lies on nothing.
  const float volume = flat * float(style.grow_volume) * ramp(0, 0.05f * scale, tip.grown) +
                       float(style.grow_layers) * root.height * ramp(0, 0.13f * scale, tip.grown);
  return scale * (kLeastClearance + on_head * lift * volume);
}

void advance(const Ground& ground, const Vector3f& turn, float length, float wanted_clearance, Tip& tip) {
  constexpr float kSoftly = 0.12f;  // Share of the missing distance per step.
  const Vector3f before = tip.place;
  tip.way = (tip.way + length * turn).normalized();
  Vector3f place = before + length * tip.way;
  tip.grown += length;
  const float away = ground.body.distance(place);
  if (away < wanted_clearance) {
    const Vector3f normal = ground.body.normal(place);
    place += std::min(kSoftly * (wanted_clearance - away), 0.5f * length) * normal;
    const float least = std::min(ground.head.scale() * kLeastClearance, 0.5f * tip.grown);
    place = ground.body.kept_off(place, least);
    if ((place - before).norm() > 1e-3f * length) tip.way = (place - before).normalized();
    place = ground.body.kept_off(before + length * tip.way, least);
  }
  tip.place = place;
}

StrandPaths grow_open(const Ground& ground, std::span<const Root> roots, std::size_t stations,
                      const platform::Threads& threads) {
  const Flow flow(ground.style, ground.head);
  StrandPaths paths{stations, std::vector<Vector3f>(roots.size() * stations)};
  parallel_for(roots.size(), threads,
               [&](std::size_t i) { OpenStrand(ground, flow, roots[i], i).grow(paths.strand(i)); });
  return paths;
}

}  // namespace coif::grow
