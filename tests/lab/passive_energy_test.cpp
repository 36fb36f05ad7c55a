// Energy from nowhere: hair that is let go, with the head at rest, gets no higher than it was.

#include "lab/passive_model.h"
#include "lab/reference_model.h"
#include "lab/reference_trial.h"
#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace coif::lab::passive_energy_test {

using Eigen::Vector3d;

struct Strand {
  int bones = 6;
  double root = 300, tip = 10;  ///< Stiffness, 1/s^2.
  double damping_ratio = 0;
  double tip_ratio = 1;  ///< The last bone is longer, and heavier, by this factor.
};

/// 0.6 m from the back of the head downwards, without friction.
TestRig make(const Strand& strand) {
  TestRig rig;
  std::uint32_t parent = 0;
  const double share = 1 / (strand.bones - 1 + strand.tip_ratio);
  for (int i = 0; i < strand.bones; ++i) {
    const double place = (i + 0.5) / strand.bones;
    TestBone bone;
    bone.parent = parent;
    bone.joint = {0, 0.02f, -0.11f};
    bone.rest_direction = place < 0.3 ? Vec3{0, -0.8f, -0.6f} : Vec3{0, -1, 0};
    bone.length = float(0.6 * share * (i + 1 == strand.bones ? strand.tip_ratio : 1));
    bone.stiffness = float(strand.root > 0 ? strand.root * std::pow(strand.tip / strand.root, place) : 0);
    bone.damping = float(2 * strand.damping_ratio * std::sqrt(bone.stiffness));
    bone.friction = 1;
    bone.torsion = kShortestArc;
    parent = rig.add(bone);
  }
  return rig;
}

/// The energy of a strand under a head that rests, from the ends of its bones.
class Energy {
 public:
  explicit Energy(const TestRig& rig) : opened_(rig.contents()), rig_(rig_of(opened_.asset())), model_(rig_.bones) {}

  /// What weight and bending alone have.
  [[nodiscard]] double potential(std::span<const Vec3> ends) const { return of(ends, ends, 1); }

  /// With that of the motion, halfway between two times dt seconds apart: right to the second order of dt.
  [[nodiscard]] double halfway(std::span<const Vec3> before, std::span<const Vec3> after, double dt) const {
    const double moving = of(after, before, dt) - potential(after);
    return moving + (potential(before) + potential(after)) / 2;
  }

 private:
  /// Bones that end at `ends`, and ended at `before`.
  [[nodiscard]] double of(std::span<const Vec3> ends, std::span<const Vec3> before, double dt) const {
    std::vector<BoneState> states;
    for (std::size_t i = 0; i < rig_.bones.size(); ++i) {
      const RigBone& bone = rig_.bones[i];
      const auto direction = [&](std::span<const Vec3> from) {
        const auto place = [&](int b) {
          return Vector3d(from[std::size_t(b)].x, from[std::size_t(b)].y, from[std::size_t(b)].z);
        };
        return Vector3d((place(int(i)) - (bone.parent < 0 ? bone.joint : place(bone.parent))).normalized());
      };
      const Vector3d now = direction(ends);
      const Eigen::Quaterniond up =
          bone.parent < 0 ? Eigen::Quaterniond::Identity() : states[std::size_t(bone.parent)].frame;
      states.push_back({frame_of_arc(bone, up, now), (now - direction(before)) / dt});
    }
    return model_.energy({}, {}, states);
  }

  OpenedAsset opened_;
  Rig rig_;
  PassiveModel model_;
};

/// Hair that was held 70 degrees aside by three times its weight, until it rested, and is let go.
struct LetGo {
  LetGo(const TestRig& rig, float dt) : energy(rig), test(rig, HairDesc{.solver = &kPassiveSolver}) {
    settings.dt = 1 / 60.0f;
    settings.sleep_after = INFINITY;
    settings.dynamics.friction = 30;
    step_for(12);
    rest = energy.potential(test.ends());
    settings.environment.gravity = {28, -10, 0};
    step_for(12);
    held = energy.potential(test.ends());
    settings.environment.gravity = {0, -9.81f, 0};
    settings.dynamics.friction = 0;
    settings.dt = dt;
  }

  void step() { EXPECT_EQ(test.hair.step(settings), Status::kOk); }
  void step_for(double seconds) {
    for (double t = 0; t < seconds; t += double(settings.dt)) step();
  }

  Energy energy;
  TestHair test;
  StepSettings settings;
  double rest = 0, held = 0;  ///< Energy, joules.
};

/// How much more potential energy hair has at any later time than when it was let go, as a share of what it had above
/// its rest.
double gain(const Strand& strand, float dt, int seconds = 6) {
  LetGo hair(make(strand), dt);
  double most = hair.held;
  for (double t = 0; t < seconds; t += double(dt)) {
    hair.step();
    most = std::max(most, hair.energy.potential(hair.test.ends()));
  }
  return (most - hair.held) / (hair.held - hair.rest);
}

