#pragma once
// Operations on one head of a block of sixteen.

#include "head_pose.h"
#include "lanes/lane_code.h"
#include "lanes/lane_layout.h"
#include "vector_math.h"

#include <coif/bit_cast.h>
#include <coif/hair.h>

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace coif {

/// Whether the host sets the same poses again. A host sets every head's pose in every frame, and most of a crowd may
/// stand still: comparing bits comes before any computation.
inline bool is_told_again(const HeadPose* poses, const HeadPose* told, std::size_t count) {
  return std::memcmp(poses, told, count * sizeof(HeadPose)) == 0;
}

// Replace a pose's first coordinate; bits that no host gives.
inline constexpr std::uint64_t kToldVelocity = 0x7FF8'C01F'C01F'C01F, kToldNothing = 0x7FF8'C01F'C01F'C01E;

/// The last pose came with a velocity: the same pose without one is a change.
inline void forget_told(HeadPose& told) { told.position[0] = bit_cast<double>(kToldVelocity); }

/// No pose has been set yet: the first one puts the head there, even if it stands there already.
inline void begin_untold(HeadPose& told) { told.position[0] = bit_cast<double>(kToldNothing); }
inline bool is_untold(const HeadPose& told) { return bit_cast<std::uint64_t>(told.position[0]) == kToldNothing; }

/// Puts heads at the identity pose, at rest. `heads` must be zeros.
inline void stand_upright(HeadLanes& heads) {
  for (float& w : heads.rotation.w.v) w = 1.0f;
  for (float& w : heads.next_rotation.w.v) w = 1.0f;
  for (float& per_scale : heads.per_scale.v) per_scale = 1.0f;
}

/// Puts one of them there, whatever it was before.
inline void stand_upright(HeadLanes& heads, std::uint32_t i) {
  Lanes* const all = reinterpret_cast<Lanes*>(&heads);
  for (std::size_t n = 0; n < offsetof(HeadLanes, next_position) / sizeof(Lanes); ++n) all[n].v[i] = 0.0f;
  for (auto& axis : heads.next_position) axis[i] = 0.0;
  heads.rotation.w.v[i] = heads.next_rotation.w.v[i] = heads.per_scale.v[i] = 1.0f;
}

/// Sets a new target, which replaces the one set before; the way is counted from where the last step left the head.
/// False where it is too far for single precision.
inline bool aim_head(HeadLanes& heads, std::uint32_t i, const HeadPose& unit) {
  const double from[3] = {heads.next_position[0][i], heads.next_position[1][i], heads.next_position[2][i]};
  Vec3 way;
  const bool is_near = displacement(from, unit.position, way);
  if (is_near) set_lane(heads.way, i, lane(heads.way, i) + way);
  set_lane(heads.next_rotation, i, unit.rotation);
  heads.per_scale.v[i] = 1.0f / unit.scale;
  for (int axis = 0; axis < 3; ++axis) heads.next_position[axis][i] = unit.position[axis];
  return is_near;
}

/// True where the head is at this pose and has no other target.
inline bool stays(const HeadLanes& heads, std::uint32_t i, const HeadPose& unit) {
  return lane(heads.rotation, i) == unit.rotation && heads.per_scale.v[i] == 1.0f / unit.scale &&
         heads.next_position[0][i] == unit.position[0] && heads.next_position[1][i] == unit.position[1] &&
         heads.next_position[2][i] == unit.position[2];
}

/// `velocity` may be null: none was set.
inline void tell_velocity(HeadLanes& heads, std::uint32_t i, const HeadVelocity* velocity) {
  // After a velocity was set and is taken back, the mean of before is no longer known.
  if (velocity == nullptr && heads.is_told.v[i] != 0.0f) heads.last_dt.v[i] = 0.0f;
  heads.is_told.v[i] = velocity != nullptr ? 1.0f : 0.0f;
  if (velocity == nullptr) return;
  set_lane(heads.mean_velocity, i, velocity->linear);
  set_lane(heads.mean_angular_velocity, i, velocity->angular);
}

/// Puts the head at its next pose, at rest.
inline void stop_head(HeadLanes& heads, std::uint32_t i) {
  set_lane(heads.rotation, i, lane(heads.next_rotation, i));
  for (Lanes3* const vector :
       {&heads.way, &heads.velocity, &heads.angular_velocity, &heads.mean_velocity, &heads.mean_angular_velocity}) {
    set_lane(*vector, i, Vec3{});
  }
  heads.is_told.v[i] = 0.0f;
  heads.last_dt.v[i] = 0.0f;
  heads.quiet.v[i] = 0.0f;
}

/// The effect of a head's jump on its hair: a rigid turn, and then an added velocity of the head and the hair, world,
/// m/s and rad/s.
struct HairJump {
  Quat turn;
  Vec3 velocity, turning;

  [[nodiscard]] bool is_faster() const { return !(velocity == Vec3{} && turning == Vec3{}); }
};

/// Puts the head at the place from which it arrives at its next pose in `dt` seconds, at its present velocity in its
/// own new directions, or at the velocity that was set.
inline HairJump jump_head(HeadLanes& heads, std::uint32_t i, float dt) {
  const bool is_told = heads.is_told.v[i] != 0.0f;
  const Quat now = lane(heads.rotation, i);
  const Vec3 turning = lane(is_told ? heads.mean_angular_velocity : heads.angular_velocity, i);
  const Quat expected = rotation_by(turning * dt) * now;
  HairJump jump{renormalised(lane(heads.next_rotation, i) * conjugate(expected)), {}, {}};
  const auto turn_lane = [&](Lanes3& velocity) { set_lane(velocity, i, rotate(jump.turn, lane(velocity, i))); };
  for (Lanes3* const velocity : {&heads.velocity, &heads.angular_velocity}) turn_lane(*velocity);
  if (is_told) {
    jump.velocity = lane(heads.mean_velocity, i) - lane(heads.velocity, i);
    jump.turning = turning - lane(heads.angular_velocity, i);
    set_lane(heads.velocity, i, lane(heads.mean_velocity, i));
    set_lane(heads.angular_velocity, i, turning);
  } else {
    for (Lanes3* const velocity : {&heads.mean_velocity, &heads.mean_angular_velocity}) turn_lane(*velocity);
  }
  set_lane(heads.rotation, i, renormalised(jump.turn * now));
  set_lane(heads.way, i, lane(heads.velocity, i) * dt);
  return jump;
}

/// For a frame that took longer than is simulated: moves the head along the first share of its way and the hair rigidly
/// with it. `turn` is that of the whole step. Returns the rotation for the hair.
inline Quat carry_head(HeadLanes& heads, std::uint32_t i, float share, const Vec3& turn) {
  const Quat by = rotation_by(turn * share);
  set_lane(heads.rotation, i, renormalised(by * lane(heads.rotation, i)));
  set_lane(heads.way, i, lane(heads.way, i) * (1.0f - share));
  return by;
}

/// False for a head that has a way ahead, even if no step has seen it yet.
inline bool is_still(const HeadLanes& heads, std::uint32_t i) {
  return lane(heads.way, i) == Vec3{} && lane(heads.rotation, i) == lane(heads.next_rotation, i);
}

/// The arguments of HeadCode::finish().
inline RestWatch rest_watch(const StepSettings& settings, float dt) {
  return {dt, settings.sleep_speed * settings.sleep_speed, settings.sleep_after};
}

/// Runs after HeadCode::finish(), for the first `count` lanes: adds the lanes that may sleep to `may_sleep`. Returns
/// the lanes whose hair has to be put to rest, since its numbers overflow or the head is lost.
inline std::uint32_t sort_out(const RestingHeads& resting, std::uint32_t count, std::uint16_t is_lost,
                              std::uint16_t& may_sleep) {
  const std::uint32_t in_use = (1u << count) - 1, ended = (is_lost | resting.flies) & in_use;
  may_sleep = std::uint16_t(may_sleep | (resting.may_sleep & in_use & ~ended));
  return ended;
}

}  // namespace coif
