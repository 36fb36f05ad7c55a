#pragma once
// The bounds of everything that hosts say, once for the functions that check and for explain(), which names what is
// wrong. `Judge` is Silent or Telling (explain.cpp); under Silent no name is linked.

#include "chain_links.h"
#include "head_pose.h"
#include "solver.h"
#include "step_settings.h"
#include "vector_math.h"

#include <coif/hair.h>

#include <limits>

namespace coif {

inline constexpr float kLargestCollider = 1e6f;  ///< Metres.
inline constexpr double kLargestFloat = double(std::numeric_limits<float>::max());
inline constexpr double kMostDouble = std::numeric_limits<double>::max();
inline constexpr double kNoBound = std::numeric_limits<double>::infinity();
inline constexpr const char* kCenter[] = {"center[0]", "center[1]", "center[2]"};
/// Leaves room in the address space for other arrays.
inline constexpr std::size_t kMostHairBytes = SIZE_MAX / 4;

/// The status of the first rule that is broken.
struct Silent {
  Status status = Status::kOk;

  /// A NaN is outside of every bounds.
  void within(const char*, double value, double least, double most, Status bad = Status::kBadArgument) {
    require(nullptr, value >= least && value <= most, bad);
  }
  void require(const char*, bool holds, Status bad = Status::kBadArgument) {
    if (status == Status::kOk && !holds) status = bad;
  }
  void finite(const char*, const Vec3& vector) { require(nullptr, is_finite(vector)); }
};

/// The members that HairDesc and WorldDesc share.
template <typename Desc, typename Judge>
void judge_features(const Desc& desc, Judge& is) {
  is.require("solver is null", desc.solver != nullptr);
  is.require("instruction_set is one that this processor or this build lacks", can_run(desc.instruction_set));
  is.require("longest_interval is neither 1, 2 nor 4", is_interval(desc.longest_interval));
  is.within("dynamics_sets", desc.dynamics_sets, 1, kMaxDynamicsSets);
  is.within("moving_colliders", desc.moving_colliders, 0, kMaxMovingColliders);
  if (desc.solver == nullptr) return;
  const bool is_worn = desc.solver->character != nullptr;
  is.require("moving_colliders needs a solver for characters, as kCharacterSolver",
             desc.moving_colliders == 0 || is_worn);
  is.require("follows_body needs a solver for characters, as kCharacterSolver", !desc.follows_body || is_worn);
  is.require("follows_poses needs a solver for characters, as kCharacterSolver", !desc.follows_poses || is_worn);
  is.require("has_own_air needs a solver for characters, as kCharacterSolver", !desc.has_own_air || is_worn);
  is.require("feels_gusts needs a solver for characters, as kCharacterSolver", !desc.feels_gusts || is_worn);
  if (desc.links == nullptr) return;
  is.require("links is kCharacterLinks, but the solver is not for characters: name kLinks",
             !desc.links->of_character || is_worn);
  is.require("links is kLinks, but the solver is for characters: name kCharacterLinks",
             desc.links->of_character || !is_worn);
  is.require("links are not for kThesisSolver", !desc.solver->keeps_places);
}

template <typename Judge>
void judge(const HairDesc& desc, Judge& is) {
  is.within("instances", desc.instances, 1, kMaxInstances);
  judge_features(desc, is);
}

template <typename Judge>
void judge(const WorldDesc& desc, Judge& is) {
  is.within("assets", desc.assets, 1, kMaxWorldAssets);
  is.within("heads", desc.heads, 1, kMaxInstances);
  is.within("hair_bytes", double(desc.hair_bytes), 0, double(kMostHairBytes));
  judge_features(desc, is);
}

template <typename Judge>
void judge(const DynamicsScale& scale, Judge& is) {
  is.within("stiffness", scale.stiffness, 0, kMostScale);
  is.within("damping", scale.damping, 0, kMostScale);
  is.within("friction", scale.friction, 0, kMostScale);
}

template <typename Judge>
void judge(const StepSettings& settings, Judge& is) {
  is.within("dt", settings.dt, 0, kLargestFloat, Status::kBadTimeStep);
  is.within("iterations", settings.iterations, 1, kMaxIterations);
  is.within("substeps", settings.substeps, 0, kMaxSubsteps);
  judge(settings.dynamics, is);
  is.within("inertia", settings.inertia, 0, 1);
  is.within("teleport_distance", settings.teleport_distance, 0, kNoBound);
  is.within("teleport_angle", settings.teleport_angle, 0, kNoBound);
  is.within("sleep_after", settings.sleep_after, 0, kNoBound);
  is.within("sleep_speed", settings.sleep_speed, 0, kNoBound);
  const Environment& environment = settings.environment;
  is.finite("environment.gravity", environment.gravity);
  is.finite("environment.wind", environment.wind);
  is.within("environment.true_gravity", environment.true_gravity, 0, 1);
  is.within("environment.air_follow", environment.air_follow, 0, 1);
}

template <typename Judge>
void judge(const MovingCollider& collider, Judge& is) {
  is.require("shape is none of ColliderShape", collider.shape <= ColliderShape::kBox);
  for (int axis = 0; axis < 3; ++axis) {
    is.within(kCenter[axis], collider.center[axis], -kMostDouble, kMostDouble);
  }
  is.require("rotation is not a unit quaternion", is_unit(collider.rotation));
  is.finite("axis", collider.axis);
  is.finite("half_extents", collider.half_extents);
  const Vec3& half = collider.half_extents;
  is.within("radius", collider.radius, 0, kLargestCollider);
  is.within("end_radius", collider.end_radius, 0, kLargestCollider);
  is.within("length of axis", length(collider.axis), 0, kLargestCollider);
  is.within("half_extents.x", half.x, 0, kLargestCollider);
  is.within("half_extents.y", half.y, 0, kLargestCollider);
  is.within("half_extents.z", half.z, 0, kLargestCollider);
  const bool has_volume = half.x > 0.0f && half.y > 0.0f && half.z > 0.0f;
  is.require("half_extents of an ellipsoid are not all above 0",
             collider.shape != ColliderShape::kEllipsoid || has_volume);
  is.require("axis of a plane has no length", collider.shape != ColliderShape::kPlane || length(collider.axis) > 1e-6f);
  if (!collider.is_velocity_known) return;
  is.finite("velocity.linear", collider.velocity.linear);
  is.finite("velocity.angular", collider.velocity.angular);
}

template <typename Judge>
void judge(const HeadAir& air, Judge& is) {
  is.finite("wind", air.wind);
  is.within("exposure", air.exposure, 0, 1);
}

template <typename Judge>
void judge(const Gusts& gusts, Judge& is) {
  is.within("amplitude", gusts.amplitude, 0, kMostGust);
  is.within("length", gusts.length, kShortestGust, kLongestGust);
  is.within("speed", gusts.speed, 0, kMostGust);
  is.finite("direction", gusts.direction);
  is.require("direction has no length", !(gusts.direction == Vec3{}));
}

template <typename Judge>
void judge(const Impulse& impulse, Judge& is) {
  for (int axis = 0; axis < 3; ++axis) is.within(kCenter[axis], impulse.center[axis], -kMostDouble, kMostDouble);
  is.require("radius is not above 0", impulse.radius > 0.0f);
  is.within("radius", impulse.radius, 0, kLargestFloat);
  is.within("speed", impulse.speed, -kLargestFloat, kLargestFloat);
  is.finite("axis", impulse.axis);
  is.finite("velocity", impulse.velocity);
}

/// The status that a function returns for this value.
template <typename Value>
[[nodiscard]] Status check(const Value& value) {
  Silent silent;
  judge(value, silent);
  return silent.status;
}

}  // namespace coif
