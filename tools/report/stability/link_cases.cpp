#include "report/stability/measure_stability.h"

#include <cmath>
#include <memory>
#include <utility>

namespace coif::report {
namespace {

using Eigen::Vector3d;

StressRig sheet() {
  StressRig rig;
  rig.chains = 6;
  rig.bones_per_chain = 6;
  rig.chain_spacing = 0.03;
  rig.root_resistance = 0.1;
  rig.tip_resistance = 0.02;
  rig.torsion = double(kShortestArc);
  rig.is_linked = true;
  return rig;
}

Stress sheet_case(const char* name, const char* description, const StressRig& rig, motion::Motion motion) {
  Stress stress;
  stress.about = {name, description};
  stress.rig = rig;
  stress.head = moving(motion);
  stress.settles = false;  // links hold hair elsewhere than where it would hang alone
  return stress;
}

MovingCollider fist(const Vector3d& place) {
  MovingCollider collider;
  collider.shape = ColliderShape::kSphere;
  for (int i = 0; i < 3; ++i) collider.center[i] = place[i];
  collider.radius = 0.04f;
  return collider;
}

}  // namespace

std::vector<Stress> link_cases() {
  std::vector<Stress> all;
  const auto add = [&](const char* name, const char* description, const StressRig& rig, motion::Motion motion,
                       double dt) {
    all.push_back(sheet_case(name, description, rig, motion));
    all.back().dt = {dt};
  };
  add("linked", "six chains that hang together, the head shaken", sheet(), motion::Motion::kTurn, 1.0 / 60);
  add("linked at 12 fps", "the same in slow frames", sheet(), motion::Motion::kTurn, 1.0 / 12);
  add("linked, tumbling", "the same in a somersault", sheet(), motion::Motion::kTumble, 1.0 / 30);
  add("linked, teleporting", "the same, put elsewhere now and then", sheet(), motion::Motion::kTeleport, 1.0 / 60);
  StressRig rig = sheet();
  rig.chains = 24;
  rig.chain_spacing = 0.01;
  add("linked, two dozen", "24 chains a centimetre apart", rig, motion::Motion::kTurn, 1.0 / 30);
  rig = sheet();
  rig.link_stretch = 0;
  add("linked, stretching nothing", "links that are never longer than at rest", rig, motion::Motion::kTumble, 1.0 / 60);
  rig = sheet();
  rig.branching = 2;
  rig.bones_per_chain = 7;
  add("linked trees", "chains that branch", rig, motion::Motion::kTurn, 1.0 / 60);
  rig = sheet();
  rig.root_resistance = rig.tip_resistance = 1e-4;
  rig.friction = 0;
  add("linked, next to no pose", "soft and undamped", rig, motion::Motion::kTumble, 1.0 / 60);
  rig = sheet();
  rig.limit = LimitKind::kCone;
  add("linked within cones", "bones with limits, which links do not turn", rig, motion::Motion::kTurn, 1.0 / 60);
  add("a hand through a sheet", "a fist that moves to and fro between two of the chains", sheet(),
      motion::Motion::kStill, 1.0 / 60);
  all.back().colliders = [](const lab::HairPlace& hair, double seconds) {
    const double off = 0.2 * std::sin(4 * seconds);
    return std::vector<MovingCollider>{fist(hair.middle + hair.outward * off)};
  };
  return all;
}

}  // namespace coif::report
