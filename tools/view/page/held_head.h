#pragma once

#include <coif/hair.h>

#include <Eigen/Geometry>

namespace coif::view {

/// A head under the visitor's mouse: follows it, and springs back when it is released. World axes, metres, radians,
/// seconds.
class HeldHead {
 public:
  void grab() { held_ = true; }
  void drag(const Eigen::Vector3d& by) { wanted_ += by; }
  /// About `axis`, unit.
  void turn(const Eigen::Vector3d& axis, double angle) { turned_ += axis * angle; }
  void release();
  [[nodiscard]] bool is_held() const { return held_; }

  void step(double dt);
  [[nodiscard]] bool is_at_rest() const;

  /// `pose` moved along and turned about the head's joint.
  [[nodiscard]] HeadPose moved(HeadPose pose) const;
  [[nodiscard]] const Eigen::Vector3d& offset() const { return offset_.place; }

 private:
  /// Follows the wanted value without overshooting.
  struct Follower {
    Eigen::Vector3d place = Eigen::Vector3d::Zero(), rate = Eigen::Vector3d::Zero();
    void step(const Eigen::Vector3d& wanted, double quickness, double dt);
    [[nodiscard]] bool is_near(const Eigen::Vector3d& wanted) const;
  };

  bool held_ = false;
  Eigen::Vector3d wanted_ = Eigen::Vector3d::Zero(), turned_ = Eigen::Vector3d::Zero();
  Follower offset_, turn_;
};

}  // namespace coif::view
