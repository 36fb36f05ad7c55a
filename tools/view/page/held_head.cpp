#include "view/page/held_head.h"

#include <cmath>

namespace coif::view {
namespace {

constexpr double kHeld = 28, kReleased = 11;  // 1/s: as quick as a hand, and as a neck

}  // namespace

void HeldHead::release() {
  held_ = false;
  wanted_.setZero();
  turned_.setZero();
}

// A critically damped spring, exact over any step.
void HeldHead::Follower::step(const Eigen::Vector3d& wanted, double quickness, double dt) {
  const double fade = std::exp(-quickness * dt);
  const Eigen::Vector3d away = place - wanted;
  const Eigen::Vector3d pull = rate + quickness * away;
  place = wanted + (away + pull * dt) * fade;
  rate = (rate - quickness * pull * dt) * fade;
}

bool HeldHead::Follower::is_near(const Eigen::Vector3d& wanted) const {
  return (place - wanted).norm() < 1e-5 && rate.norm() < 1e-4;
}

void HeldHead::step(double dt) {
  const double quickness = held_ ? kHeld : kReleased;
  offset_.step(wanted_, quickness, dt);
  turn_.step(turned_, quickness, dt);
  if (!is_at_rest()) return;
  offset_ = {wanted_, Eigen::Vector3d::Zero()};  // Otherwise the hair would never fall asleep.
  turn_ = {turned_, Eigen::Vector3d::Zero()};
}

bool HeldHead::is_at_rest() const { return offset_.is_near(wanted_) && turn_.is_near(turned_); }

HeadPose HeldHead::moved(HeadPose pose) const {
  for (int i = 0; i < 3; ++i) pose.position[i] += offset_.place[i];
  const double angle = turn_.place.norm();
  if (angle == 0) return pose;
  const Quat& q = pose.rotation;
  const Eigen::Quaterniond own(double(q.w), double(q.x), double(q.y), double(q.z));
  const Eigen::Quaternionf turned = (Eigen::AngleAxisd(angle, turn_.place / angle) * own).normalized().cast<float>();
  pose.rotation = {turned.x(), turned.y(), turned.z(), turned.w()};
  return pose;
}

}  // namespace coif::view
