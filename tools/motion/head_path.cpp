#include "motion/head_path.h"

#include "motion/motion_path.h"

#include <algorithm>

namespace coif {
namespace {

HeadState state_of(const HeadMovement& moved) {
  HeadState state;
  state.position = {moved.x.value, moved.y.value, moved.z.value};
  state.velocity = {moved.x.rate, moved.y.rate, moved.z.rate};
  state.acceleration = {moved.x.acceleration, moved.y.acceleration, moved.z.acceleration};
  state.rotation = Eigen::AngleAxisd(moved.turn.value, moved.axis);
  state.angular_velocity = moved.axis * moved.turn.rate;
  state.angular_acceleration = moved.axis * moved.turn.acceleration;
  return state;
}

class MotionPath final : public HeadPath {
 public:
  explicit MotionPath(Motion motion) : motion_(motion) {}

  [[nodiscard]] HeadState at(double seconds, double inside) const override {
    if (seconds < 0) return standing(movement(motion_, 0, 0));
    return state_of(movement(motion_, seconds, std::max(inside, 0.0)));
  }
  [[nodiscard]] std::vector<PathBreak> breaks(double until) const override { return breaks_of(motion_, until); }

 private:
  static HeadState standing(const HeadMovement& moved) {
    HeadState state;
    state.position = {moved.x.value, moved.y.value, moved.z.value};
    state.rotation = Eigen::AngleAxisd(moved.turn.value, moved.axis);
    return state;
  }

  Motion motion_;
};

}  // namespace

HeadPose HeadPath::pose(double seconds) const { return pose_of(at(seconds)); }

std::unique_ptr<HeadPath> path_of(Motion motion) { return std::make_unique<MotionPath>(motion); }

HeadPose pose_of(const HeadState& state) {
  HeadPose pose;
  std::copy_n(state.position.data(), 3, pose.position);
  const Eigen::Quaternionf rotation = state.rotation.cast<float>();
  pose.rotation = {rotation.x(), rotation.y(), rotation.z(), rotation.w()};
  return pose;
}

}  // namespace coif
