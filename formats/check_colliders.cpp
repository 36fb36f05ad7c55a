#include "chunk_checks.h"

namespace coif {
namespace {

constexpr float kShortest = 1.0e-6f;  ///< Metres. A shorter radius or axis gives no direction to push along.

bool reserved_is_zero(const ColliderRecord& c) {
  // -0.0 passes as zero, NaN does not.
  return c.reserved == 0 && c.reserved_center == 0.0f && c.reserved_radii == 0.0f && c.reserved_axis == 0.0f;
}

bool flags_fit(const ColliderRecord& c) {
  const bool round = c.shape == ColliderShape::kSphere || c.shape == ColliderShape::kCapsule;
  return (c.flags & ~(round ? kColliderKeepsInside : 0u)) == 0;
}

/// A tapered capsule with one ball inside the other is refused: it would be a sphere.
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

/// `is_carrier` tells whether a bone may carry a collider.
template <typename IsCarrier>
LoadStatus check_shapes(std::span<const ColliderRecord> colliders, std::uint32_t id, const IsCarrier& is_carrier) {
  for (std::size_t i = 0; i < colliders.size(); ++i) {
    const ColliderRecord& c = colliders[i];
    const auto fail = [&](LoadCode code) { return LoadStatus{code, id, i}; };
    if (c.shape > ColliderShape::kTaperedCapsule) return fail(LoadCode::kEnumerator);
    if (!reserved_is_zero(c) || !flags_fit(c)) return fail(LoadCode::kReserved);
    if (!is_carrier(c.bone)) return fail(LoadCode::kReference);
    const bool good = all_finite(c.center) && radii_fit(c) && is_unit(c.rotation) && axis_fits(c);
    if (!good) return fail(LoadCode::kNotFinite);
  }
  return {};
}

/// One bit for each of `count` colliders, at most 32.
std::uint32_t all_of(std::size_t count) { return count == 32 ? ~0u : (1u << count) - 1; }

/// A set names only colliders that exist, and only a simulated bone has one. `set_of(i)` is the set of bone i.
template <typename SetOf>
LoadStatus check_sets(const Asset& asset, std::uint32_t id, std::size_t count, const SetOf& set_of) {
  for (std::size_t i = 0; i < asset.bones().size(); ++i) {
    const std::uint32_t allowed = is_rigid(asset.bones()[i]) ? 0 : all_of(count);
    if ((set_of(i) & ~allowed) != 0) return {LoadCode::kColliderSet, id, i, allowed, set_of(i)};
  }
  return {};
}

LoadStatus check_most(std::uint32_t id, std::uint32_t most, std::size_t count) {
  return count > most ? LoadStatus{LoadCode::kChunkSize, id, 0, most, count} : LoadStatus{};
}

LoadStatus check_body_bones(const Asset& asset) {
  const std::size_t name_bytes = asset.records<chunk::kNames>().size();
  for (std::size_t i = 0; i < asset.body_bones().size(); ++i) {
    const BodyBoneRecord& bone = asset.body_bones()[i];
    if (bone.name >= name_bytes) return {LoadCode::kReference, chunk::kBodyBones, i, name_bytes, bone.name};
    if (!all_finite(bone.joint) || !is_unit(bone.rotation)) return {LoadCode::kNotFinite, chunk::kBodyBones, i};
  }
  return check_most(chunk::kBodyBones, kMaxBodyColliders, asset.body_bones().size());
}

}  // namespace

LoadStatus check_colliders(const Asset& asset) {
  const auto colliders = asset.colliders();
  const auto bones = asset.bones();
  if (const LoadStatus status = check_most(chunk::kColliders, kMaxColliders, colliders.size()); !status) return status;
  const auto is_carrier = [&](std::uint32_t bone) { return bone < bones.size() && is_rigid(bones[bone]); };
  if (const LoadStatus status = check_shapes(colliders, chunk::kColliders, is_carrier); !status) return status;
  return check_sets(asset, chunk::kBones, colliders.size(), [&](std::size_t i) { return bones[i].colliders; });
}

/// Runs after check_needs(), so all three chunks are there, or none.
LoadStatus check_body(const Asset& asset) {
  const auto colliders = asset.body_colliders();
  if (colliders.empty()) return {};
  if (const LoadStatus status = check_body_bones(asset); !status) return status;
  if (const LoadStatus status = check_most(chunk::kBodyColliders, kMaxBodyColliders, colliders.size()); !status)
    return status;
  const auto is_carrier = [&](std::uint32_t bone) { return bone < asset.body_bones().size(); };
  if (const LoadStatus status = check_shapes(colliders, chunk::kBodyColliders, is_carrier); !status) return status;
  const auto sets = asset.body_sets();
  if (sets.size() != asset.bones().size()) {
    return {LoadCode::kChunkSize, chunk::kBodySets, 0, asset.bones().size(), sets.size()};
  }
  return check_sets(asset, chunk::kBodySets, colliders.size(), [&](std::size_t i) { return sets[i]; });
}

}  // namespace coif
