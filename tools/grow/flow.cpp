#include "grow/flow.h"

#include "grow/random.h"
#include "grow/strand_paths.h"

#include <Eigen/Geometry>

#include <cmath>

namespace coif::grow {
namespace {

using Eigen::Vector3f;

Vector3f comb_direction(const std::string& word, const Vector3f& out) {
  if (word == "back") return Vector3f(0, -1.6f * ramp(0.1f, 0.9f, -out.z()), -1);  // over the top, and down behind it
  if (word == "forward") return Vector3f::UnitZ();
  if (word == "up") return Vector3f::UnitY();
  if (word == "out") return out;
  return -Vector3f::UnitY();
}

constexpr float kKeptBeside = 0.5f;  // share of a fringe's depth: hair above it may cross its upper end

Vector3f along(const Vector3f& way, const Vector3f& normal) { return way - way.dot(normal) * normal; }

}  // namespace

Flow::Flow(const cook::HairStyle& style, const HeadFrame& head)
    : style_(style),
      head_(head),
      crown_(direction_at(180, 90 - float(style.grow_crown))),
      fringe_(style.grow_fringe_width > 0 ? kKeptBeside * float(style.grow_fringe_depth) : 0) {
  const auto azimuth = float(style.grow_parting.value_or(0));
  const Vector3f front = direction_at(azimuth, float(style.grow_hairline_front));
  const Vector3f across = crown_.cross(front);
  parting_ = across.norm() > 1e-3f ? across.normalized() : Vector3f::UnitX();
  if (parting_.x() < 0) parting_ = -parting_;
}

float Flow::side_of(const Vector3f& root_direction, std::size_t number) const {
  if (!style_.grow_parting) return 0;
  // A comb draws no ruled line, and here and there a strand lies over it.
  constexpr float kWavers = 0.012f, kStrays = 0.016f;
  const Dice dice(style_.grow_seed, Purpose::kParting);
  const float line = kWavers * dice.smooth(0, 9 * root_direction.z()).x() + kStrays * dice.signed_unit(number, 1);
  return root_direction.dot(parting_) >= line ? 1.0f : -1.0f;
}

float Flow::tangled_at(const Vector3f& root_direction) const {
  return 1 - ramp(0.02f, 0.28f, (root_direction - crown_).norm());
}

float Flow::leaves_bare(const Vector3f& root_direction) const {
  const float crown = tangled_at(root_direction);
  if (!style_.grow_parting) return crown;
  return std::max(
      crown, ramp(0, 0.5f, parted(root_direction)) * (1 - ramp(0.04f, 0.09f, std::abs(root_direction.dot(parting_)))));
}

/// Away from the crown, in a spiral that opens.
Vector3f Flow::from_crown(const Vector3f& direction) const {
  const Vector3f away = along(-crown_, direction);
  if (away.norm() < 1e-4f) return Vector3f::Zero();
  const float angle = std::acos(std::clamp(direction.dot(crown_), -1.0f, 1.0f)) / kRadians;
  const float turned = -float(style_.grow_whorl) * kRadians * (1 - ramp(10, 80, angle));
  return Eigen::AngleAxisf(turned, direction) * away.normalized();
}

/// The strength of the parting, which acts before the crown.
float Flow::parted(const Vector3f& direction) const {
  const Vector3f before = along(Vector3f::UnitZ(), crown_).normalized();
  const Vector3f in_plane = along(direction, parting_);
  const float angle = std::atan2(in_plane.dot(before), in_plane.dot(crown_)) / kRadians;
  return float(style_.grow_parting_strength) * ramp(-12, 22, angle);
}

Vector3f Flow::at(const Vector3f& place, const Vector3f& normal, float side, bool is_fringe) const {
  const Vector3f direction = head_.direction(place);
  const Vector3f down = along(-Vector3f::UnitY(), normal);
  if (is_fringe) return along(Vector3f(0.35f * direction.x(), -0.8f, 1), normal).normalized();
  Vector3f way = along(from_crown(direction), normal);
  if (side != 0) {
    // To the side at first, and soon down: straight away from a side parting, hair of the temple would end up behind
    // the ear.
    const float share = parted(direction), falls = ramp(0.05f, 0.75f, side * direction.dot(parting_));
    const Vector3f aside = along(side * (parting_ + Vector3f::UnitX()) / 2, normal);
    way = (1 - share) * way + share * ((1 - falls) * aside + (0.35f + falls) * down);
  }
  const auto strength = float(style_.grow_comb_strength);
  way = (1 - strength) * way + strength * along(comb_direction(style_.grow_comb, direction), normal);
  // Hair without a fringe is kept out of the face, and beside a fringe before it.
  const float azimuth = azimuth_of(direction), above = elevation_of(direction) - hairline(style_, azimuth) - fringe_;
  const float face = (1 - ramp(50, 80, std::abs(azimuth))) * (1 - ramp(-6, 16, above));
  const float aside = side != 0 && std::abs(azimuth) < 12 ? side : (direction.x() >= 0 ? 1.0f : -1.0f);
  const float back = style_.grow_comb == "back" ? strength : 0.0f;
  way += face * along(Vector3f(1.6f * (1 - back) * aside, 0, -0.5f - back), normal);
  const float length = way.norm();
  const float astray = 0.3f * tangled_at(direction);  // Only the crown's hair may stand as it likes.
  return length > 1e-4f ? Vector3f(way / std::max(length, astray)) : Vector3f::Zero();
}

}  // namespace coif::grow
