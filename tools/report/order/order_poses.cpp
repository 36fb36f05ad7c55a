#include "report/order/order_poses.h"

#include "motion/hair_pose.h"
#include "motion/head_path.h"
#include "motion/motion.h"
#include "visibility/hair_surface.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

namespace coif {
namespace {

struct MovingPose {
  Motion motion;
  const char* name;
  double seconds[3];
};
constexpr MovingPose kMovingPoses[] = {{Motion::kTurn, "turn", {0.2, 0.45, 0.7}},
                                       {Motion::kCharge, "charge", {0.15, 0.35, 0.8}}};

tl::expected<PosedHair, ToolError> posed(const Asset& asset, const HeadPath* path, double seconds) {
  auto pose = simulate_pose(asset, path, seconds, {});
  if (!pose) return tl::unexpected(pose.error());
  std::vector<Eigen::Vector3f> positions = posed_positions(asset, pose->palette);
  return PosedHair{std::move(pose->palette), std::move(positions)};
}

}  // namespace

tl::expected<std::vector<OrderPose>, ToolError> make_order_poses(const Asset& asset) {
  auto rest = posed(asset, nullptr, 0);
  if (!rest) return tl::unexpected(rest.error());
  std::vector<OrderPose> poses = {{"rest", {std::move(*rest)}}};
  if (asset.dynamics().empty()) return poses;
  for (const MovingPose& moving : kMovingPoses) {
    poses.push_back({moving.name, {}});
    for (const double seconds : moving.seconds) {
      auto moment = posed(asset, path_of(moving.motion).get(), seconds);
      if (!moment) return tl::unexpected(moment.error());
      poses.back().moments.push_back(std::move(*moment));
    }
  }
  return poses;
}

std::vector<ViewAngle> spread_directions(std::uint32_t count) {
  constexpr double kDegrees = 180 / std::numbers::pi;
  constexpr double kTurn = 360 / std::numbers::phi;
  std::vector<ViewAngle> angles;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double height = 1 - (2 * i + 1.0) / count;
    angles.push_back({std::fmod(kTurn * i, 360), kDegrees * std::asin(height)});
  }
  return angles;
}

}  // namespace coif
