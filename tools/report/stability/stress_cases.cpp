#include "report/stability/measure_stability.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace coif::report {
namespace {

using Eigen::Vector3d;

constexpr double kPi = std::numbers::pi;
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

StressedHead at_distance(StressedHead motion, double metres) {
  return [motion = std::move(motion), metres](double seconds) {
    HeadPose head = motion(seconds);
    for (double& coordinate : head.position) coordinate += metres;
    return head;
  };
}

StressedHead spinning(double radians_per_second) {
  return [radians_per_second](double seconds) {
    const double half = 0.5 * radians_per_second * seconds;
    HeadPose head;
    head.rotation = {0, float(std::sin(half)), 0, float(std::cos(half))};
    return head;
  };
}

/// Away and back, twice a second.
StressedHead hopping(double metres) {
  return [metres](double seconds) {
    HeadPose head;
    head.position[0] = std::fmod(seconds, 0.5) < 0.25 ? 0 : metres;
    return head;
  };
}

/// Now and then no number.
StressedHead failing(StressedHead motion) {
  return [motion = std::move(motion)](double seconds) {
    HeadPose head = motion(seconds);
    if (std::fmod(seconds, 0.5) > 0.45) head.position[1] = kNan;
    return head;
  };
}

Stress shaken(std::string name, std::string description) {
  Stress stress;
  stress.about = {std::move(name), std::move(description)};
  stress.head = moving(motion::Motion::kTurn);
  return stress;
}

Stress shaken_rig(std::string name, std::string description, const StressRig& rig) {
  Stress stress = shaken(std::move(name), std::move(description));
  stress.rig = rig;
  return stress;
}

void add_time_steps(std::vector<Stress>& all) {
  const double lengths[] = {1.0e-6, 1.0e-4, 1.0e-3, 1.0 / 240, 1.0 / 60, 1.0 / 15, 0.1, 0.5, 1.0};
  for (const double dt : lengths) {
    Stress stress = shaken(fmt::format("dt {:.3g} s", dt), "the head shaken, one step after the other of this length");
    stress.dt = {dt};
    stress.steps = dt < 1.0e-3 ? 2000 : std::size_t(std::max(20.0, 3 / dt));
    all.push_back(std::move(stress));
  }
  const std::pair<const char*, std::vector<double>> patterns[] = {
      {"dt irregular", {1.0 / 60, 1.0 / 240, 1.0 / 15, 1.0e-3, 0.05, 1.0 / 144}},
      {"dt zero", {1.0 / 60, 0.0}},
      {"dt negative", {1.0 / 60, -1.0 / 60}},
      {"dt not a number", {1.0 / 60, kNan}},
      {"dt infinite", {1.0 / 60, std::numeric_limits<double>::infinity()}},
  };
  for (const auto& [name, dt] : patterns) {
    Stress stress = shaken(name, "the head shaken, such steps among usual ones");
    stress.dt = dt;
    all.push_back(std::move(stress));
  }
}

void add_parameters(std::vector<Stress>& all) {
  for (const double resistance : {0.0, 1.0e-6, 1.0 - 1.0e-6, 1.0}) {
    StressRig rig;
    rig.root_resistance = rig.tip_resistance = resistance;
    const bool stiff = resistance > 0.5;
    all.push_back(shaken_rig(fmt::format("resistance {}", resistance),
                             stiff ? "hair that hardly leaves its pose" : "hair with next to no pose", rig));
    all.back().settles = stiff;  // The others swing for minutes.
  }
  for (const double friction : {0.0, 1.0e2, 1.0e4}) {
    StressRig rig;
    rig.friction = friction;
    all.push_back(shaken_rig(fmt::format("friction {:g}", friction), "1/s, in air that moves with the head", rig));
    all.back().settles = friction < 1.0e4;
  }
  for (const double gravity : {0.0, 1.0e2, 1.0e5}) {
    all.push_back(shaken_rig(fmt::format("gravity {:g}", gravity), "m/s^2", {}));
    all.back().scene.gravity.y() = -gravity;
  }
  StressRig tiny;
  tiny.root_resistance = tiny.tip_resistance = tiny.friction = tiny.gravity_scale = tiny.torsion = 1.0e-40;
  all.push_back(shaken_rig("denormal parameters", "resistance, friction, gravity and torsion of 1e-40", tiny));
  all.back().settles = false;
}

void add_lengths(std::vector<Stress>& all) {
  for (const double length : {1.0e-5, 1.0e-2, 1.0, 1.0e3}) {
    StressRig rig;
    rig.bone_length = length;
    all.push_back(shaken_rig(fmt::format("length {:g} m", length), "of every bone", rig));
  }
  StressRig mixed;
  mixed.bone_length = 1.0e-3;
  mixed.length_ratio = 1000;
  all.push_back(shaken_rig("lengths 1000:1", "bones of 1 mm and of 1 m in turns", mixed));
}

void add_shapes(std::vector<Stress>& all) {
  for (const std::uint32_t count : {1u, 4u, 16u, 64u, 256u}) {
    StressRig rig;
    rig.bones_per_chain = count;
    rig.bone_length = 0.4 / count;
    all.push_back(shaken_rig(fmt::format("{} bones", count), "chains of 0.4 m in so many bones", rig));
    all.back().settles = count <= 16;  // Longer chains of soft bones need minutes.
  }
  StressRig tree;
  tree.bones_per_chain = 127;
  tree.branching = 2;
  all.push_back(shaken_rig("branching", "every bone carries two, seven deep", tree));
  StressRig coincident;
  coincident.chains = 8;
  coincident.chain_spacing = 0;
  all.push_back(shaken_rig("coincident chains", "eight chains in the same place", coincident));
  StressRig rooted_inside;
  rooted_inside.root_offset = -0.06;
  all.push_back(shaken_rig("roots in the head", "chains that start 6 cm below the surface", rooted_inside));
  for (const double radius : {1.0e-4, 100.0}) {
    StressRig rig;
    rig.head_radius = radius;
    all.push_back(shaken_rig(fmt::format("head radius {:g} m", radius), "of the sphere that hair stays out of", rig));
  }
}

/// Hair that swings, which is where energy from nowhere shows.
void add_lively_hair(std::vector<Stress>& all) {
  for (const std::uint32_t count : {3u, 6u, 16u, 64u}) {
    for (const double ratio : {0.25, 0.0}) {
      StressRig rig;
      rig.bones_per_chain = count;
      rig.bone_length = 0.6 / count;
      rig.root_resistance = 0.08;
      rig.tip_resistance = 0.003;
      rig.damping_ratio = ratio;
      rig.friction = 0;
      all.push_back(shaken_rig(fmt::format("{} bones, damping {:g}", count, ratio),
                               "soft chains of 0.6 m without friction, damped by this share of critical", rig));
      all.back().settles = false;
    }
  }
  for (const double resistance : {0.5, 0.965, 0.9991}) {
    StressRig rising;
    rising.root_resistance = 0.003;
    rising.tip_resistance = resistance;
    rising.damping_ratio = 0.25;
    all.push_back(shaken_rig(fmt::format("tips of {:.0e} 1/s^2", resistance / (1 - resistance) * 3600),
                             "stiffness that rises from a soft root to the tip, lightly damped", rising));
    all.back().settles = false;
  }
  for (const double ratio : {100.0, 0.01}) {
    StressRig heavy;
    heavy.tip_ratio = ratio;
    heavy.bone_length = ratio > 1 ? 0.005 : 0.05;
    heavy.damping_ratio = 0.25;
    all.push_back(shaken_rig(fmt::format("tips {:g} times as heavy", ratio),
                             "the last bone of a lightly damped chain is longer and heavier by this factor", heavy));
    all.back().settles = false;
  }
}

void add_movements(std::vector<Stress>& all) {
  Stress spin = shaken("spin 100 rad/s", "the head spins about the vertical");
  spin.head = spinning(100);
  spin.top_speed = 100;
  Stress hop = shaken("teleport 1e6 m", "the head jumps away and back, twice a second");
  hop.head = hopping(1.0e6);
  Stress distant = shaken("1e6 m from the origin", "a run, far out in the world");
  distant.head = at_distance(moving(motion::Motion::kRun), 1.0e6);
  Stress tumble = shaken("somersaults", "one every 1.5 s, at 15 frames per second");
  tumble.head = moving(motion::Motion::kTumble);
  tumble.dt = {1.0 / 15};
  Stress failing_pose = shaken("pose not a number", "the head's pose fails now and then");
  failing_pose.head = failing(moving(motion::Motion::kTurn));
  Stress denormal = shaken("denormal movement", "gravity of 1e-40 m/s^2 and a head that is 1e-310 m away");
  denormal.head = at_distance([](double) { return HeadPose{}; }, 1.0e-310);
  denormal.scene.gravity.y() = -1.0e-40;
  const std::pair<const char*, Vector3d> attitudes[] = {{"upside down", Vector3d::UnitX() * kPi},
                                                        {"on the back", Vector3d::UnitX() * (-kPi / 2)},
                                                        {"on the face", Vector3d::UnitX() * (kPi / 2)},
                                                        {"on one side", Vector3d::UnitZ() * (kPi / 2)},
                                                        {"three quarters over", Vector3d::UnitX() * (0.75 * kPi)}};
  for (const auto& [name, turn] : attitudes) {
    Stress held = shaken(name, "the head turned so within half a second, and held");
    held.head = [path = std::shared_ptr<motion::HeadPath>(motion::held_turn(turn.normalized(), turn.norm(), 0.5))](
                    double seconds) { return path->pose(seconds); };
    all.push_back(std::move(held));
  }
  for (Stress* stress : {&spin, &hop, &distant, &tumble, &failing_pose, &denormal}) all.push_back(std::move(*stress));
}

/// Beyond the limits is where a shaken head throws hair.
void add_limits(std::vector<Stress>& all) {
  const std::pair<const char*, LimitKind> kinds[] = {
      {"cone", LimitKind::kCone}, {"hinge", LimitKind::kHinge}, {"spherical", LimitKind::kSpherical}};
  for (const auto& [name, kind] : kinds) {
    for (const float angle : {0.0f, 0.4f, 1.2f}) {
      StressRig rig;
      rig.limit = kind;
      rig.limit_angles[0] = angle;
      rig.limit_angles[1] = angle / 2;
      rig.root_resistance = 0.08;
      rig.tip_resistance = 0.01;
      rig.torsion = double(kShortestArc);
      all.push_back(
          shaken_rig(fmt::format("{} of {:g} rad", name, angle), "soft chains whose bones have such limits", rig));
      all.back().dt = {angle < 1 ? 1.0 / 60 : 1.0 / 15};
      all.back().settles = false;
    }
  }
}

void add_soaks(std::vector<Stress>& all) {
  Stress soak = shaken_rig("soak", "a million frames of running; ten times fewer for solvers that do not ship", {});
  soak.head = moving(motion::Motion::kRun);
  soak.steps = 1'000'000;
  soak.steps_of_others = 100'000;
  all.push_back(std::move(soak));
}

}  // namespace

StressedHead moving(motion::Motion motion) {
  return [path = std::shared_ptr<motion::HeadPath>(motion::path_of(motion))](double seconds) {
    return path->pose(seconds);
  };
}

std::vector<Stress> stress_cases() {
  std::vector<Stress> all;
  add_time_steps(all);
  add_parameters(all);
  add_lengths(all);
  add_shapes(all);
  add_lively_hair(all);
  add_movements(all);
  add_limits(all);
  for (Stress& stress : link_cases()) all.push_back(std::move(stress));
  for (Stress& stress : character_cases()) all.push_back(std::move(stress));
  for (Stress& stress : body_cases()) all.push_back(std::move(stress));
  add_soaks(all);
  return all;
}

}  // namespace coif::report
