#include "report/stability/measure_stability.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace coif::report {
namespace {

using Eigen::AngleAxisd;
using Eigen::Isometry3d;
using Eigen::Translation3d;
using Eigen::Vector3d;
using std::numbers::pi;

Isometry3d resting_body(const Vector3d& /*joint*/, double /*seconds*/) { return Isometry3d::Identity(); }

Stress with_body(const char* name, const char* description, BodyMotion body) {
  Stress stress;
  stress.about = {name, description};
  stress.head = [](double) { return HeadPose{}; };
  stress.body = std::move(body);
  stress.dt = {1.0 / 30};
  stress.steps = 120;
  stress.settles = false;  // Hair may come to lie on it.
  return stress;
}

}  // namespace

std::vector<Stress> body_cases() {
  std::vector<Stress> all;
  for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kNod}) {
    const bool is_turn = motion == motion::Motion::kTurn;
    all.push_back(with_body(is_turn ? "head shakes over its body" : "head nods over its body",
                            "the asset's own body colliders stand still, 30 fps", resting_body));
    all.back().head = moving(motion);
  }
  all.push_back(with_body("shoulders shrug", "the body goes up by 10 cm and down, 2.5 times a second, 30 fps",
                          [](const Vector3d&, double seconds) {
                            const double up = 0.05 * (1 - std::cos(5 * pi * seconds));
                            return Isometry3d(Translation3d(0, up, 0));
                          }));
  all.push_back(with_body("body bones swing", "each about its joint, 60 deg to both sides, 1.5 times a second, 30 fps",
                          [](const Vector3d& joint, double seconds) {
                            const double angle = pi / 3 * std::sin(3 * pi * seconds);
                            const AngleAxisd turn(angle, Vector3d(1, 1, 1).normalized());
                            return Isometry3d(Translation3d(joint) * turn * Translation3d(-joint));
                          }));
  all.push_back(with_body("body is put elsewhere", "by 15 cm to the side and back, twice a second, within a step",
                          [](const Vector3d&, double seconds) {
                            const double side = std::fmod(seconds, 1.0) < 0.5 ? 0 : 0.15;
                            return Isometry3d(Translation3d(side, 0, 0));
                          }));
  all.push_back(with_body("body that is not a number", "every tenth step", [](const Vector3d&, double seconds) {
    const bool is_bad = std::fmod(seconds, 1.0 / 3) < 0.02;
    return Isometry3d(Translation3d(is_bad ? std::numeric_limits<double>::quiet_NaN() : 0, 0, 0));
  }));
  return all;
}

}  // namespace coif::report
