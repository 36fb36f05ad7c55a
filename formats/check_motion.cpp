#include "chunk_checks.h"

namespace coif {
namespace {

constexpr float kMostFriction = 1.0e6f;  ///< Per second; the bound of damping too.

LoadStatus check_asked(const Asset& asset) {
  const auto asked = asset.asked();
  if (!asked.empty() && asked.size() != asset.bones().size()) {
    return {LoadCode::kChunkSize, chunk::kAsked, 0, asset.bones().size(), asked.size()};
  }
  for (std::size_t i = 0; i < asked.size(); ++i) {
    const AskedRecord& a = asked[i];
    const bool good = in_range(a.friction, 0.0f, kMostFriction) && in_range(a.damping, 0.0f, kMostFriction) &&
                      in_range(a.parent_share, 0.0f, 1.0f);
    if (!good) return {LoadCode::kNotFinite, chunk::kAsked, i};
  }
  return {};
}

/// Only the angles that the kind uses are set.
bool angles_fit(const LimitRecord& limit) {
  const float most_first = limit.kind == LimitKind::kUnlimited ? 0.0f : kNoAngleLimit;
  const float most_second = limit.kind == LimitKind::kSpherical ? kMostYaw : 0.0f;
  return in_range(limit.angles[0], 0.0f, most_first) && in_range(limit.angles[1], 0.0f, most_second);
}

LoadStatus check_limits(const Asset& asset) {
  const auto limits = asset.limits();
  if (!limits.empty() && limits.size() != asset.bones().size()) {
    return {LoadCode::kChunkSize, chunk::kLimits, 0, asset.bones().size(), limits.size()};
  }
  for (std::size_t i = 0; i < limits.size(); ++i) {
    const LimitRecord& limit = limits[i];
    const LimitKind last = is_rigid(asset.bones()[i]) ? LimitKind::kUnlimited : LimitKind::kSpherical;
    if (limit.kind > last)
      return {LoadCode::kEnumerator, chunk::kLimits, i, std::uint64_t(last), std::uint64_t(limit.kind)};
    if (limit.reserved != 0.0f) return {LoadCode::kReserved, chunk::kLimits, i};
    if (!angles_fit(limit) || !is_unit(limit.rotation)) return {LoadCode::kNotFinite, chunk::kLimits, i};
  }
  return {};
}

}  // namespace

LoadStatus check_dynamics(const Asset& asset) {
  const auto dynamics = asset.dynamics();
  if (const LoadStatus status = check_limits(asset); !status) return status;
  if (dynamics.empty() && asset.skeleton().simulated_count == 0) return {};
  if (dynamics.empty()) return {LoadCode::kChunkMissing, chunk::kDynamics};
  if (dynamics.size() != asset.bones().size()) {
    return {LoadCode::kChunkSize, chunk::kDynamics, 0, asset.bones().size(), dynamics.size()};
  }
  for (std::size_t i = 0; i < dynamics.size(); ++i) {
    const DynamicsRecord& d = dynamics[i];
    const bool good = in_range(d.resistance, 0.0f, 1.0f) && in_range(d.friction, 0.0f, kMostFriction) &&
                      in_range(d.gravity_scale, -1.0e3f, 1.0e3f) && in_range(d.authoring_rate, 1.0f, 1.0e5f) &&
                      in_range(d.hit_radius, 0.0f, kMaxCoordinate) && in_range(d.stiffness, 0.0f, 1.0e12f) &&
                      in_range(d.damping, 0.0f, kMostFriction) && in_range(d.torsion, 0.0f, 1.0e6f) &&
                      in_range(d.angle_limit, 0.0f, kNoAngleLimit) && in_range(d.parent_share, 0.0f, 1.0f) &&
                      all_finite(d.lean) && d.lean[0] * d.lean[0] + d.lean[1] * d.lean[1] <= 1.0f;
    if (!good) return {LoadCode::kNotFinite, chunk::kDynamics, i};
  }
  return check_asked(asset);
}

namespace {

constexpr float kMostRate = 1.0e5f;   ///< Per second.
constexpr float kMostError = 1.0e3f;  ///< Chain lengths. Something with a larger error is no longer hair.
constexpr float kMostCost = 1.0e12f;  ///< Nanoseconds.
constexpr std::uint32_t kMostSubsteps = 1024;

bool fits(const TuningRecord& t) {
  return in_range(t.substep_rate, 0.0f, kMostRate) && in_range(t.asked_error, 0.0f, kMostError) &&
         in_range(t.reached_error, 0.0f, kMostError) && in_range(t.asked_cost, 0.0f, kMostCost) &&
         in_range(t.cost, 0.0f, kMostCost) && in_range(t.slowest_rate, 1.0f, kMostRate) &&
         in_range(t.fastest_rate, t.slowest_rate, kMostRate) && t.met <= 1;
}

bool fits(const QualityRecord& q) {
  return in_range(q.frame_rate, 1.0f, kMostRate) && q.substeps >= 1 && q.substeps <= kMostSubsteps &&
         in_range(q.rms_error, 0.0f, kMostError) && in_range(q.max_error, 0.0f, kMostError) &&
         in_range(q.stretch, 0.0f, kMostError) && in_range(q.penetration, 0.0f, kMostError) &&
         in_range(q.cost, 0.0f, kMostCost);
}

/// At least one byte of text, then zeros to the end of the record.
bool is_name(const MotionNameRecord& motion) {
  bool has_ended = false;
  for (const char c : motion.name) {
    if (has_ended && c != 0) return false;
    has_ended = has_ended || c == 0;
  }
  return has_ended && motion.name[0] != 0;
}

/// Checks every name, and that each row's motion has one. Older assets have no names; their rows' numbers are not
/// indices.
LoadStatus check_motion_names(const Asset& asset) {
  const auto names = asset.motion_names();
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!is_name(names[i])) return {LoadCode::kReference, chunk::kMotionNames, i};
  }
  if (names.empty()) return {};
  for (std::size_t i = 0; i < asset.quality().size(); ++i) {
    const std::uint32_t motion = asset.quality()[i].worst_motion;
    if (motion >= names.size()) return {LoadCode::kReference, chunk::kQuality, i, names.size(), motion};
  }
  return {};
}

}  // namespace

LoadStatus check_tuning(const Asset& asset) {
  if (asset.tuning() != nullptr && !fits(*asset.tuning())) return {LoadCode::kNotFinite, chunk::kTuning};
  for (std::size_t i = 0; i < asset.quality().size(); ++i) {
    if (!fits(asset.quality()[i])) return {LoadCode::kNotFinite, chunk::kQuality, i};
  }
  return check_motion_names(asset);
}

}  // namespace coif
