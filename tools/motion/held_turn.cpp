#include "motion/held_turn.h"

#include "motion/jet.h"

#include <algorithm>

namespace coif {
namespace {

class HeldTurn final : public HeadPath {
 public:
  HeldTurn(const Eigen::Vector3d& axis, double radians, double seconds)
      : axis_(axis), radians_(radians), seconds_(seconds) {}

  [[nodiscard]] HeadState at(double seconds, double inside) const override {
    const Jet u = inside < seconds_ ? Jet::time(std::max(seconds, 0.0)) * (1 / seconds_) : Jet(1.0);
    const Jet turn = radians_ * (u * u * u * (10 - 15 * u + 6 * u * u));
    HeadState state;
    state.rotation = Eigen::AngleAxisd(turn.value, axis_);
    state.angular_velocity = axis_ * turn.rate;
    state.angular_acceleration = axis_ * turn.acceleration;
    return state;
  }

  [[nodiscard]] std::vector<PathBreak> breaks(double until) const override {
    if (seconds_ > until) return {};
    return {{seconds_, false}};
  }

 private:
  Eigen::Vector3d axis_;
  double radians_;
  double seconds_;
};

}  // namespace

std::unique_ptr<HeadPath> held_turn(const Eigen::Vector3d& axis, double radians, double seconds) {
  return std::make_unique<HeldTurn>(axis, radians, seconds);
}

}  // namespace coif
