#pragma once

#include <coif/math.h>
#include <coif/status.h>

#include <cstdint>

namespace coif {

/// What the head does during one step, world axes.
struct HeadMove {
  Quat rotation_before;   ///< World from head space at the start of the step, unit.
  Quat rotation;          ///< At its end.
  Vec3 displacement;      ///< Metres, its way during the step.
  Vec3 velocity;          ///< m/s at the end.
  Vec3 angular_velocity;  ///< rad/s at the end.
};

/// Follows one head from pose to pose and makes a smooth path of them. Between two poses the path is the cubic with the
/// velocities at both ends; the velocity at a new pose is that of the parabola through the last three. Frames of
/// different lengths are allowed for. Without it a head is a polygon in time: at each frame its velocity jumps, and hair
/// in sub-steps feels every corner.
class HeadTrack {
 public:
  /// At `pose`, at rest. kBadPose as for Hair::set_head().
  Status reset(const HeadPose& pose);

  /// Where the head is at the end of the coming step. kBadPose as for Hair::set_head(), with nothing changed.
  Status set_next(const HeadPose& pose);

  /// False where the next pose is too far away to be a movement in single precision.
  [[nodiscard]] bool can_move() const;

  /// Metres and radians from the present pose to the next.
  [[nodiscard]] double distance() const;
  [[nodiscard]] float angle() const;

  /// Begins the step to the next pose, `dt` seconds (> 0) away. Follow with move() for each sub-step, then finish().
  void begin(float dt);
  /// Sub-step `index` of `count`, in order from 0.
  [[nodiscard]] HeadMove move(std::uint32_t index, std::uint32_t count) const;
  void finish();

  /// Puts the head, without a way there, where it has to be to arrive at its next pose in `dt` seconds (>= 0) if it goes
  /// on as it did, in its own new directions. Returns the rotation that the hair has to be carried by.
  Quat jump(float dt);

  /// At the present pose, as a step of no length.
  [[nodiscard]] HeadMove here() const;
  [[nodiscard]] const HeadPose& pose() const { return now_; }
  [[nodiscard]] const HeadPose& next_pose() const { return next_; }

 private:
  HeadPose now_;
  HeadPose next_;
  Vec3 velocity_;  ///< At now_.
  Vec3 angular_velocity_;
  Vec3 mean_velocity_;  ///< Over the last step, and over this one between begin() and finish().
  Vec3 mean_angular_velocity_;
  Vec3 next_velocity_;  ///< At next_, between begin() and finish().
  Vec3 next_angular_velocity_;
  float last_dt_ = 0;  ///< 0: there was no step yet.
};

}  // namespace coif
