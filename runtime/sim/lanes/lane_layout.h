#pragma once
// The memory layout for code that steps many chains at once. A "lane" is one place in a SIMD vector. Sixteen lanes are
// stored side by side on every processor; vectors of 4, 8 or 16 lanes take them in 4, 2 or 1 parts.

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

/// The constants of a bone, one lane for each chain of its row. SI units.
struct BoneLanes {
  Lanes3 rest;   ///< Unit, from the bone's start to its particle, in the parent's frame at rest.
  Lanes3 pull;   ///< The default direction in the same frame, unit.
  Lanes3 joint;  ///< Start at rest, head space.
  Lanes length;
  Lanes per_length;
  Lanes hit_radius;
  Lanes limit_cosine;  ///< Cosine of the largest angle to the default direction; -2 for none.
  Lanes parent_share;
  Lanes torsion;
  Lanes resistance;
  /// Moment of inertia of everything that hangs from the start, at rest, for bones of a kilogram per metre: kg m^2.
  Lanes carried;
  alignas(64) std::uint32_t colliders[kLanes];  ///< Sets of colliders that the bone may touch.
  /// Number of levels of detail, from the finest, in which the bone is simulated.
  alignas(64) std::int32_t levels[kLanes];
};

/// The limits of a bone in a row in which some bone has a LimitRecord. Two angles: the first from the axes' y towards
/// z, or for a cone to any side; the second from there towards x.
struct LimitLanes {
  LanesMatrix axes;  ///< From the limit's own axes to the parent's frame.
  Lanes is_cone;     ///< 1 or 0.
  Lanes first_cosine, first_sine;
  Lanes second_cosine, second_sine;
};

/// The coefficients of a step of `coif`: everything that depends on the bone and on dt, from compute_coefficients().
/// The offset is in bone lengths, the velocity in m/s. See MODEL.md, "The step".
struct CoifCoefficients {
  Lanes offset_from_offset;           ///< 1; the offset before, in bone lengths like the other results
  Lanes offset_from_velocity;         ///< s/m
  Lanes offset_from_target_before;    ///< s/m; times the target's velocity at the start of the step
  Lanes offset_from_target_velocity;  ///< s/m; at its end
  Lanes offset_from_way;              ///< 1/m; times the target's way during the step
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

/// The coefficients of a step of `passive`.
struct PassiveCoefficients {
  Lanes stiffness;  ///< 1/s^2
  Lanes damping;    ///< 1/s
  Lanes friction;   ///< 1/s
  Lanes gravity_scale;
  Lanes reach;    ///< s^2: how far an acceleration is assumed to act throughout the step.
  Lanes firm;     ///< 1/s^2: stiffness and damping against a turn by the end of the step.
  Lanes inertia;  ///< 1/s^2: force per kilogram and metre of the way of such a turn, friction included.
};

/// The coefficients of a step of `thesis`.
struct ThesisCoefficients {
  Lanes kept_velocity;  ///< Share of the velocity against the air that is left after friction.
  Lanes fall;           ///< s: factor from gravity to velocity.
};

/// The state of one simulated bone under `coif`, world axes. Positions follow from the directions.
struct CoifState {
  Lanes3 direction;  ///< Unit.
  Lanes3 arm;        ///< Default direction; shorter than 1 where parent and head disagree about it.
  Lanes3 velocity;   ///< Velocity of the particle relative to the bone's start, m/s.
  Lanes spin;        ///< Angular velocity about the direction, rad/s.
};

/// PassiveState::bent of a bone that was put in place.
inline constexpr float kNotBent = -1.0f;

/// The state of one simulated bone under `passive`, world axes.
struct PassiveState {
  Lanes3 direction;     ///< Unit.
  Lanes3 velocity;      ///< Velocity of the particle relative to the bone's start, m/s.
  Lanes3 acceleration;  ///< Acceleration of the particle by the forces on it, m/s^2.
  Lanes3 lagged;        ///< The method's acceleration, which lags behind.
  Lanes tension;        ///< Along the bone, newtons for bones of a kilogram a metre; >= 0.
  /// Energy of its bending, divided by its stiffness and the mass that it carries; kNotBent: it was put there.
  Lanes bent;
  /// 1 where it lies on a collider of its head, else 0. A chain's first bone has 2 added if any of its bones came to
  /// one in the last step.
  Lanes contact;
};

/// The further state of a bone in a crowd where bones may twist.
struct TwistState {
  Lanes3 before;  ///< Direction in the parent's frame, unit.
  /// Cosine of half the angle by which the frame is turned about the direction, relative to the shortest arc.
  Lanes cosine;
  Lanes sine;
};

/// The state of one simulated bone under `thesis`, as in Algorithm 1.
struct ThesisState {
  Lanes3 position;  ///< Metres from the head's position, world axes.
  Lanes3 velocity;  ///< m/s, world.
};

/// The motion of the heads of one block during one step or sub-step. World axes unless stated otherwise; in the hair's
/// metres, of which the head's scale gives world metres.
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
  Lanes3 gravity;  ///< m/s^2.
  Lanes3 air;      ///< Velocity of the air, m/s.
  /// A bone whose direction turned by less than this cosine's angle cannot have jumped through a collider; see
  /// kFarTurn.
  Lanes near_cosine;
};

/// The heads of one block: place, target of the coming step, and past motion. World axes and metres.
struct HeadLanes {
  Lanes4 rotation;       ///< World from head space, now.
  Lanes4 next_rotation;  ///< At the end of the coming step.
  Lanes3 way;            ///< Way to the end of the coming step, metres.
  Lanes3 velocity;       ///< Now, m/s and rad/s.
  Lanes3 angular_velocity;
  /// Over the last step. Where is_told is set: at the end of the coming step, which does not need the mean.
  Lanes3 mean_velocity;
  Lanes3 mean_angular_velocity;
  Lanes is_told;                    ///< 1 where the host set the velocity at the end of the step, else 0.
  Lanes last_dt;                    ///< Seconds; 0: there was no step yet.
  Lanes quiet;                      ///< Seconds for which head and hair have been at rest.
  Lanes per_scale;                  ///< One by the head's scale at the end of the coming step.
  double next_position[3][kLanes];  ///< World, metres.
};

/// Values of a step that are found before any bone moves.
struct HeadStepLanes {
  Lanes3 turn;  ///< Rotation vector of the whole step, radians.
  Lanes3 next_velocity;
  Lanes3 next_angular_velocity;
  Lanes is_far;  ///< 1 where the head moves too far for a movement, else 0.
};

}  // namespace coif