/// Root mean squares would hide it: the worst of all steps.
double worst_gain(const Strand& strand) {
  double worst = 0;
  for (const float rate : {15.0f, 30.0f, 60.0f, 120.0f, 240.0f}) worst = std::max(worst, gain(strand, 1 / rate));
  return worst;
}

TEST(PassiveEnergy, HairThatIsLetGoGetsNoHigher) {
  for (const int bones : {1, 2, 3, 6, 16, 64}) {
    for (const auto& [root, tip] : {std::pair{300.0, 10.0}, {10.0, 10.0}, {10.0, 1e5}, {1e4, 1e4}, {4e6, 4e6}}) {
      for (const double ratio : {0.25, 0.0}) {
        EXPECT_LT(worst_gain({bones, root, tip, ratio, 1}), 0.01)
            << bones << " bones of " << root << " to " << tip << " 1/s^2, damped by " << ratio;
      }
    }
  }
}

/// By how much all of the energy rises above what it has been at any time before, as a share of what it was let go
/// with.
double rise(const TestRig& rig, float friction, double seconds = 3) {
  constexpr float kStep = 1 / 960.0f;
  LetGo hair(rig, kStep);
  hair.settings.dynamics.friction = friction;
  double least = hair.held, most_rise = 0;
  std::vector<Vec3> before = hair.test.ends();
  for (double t = 0; t < seconds; t += double(kStep)) {
    hair.step();
    const std::vector<Vec3> now = hair.test.ends();
    const double energy = hair.energy.halfway(before, now, double(kStep));
    most_rise = std::max(most_rise, energy - least);
    least = std::min(least, energy);
    before = now;
  }
  return most_rise / (hair.held - hair.rest);
}

TEST(PassiveEnergy, AllOfItNeverRises) {
  for (const int bones : {1, 3, 6, 16}) {
    for (const auto& [root, tip] : {std::pair{300.0, 10.0}, {10.0, 10.0}, {60.0, 600.0}}) {
      for (const double ratio : {0.25, 0.02}) {
        TestRig rig = make({bones, root, tip, ratio, 1});
        for (const float friction : {1.0f, 0.1f}) {
          EXPECT_LT(rise(rig, friction), 2e-4) << bones << ' ' << root << ' ' << tip << ' ' << ratio << ' ' << friction;
        }
        rig.add_sphere({0.1f, -0.3f, -0.15f}, 0.12f);
        for (const float friction : {1.0f, 0.1f}) {
          EXPECT_LT(rise(rig, friction), 2e-4)
              << "on a ball: " << bones << ' ' << root << ' ' << tip << ' ' << ratio << ' ' << friction;
        }
      }
    }
  }
}

TEST(PassiveEnergy, NorDoTipsThatWeighMoreOrLess) {
  for (const double ratio : {100.0, 0.01}) EXPECT_LT(worst_gain({6, 300, 10, 0, ratio}), 0.01) << ratio;
}

/// The fastest tail within half a second, m/s, after twelve in which the head was held so that `down` is down.
double rattle(const TestRig& rig, const Vec3& down, float dt) {
  TestHair test(rig, HairDesc{.solver = &kPassiveSolver});
  StepSettings settings;
  settings.dt = dt;
  settings.sleep_after = INFINITY;
  settings.environment.gravity = {9.81f * down.x, 9.81f * down.y, 9.81f * down.z};
  for (double t = 0; t < 12; t += double(dt)) EXPECT_EQ(test.hair.step(settings), Status::kOk);
  float fastest = 0;
  std::vector<Vec3> before = test.ends();
  for (double t = 0; t < 0.5; t += double(dt)) {
    EXPECT_EQ(test.hair.step(settings), Status::kOk);
    fastest = std::max(fastest, largest_distance(before, test.ends()) / dt);
    before = test.ends();
  }
  return double(fastest);
}

TEST(PassiveEnergy, HeldInAnyAttitudeHairHangsStill) {
  for (const int bones : {3, 7, 12}) {
    TestRig rig = make({bones, 20, 200, 0.45, 1});
    for (DynamicsRecord& bone : rig.dynamics) bone.friction = 2.2f;
    rig.add_sphere({0, 0, 0}, 0.1f);
    for (const Vec3 down :
         {Vec3{0, -1, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}, {0, 0, -1}, {0.6f, 0.8f, 0}, {0, 0.8f, 0.6f}}) {
      for (const float rate : {30.0f, 60.0f, 120.0f}) {
        EXPECT_LT(rattle(rig, down, 1 / rate), 0.1)
            << bones << " bones, " << down.x << ' ' << down.y << ' ' << down.z << " is down, " << rate << " a second";
      }
    }
  }
}

}  // namespace coif::lab::passive_energy_test
