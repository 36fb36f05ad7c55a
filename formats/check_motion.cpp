#include "chunk_checks.h"

namespace coif {
namespace {

constexpr float kShortest = 1.0e-6f;  ///< Metres: below it a radius or an axis has no direction to push along.

bool reserved_is_zero(const ColliderRecord& c) {
  // -0.0 passes as zero, NaN does not.
  return c.reserved == 0 && c.reserved_center == 0.0f && c.reserved_radii == 0.0f && c.reserved_axis == 0.0f;
}

bool flags_fit(const ColliderRecord& c) {
  const bool round = c.shape == ColliderShape::kSphere || c.shape == ColliderShape::kCapsule;
  return (c.flags & ~(round ? kColliderKeepsInside : 0u)) == 0;
}

/// A ball inside the other would leave no hull to speak of: that is a sphere.
bool tapered_radii_fit(const ColliderRecord& c) {
  const bool good = in_range(c.radii[0], kShortest, kMaxCoordinate) && in_range(c.radii[1], kShortest, kMaxCoordinate);
  const float difference = c.radii[0] - c.radii[1];
  const float square = c.axis[0] * c.axis[0] + c.axis[1] * c.axis[1] + c.axis[2] * c.axis[2];
  return good && c.radii[2] == 0.0f && difference * difference < square;
}

bool radii_fit(const ColliderRecord& c) {
  if (c.shape == ColliderShape::kPlane) return all_zero(c.radii);
  if (c.shape == ColliderShape::kTaperedCapsule) return tapered_radii_fit(c);
  const bool equal = c.radii[0] == c.radii[1] && c.radii[1] == c.radii[2];
  return all_in_range(c.radii, kShortest, kMaxCoordinate) && (equal || c.shape == ColliderShape::kEllipsoid);
}

bool axis_fits(const ColliderRecord& c) {
  if (c.shape == ColliderShape::kPlane) return is_unit(c.axis);
  if (c.shape != ColliderShape::kCapsule && c.shape != ColliderShape::kTaperedCapsule) return all_zero(c.axis);
  const float square = c.axis[0] * c.axis[0] + c.axis[1] * c.axis[1] + c.axis[2] * c.axis[2];
  return all_finite(c.axis) && square >= kShortest * kShortest;
}

/// A set names only colliders that exist, and only a bone that moves has one.
LoadStatus check_collider_sets(const Asset& asset) {
  const std::size_t count = asset.colliders().size();
  const std::uint32_t all = count == kMaxColliders ? ~0u : (1u << count) - 1;
  for (std::size_t i = 0; i < asset.bones().size(); ++i) {
    const BoneRecord& bone = asset.bones()[i];
    const std::uint32_t allowed = is_rigid(bone) ? 0 : all;
    if ((bone.colliders & ~allowed) != 0) {
      return {LoadCode::kColliderSet, chunk::kBones, i, allowed, bone.colliders};
    }
  }
  return {};
}

}  // namespace

LoadStatus check_colliders(const Asset& asset) {
  const auto colliders = asset.colliders();
  if (colliders.size() > kMaxColliders) {
    return {LoadCode::kChunkSize, chunk::kColliders, 0, kMaxColliders, colliders.size()};
  }
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    const ColliderRecord& c = colliders[i];
    const auto fail = [&](LoadCode code) { return LoadStatus{code, chunk::kColliders, i}; };
    if (c.shape > ColliderShape::kTaperedCapsule) return fail(LoadCode::kEnumerator);
    if (!reserved_is_zero(c) || !flags_fit(c)) return fail(LoadCode::kReserved);
    if (c.bone >= asset.bones().size() || !is_rigid(asset.bones()[c.bone])) return fail(LoadCode::kReference);
    const bool good = all_finite(c.center) && radii_fit(c) && is_unit(c.rotation) && axis_fits(c);
    if (!good) return fail(LoadCode::kNotFinite);
  }
  return check_collider_sets(asset);
}

namespace {

constexpr float kMostFriction = 1.0e6f;  ///< Per second; of damping too.

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

}  // namespace

LoadStatus check_dynamics(const Asset& asset) {
  const auto dynamics = asset.dynamics();
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
constexpr float kMostError = 1.0e3f;  ///< Chain lengths: something that is no longer hair.
constexpr float kMostCost = 1.0e12f;  ///< Nanoseconds.
constexpr std::uint32_t kMostSubsteps = 1024;
constexpr std::uint32_t kMotions = 10;

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
         in_range(q.cost, 0.0f, kMostCost) && q.worst_motion < kMotions;
}

}  // namespace

LoadStatus check_tuning(const Asset& asset) {
  if (asset.tuning() != nullptr && !fits(*asset.tuning())) return {LoadCode::kNotFinite, chunk::kTuning};
  for (std::size_t i = 0; i < asset.quality().size(); ++i) {
    if (!fits(asset.quality()[i])) return {LoadCode::kNotFinite, chunk::kQuality, i};
  }
  return {};
}

}  // namespace coif
