#pragma once
// How numbers lie in memory for the code that steps many chains at once. A "lane" is one place in a SIMD vector.
// Sixteen lanes are stored side by side whatever the processor: a vector of 4, 8 or 16 then walks over them in 4, 2 or
// 1 parts.

#include <coif/asset_records.h>
#include <coif/math.h>

#include <cstdint>

namespace coif {

inline constexpr std::uint32_t kLanes = 16;

/// One number of each lane. Not initialised unless written Lanes{}.
struct alignas(64) Lanes {
  float v[kLanes];
};

struct Lanes3 {
  Lanes x, y, z;
};

struct Lanes4 {
  Lanes x, y, z, w;
};

/// Columns of a 3x3 matrix.
struct LanesMatrix {
  Lanes3 x, y, z;
};

inline Vec3 lane(const Lanes3& from, std::uint32_t i) { return {from.x.v[i], from.y.v[i], from.z.v[i]}; }
inline Quat lane(const Lanes4& from, std::uint32_t i) { return {from.x.v[i], from.y.v[i], from.z.v[i], from.w.v[i]}; }

inline void set_lane(Lanes3& to, std::uint32_t i, const Vec3& value) {
  to.x.v[i] = value.x;
  to.y.v[i] = value.y;
  to.z.v[i] = value.z;
}
inline void set_lane(Lanes4& to, std::uint32_t i, const Quat& value) {
  to.x.v[i] = value.x;
  to.y.v[i] = value.y;
  to.z.v[i] = value.z;
  to.w.v[i] = value.w;
}

/// What a bone is, one lane for each chain of its row. SI units.
struct BoneLanes {
  Lanes3 rest;   ///< Unit, from the bone's start to its particle, in the parent's frame at rest.
  Lanes3 pull;   ///< The same of its default direction.
  Lanes3 joint;  ///< Start at rest, head space.
  Lanes length;
  Lanes per_length;
  Lanes hit_radius;
  Lanes limit_cosine;  ///< Of the largest angle to the default direction; -2 for none.
  Lanes parent_share;
  Lanes torsion;
  Lanes resistance;
  Lanes carried;  ///< Moment of inertia of all that hangs from the start, at rest, if bones weigh a kilogram a metre:
                  ///< kg m^2.
  alignas(64) std::uint32_t colliders[kLanes];  ///< Sets.
  alignas(64) std::int32_t levels[kLanes];  ///< In how many levels of detail, from the finest, the bone is simulated.
};

/// What bounds a bone's direction, of a row in which some bone has a LimitRecord. Two angles: the first from the axes'
/// y to the side of z, or for a cone to any side; the second from there to the side of x.
struct LimitLanes {
  LanesMatrix axes;  ///< From the limit's own axes to the parent's frame.
  Lanes is_cone;     ///< 1 or 0.
  Lanes first_cosine, first_sine;
  Lanes second_cosine, second_sine;
};

/// What the step of `coif` multiplies with: everything that depends on the bone and on dt, from compute_coefficients().
/// The offset is in bone lengths, the velocity in m/s. See MODEL.md, "The step".
struct CoifCoefficients {
  Lanes offset_from_offset;           ///< 1; the offset before, in bone lengths, as the others' results.
  Lanes offset_from_velocity;         ///< s/m
  Lanes offset_from_target_before;    ///< s/m; of the target's velocity at the start of the step
  Lanes offset_from_target_velocity;  ///< s/m; at its end
  Lanes offset_from_way;              ///< 1/m; of the target's way during the step
  Lanes offset_from_gravity;          ///< s^2/m
  Lanes offset_from_air;              ///< s/m
  Lanes velocity_from_offset;         ///< m/s per bone length
  Lanes velocity_from_velocity;
  Lanes velocity_from_target_before;
  Lanes velocity_from_target_velocity;
  Lanes velocity_from_way;      ///< 1/s
  Lanes velocity_from_gravity;  ///< s
  Lanes velocity_from_air;
  Lanes velocity_from_constraint;  ///< m/s per bone length that the force along the bone takes
};

/// The same for `passive`.
struct PassiveCoefficients {
  Lanes stiffness;  ///< 1/s^2
  Lanes damping;    ///< 1/s
  Lanes friction;   ///< 1/s
  Lanes gravity_scale;
  Lanes reach;    ///< s^2: how far an acceleration is believed to go on throughout the step.
  Lanes firm;     ///< 1/s^2: stiffness and damping against a turn by the end of the step.
  Lanes inertia;  ///< 1/s^2: force per kilogram and metre of such a turn's way, friction included.
};

/// The same for `thesis`.
struct ThesisCoefficients {
  Lanes kept_velocity;  ///< Share of the velocity against the air that friction leaves.
  Lanes fall;           ///< s: how far gravity accelerates.
};

/// What one simulated bone remembers under `coif`, world axes. Positions follow from the directions.
struct CoifState {
  Lanes3 direction;  ///< Unit.
  Lanes3 arm;        ///< Default direction; shorter than 1 where parent and head disagree about it.
  Lanes3 velocity;   ///< Of the particle relative to the bone's start, m/s.
  Lanes spin;        ///< Angular velocity about the direction, rad/s.
};

/// What one simulated bone remembers under `passive`, world axes.
inline constexpr float kNotBent = -1.0f;

struct PassiveState {
  Lanes3 direction;     ///< Unit.
  Lanes3 velocity;      ///< Of the particle relative to the bone's start, m/s.
  Lanes3 acceleration;  ///< Of the particle, as the forces on it say, m/s^2.
  Lanes3 lagged;        ///< The same as the method has it, which lags behind.
  Lanes tension;        ///< Along the bone, newtons for bones of a kilogram a metre; >= 0.
  Lanes bent;           ///< Energy of its bending, over its stiffness and what it carries; kNotBent: it was put there.
  /// 1: it lies on a collider of its head, 0: it does not. A chain's first bone has 2 more if any bone of it came to
  /// one in the last step.
  Lanes contact;
};

/// And what it remembers besides where bones may twist.
struct TwistState {
  Lanes3 before;  ///< Direction in the parent's frame, unit.
  Lanes cosine;   ///< Of half the angle by which the frame is turned about the direction against the shortest arc.
  Lanes sine;
};

/// What one simulated bone remembers under `thesis`: as Algorithm 1 has it.
struct ThesisState {
  Lanes3 position;  ///< Metres from the head's position, world axes.
  Lanes3 velocity;  ///< m/s, world.
};

/// What the heads of one block do during one step or sub-step. World axes where not said otherwise; metres of the hair
/// itself, of which the world has as many as the head's scale.
struct MoveLanes {
  Lanes4 rotation_before;  ///< World from head space.
  Lanes4 rotation;
  LanesMatrix from_head_before;  ///< The same as matrices.
  LanesMatrix from_head;
  Lanes3 way;              ///< Metres.
  Lanes3 velocity_before;  ///< m/s.
  Lanes3 velocity;
  Lanes3 angular_velocity_before;  ///< rad/s.
  Lanes3 angular_velocity;
  Lanes3 gravity;     ///< m/s^2.
  Lanes3 air;         ///< Velocity of the air, m/s.
  Lanes near_cosine;  ///< A bone whose direction turned by less cannot have jumped through a collider; see kFarTurn.
};

/// The heads of one block: where each is, where it goes during the coming step, and how it has moved. World axes and
/// metres.
struct HeadLanes {
  Lanes4 rotation;       ///< World from head space, now.
  Lanes4 next_rotation;  ///< At the end of the coming step.
  Lanes3 way;            ///< To there, metres.
  Lanes3 velocity;       ///< Now, m/s and rad/s.
  Lanes3 angular_velocity;
  Lanes3 mean_velocity;  ///< Over the last step. Where is_told: at the end of the coming one, for which the mean is not
                         ///< needed.
  Lanes3 mean_angular_velocity;
  Lanes is_told;                    ///< 1: the host said how fast the head arrives; or 0.
  Lanes last_dt;                    ///< Seconds; 0: there was no step yet.
  Lanes quiet;                      ///< Seconds for which head and hair have been at rest.
  Lanes per_scale;                  ///< One by the head's scale at the end of the coming step.
  double next_position[3][kLanes];  ///< World, metres.
};

/// What a step makes of them before it moves any bone.
struct HeadStepLanes {
  Lanes3 turn;  ///< Rotation vector of the whole step, radians.
  Lanes3 next_velocity;
  Lanes3 next_angular_velocity;
  Lanes is_far;  ///< 1 where the head moves further than it can have moved, else 0.
};

}  // namespace coif
