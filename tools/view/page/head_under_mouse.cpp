// The visitor's hand: the head under it, and its effect on that head.

#include "view/page/view_session.h"

#include <algorithm>
#include <cmath>

namespace coif::view {
namespace {

struct Ball {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  double radius = 0.12;  // metres: an adult's head
};

/// The largest collider on the head; without one a ball that hair surrounds.
Ball head_of(const Asset& asset, const std::vector<Eigen::Vector3d>& points) {
  Ball ball;
  double largest = 0;
  for (const ColliderRecord& collider : asset.colliders()) {
    const double radius = double(std::max({collider.radii[0], collider.radii[1], collider.radii[2]}));
    if (radius < largest || radius > 0.5) continue;
    largest = radius;
    ball = {{double(collider.center[0]), double(collider.center[1]), double(collider.center[2])}, radius};
  }
  if (largest > 0 || points.empty()) return ball;
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  return {box.center(), 0.4 * box.sizes().norm()};
}

/// World metres at the scene's middle that the canvas is high.
double seen_height(const render::Camera& camera) {
  const double steepness = camera.clip_from_world.row(1).head<3>().cast<double>().norm();
  return 2 * camera.eye.dot(camera.back) / steepness;
}

}  // namespace

bool ViewSession::grab(double x, double y) {
  if (!scene_ || width_ == 0 || height_ == 0) return false;
  const render::CrowdView& view = scene_->view(settings_, double(width_) / height_, std::uint32_t(heads_.size()));
  const Eigen::Matrix4d world_from_clip = view.camera.clip_from_world.cast<double>().inverse();
  const Eigen::Vector4d far = world_from_clip * Eigen::Vector4d(2 * x - 1, 1 - 2 * y, 1, 1);
  const Eigen::Vector3d ray = (far.head<3>() / far.w() - view.camera.eye).normalized();
  const Ball ball = head_of(asset_, scene_->points());
  for (const Eigen::Vector3d& place : view.places) {
    const Eigen::Vector3d towards = place + held_.offset() + ball.center - view.camera.eye;
    if ((towards - ray * ray.dot(towards)).norm() > ball.radius) continue;
    held_.grab();
    return true;
  }
  return false;
}

void ViewSession::drag(double across, double down) {
  if (!scene_ || width_ == 0 || height_ == 0) return;
  const render::Camera& camera = scene_->view(settings_, double(width_) / height_, std::uint32_t(heads_.size())).camera;
  const double metres = seen_height(camera);
  held_.drag(metres * (camera.right * (across * width_ / height_) - camera.up * down));
}

void ViewSession::turn(double across, double down) {
  if (!scene_ || width_ == 0 || height_ == 0) return;
  const render::Camera& camera = scene_->view(settings_, double(width_) / height_, std::uint32_t(heads_.size())).camera;
  held_.turn(camera.up, across);
  held_.turn(camera.right, down);
}

}  // namespace coif::view
