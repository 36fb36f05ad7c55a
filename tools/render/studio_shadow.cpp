#include "render/stage_renderer.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <string>

namespace coif::render {

namespace {

constexpr double kRoom = 1.1;  // Factor on the radius.

struct Ball {
  Eigen::Vector3d center;
  double radius;
};

/// Around the middle of their box.
Ball around(std::span<const Eigen::Vector3d> points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  Ball ball{box.center(), 0};
  for (const Eigen::Vector3d& point : points) ball.radius = std::max(ball.radius, (point - ball.center).norm());
  return ball;
}

}  // namespace

ShadowBall ball_around(std::span<const Eigen::Vector3d> points, std::span<const Eigen::Vector3d> places) {
  const Ball head = around(points), crowd = around(places);
  ShadowBall ball;
  Eigen::Map<Eigen::Vector3d>{ball.center} = head.center + crowd.center;
  ball.radius = float(kRoom * std::max(head.radius + crowd.radius, 1e-3));
  return ball;
}

tl::expected<StudioShadow, ToolError> StudioShadow::create(HairRenderer& renderer, const GlLoader& loader,
                                                           const ShadowDesc& desc) {
  StudioShadow studio;
  studio.shadow_ = std::make_unique<HairShadow>();
  if (studio.shadow_->create(renderer, loader, desc) == Status::kOk) return studio;
  return failure(ToolError::Kind::kUnsupported, std::string("the driver makes no shadow: ") + renderer.failure());
}

StudioShadow::~StudioShadow() {
  if (shadow_ != nullptr) shadow_->destroy();
}

Status StudioShadow::draw(const Light& light, const ShadowBall& ball, const StageRenderer& stage,
                          std::span<const HeadPose> heads, const ShadowCrowd* crowd) {
  if (const Status begun = shadow_->begin(light, ball); begun != Status::kOk) return begun;
  float clip[16];
  shadow_->clip_from_origin({}, clip);
  for (const HeadPose& head : heads) stage.draw_casters(Eigen::Map<const Eigen::Matrix4f>(clip), head);
  return shadow_->draw({crowd, crowd != nullptr ? 1u : 0u});
}

}  // namespace coif::render
