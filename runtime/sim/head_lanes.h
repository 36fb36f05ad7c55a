#pragma once
// What happens to one head of a block of sixteen, whoever keeps the blocks: a crowd of one asset, or a world of many.

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

/// A head that stands is told where it stands in every frame, and most of a crowd may stand: what was told before is
/// known by its bits, before anything is computed.
inline bool is_told_again(const HeadPose* poses, const HeadPose* told, std::size_t count) {
  return std::memcmp(poses, told, count * sizeof(HeadPose)) == 0;
}

// In place of a pose's first coordinate; bits that are no host's.
inline constexpr std::uint64_t kToldVelocity = 0x7FF8'C01F'C01F'C01F, kToldNothing = 0x7FF8'C01F'C01F'C01E;

/// What was told came with a velocity: the same pose without one says something else.
inline void forget_told(HeadPose& told) { told.position[0] = bit_cast<double>(kToldVelocity); }

/// No pose has been told yet: the first one puts the head there, and be it where it is already.
inline void begin_untold(HeadPose& told) { told.position[0] = bit_cast<double>(kToldNothing); }
inline bool is_untold(const HeadPose& told) { return bit_cast<std::uint64_t>(told.position[0]) == kToldNothing; }

/// Heads at the identity pose, at rest. `heads` are zeros.
inline void stand_upright(HeadLanes& heads) {
  for (float& w : heads.rotation.w.v) w = 1.0f;
  for (float& w : heads.next_rotation.w.v) w = 1.0f;
  for (float& per_scale : heads.per_scale.v) per_scale = 1.0f;
}

/// What has been set replaces what was set before; the way is counted from where the last step left the head. False
/// where it is too far for single precision.
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

/// True where the head is at this pose and was told nothing else.
inline bool stays(const HeadLanes& heads, std::uint32_t i, const HeadPose& unit) {
  return lane(heads.rotation, i) == unit.rotation && heads.per_scale.v[i] == 1.0f / unit.scale &&
         heads.next_position[0][i] == unit.position[0] && heads.next_position[1][i] == unit.position[1] &&
         heads.next_position[2][i] == unit.position[2];
}

/// `velocity` may be null: nothing is told.
inline void tell_velocity(HeadLanes& heads, std::uint32_t i, const HeadVelocity* velocity) {
  // Who takes back what was told finds the mean before gone.
  if (velocity == nullptr && heads.is_told.v[i] != 0.0f) heads.last_dt.v[i] = 0.0f;
  heads.is_told.v[i] = velocity != nullptr ? 1.0f : 0.0f;
  if (velocity == nullptr) return;
  set_lane(heads.mean_velocity, i, velocity->linear);
  set_lane(heads.mean_angular_velocity, i, velocity->angular);
}

/// The head is at its next pose, at rest.
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

/// What a jump of a head does to its hair: it is turned as if it were rigid, then it goes and turns faster with its
/// head by so much, world, m/s and rad/s.
struct HairJump {
  Quat turn;
  Vec3 velocity, turning;

  [[nodiscard]] bool is_faster() const { return !(velocity == Vec3{} && turning == Vec3{}); }
};

/// Puts the head, without a way there, where it has to be to arrive at its next pose in `dt` seconds if it goes on as
/// it did, in its own new directions, or as it was told to.
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

/// A frame took longer than is simulated. The head does not stop for it: the share of its way that comes before goes by
/// with the hair as it is. `turn` is that of the whole step. Returns by what the hair has to be turned.
inline Quat carry_head(HeadLanes& heads, std::uint32_t i, float share, const Vec3& turn) {
  const Quat by = rotation_by(turn * share);
  set_lane(heads.rotation, i, renormalised(by * lane(heads.rotation, i)));
  set_lane(heads.way, i, lane(heads.way, i) * (1.0f - share));
  return by;
}

/// False for a head that moves, though no step has seen it yet.
inline bool is_still(const HeadLanes& heads, std::uint32_t i) {
  return lane(heads.way, i) == Vec3{} && lane(heads.rotation, i) == lane(heads.next_rotation, i);
}

/// For HeadCode::finish().
inline RestWatch rest_watch(const StepSettings& settings, float dt) {
  return {dt, settings.sleep_speed * settings.sleep_speed, settings.sleep_after};
}

/// After HeadCode::finish(), of the first `count` lanes: adds to `may_sleep` who may. Returns those whose hair has to
/// be put to rest, since it flies or the head is lost.
inline std::uint32_t sort_out(const RestingHeads& resting, std::uint32_t count, std::uint16_t is_lost,
                              std::uint16_t& may_sleep) {
  const std::uint32_t in_use = (1u << count) - 1, ended = (is_lost | resting.flies) & in_use;
  may_sleep = std::uint16_t(may_sleep | (resting.may_sleep & in_use & ~ended));
  return ended;
}

}  // namespace coif
