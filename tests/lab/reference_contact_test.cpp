#include "lab/hair_segment.h"
#include "lab/measure_runtime.h"
#include "lab/reference_model.h"
#include "lab/reference_trial.h"
#include "models/test_rig.h"
#include "report/accuracy/measure_accuracy.h"
#include "report/stability/measure_stability.h"
#include "research/solver_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <ostream>
#include <string>
#include <utility>

namespace coif::lab::reference_contact_test {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const SolverScene kEarth;

ColliderRecord shaped(ColliderShape shape, const Vector3d& center, const Vector3d& radii, const Vector3d& axis) {
  ColliderRecord record = research::sphere(center, 0);
  record.shape = shape;
  for (int k = 0; k < 3; ++k) {
    record.radii[k] = float(radii[k]);
    record.axis[k] = float(axis[k]);
  }
  return record;
}

ColliderRecord tilted_ellipsoid() {
  ColliderRecord record = shaped(ColliderShape::kEllipsoid, {0, -0.12, -0.05}, {0.07, 0.1, 0.08}, Vector3d::Zero());
  const Quaterniond tilt(Eigen::AngleAxisd(0.5, Vector3d(1, 1, 0).normalized()));
  for (int k = 0; k < 4; ++k) record.rotation[k] = float(tilt.coeffs()[k]);
  return record;
}

struct NamedCollider {
  const char* name;
  ColliderRecord collider;
};

void PrintTo(const NamedCollider& named, std::ostream* out) { *out << named.name; }

ColliderRecord cup() {
  ColliderRecord record = research::sphere({0, -0.1, 0}, 0.16);
  record.flags = kColliderKeepsInside;
  return record;
}

/// A back of the head, or what else hair lies against.
const NamedCollider kBesideTheHair[] = {
    {"sphere", research::sphere({0, -0.12, -0.05}, 0.08)},
    {"ellipsoid", tilted_ellipsoid()},
    {"capsule", shaped(ColliderShape::kCapsule, {-0.1, -0.12, -0.05}, Vector3d::Constant(0.07), {0.2, 0.02, 0})},
    {"tapered", shaped(ColliderShape::kTaperedCapsule, {-0.1, -0.12, -0.05}, {0.09, 0.06, 0}, {0.2, 0.02, 0})},
    {"plane", shaped(ColliderShape::kPlane, {0, -0.2, -0.16}, Vector3d::Zero(), {0, 0.6, -0.8})},
    {"cup", cup()},
};

class Resting : public testing::TestWithParam<NamedCollider> {};

/// A strand that starts behind the colliders above, damped well, and sags against them. On top of them it would buckle,
/// and no two runs would agree to which side.
Rig soft_strand() {
  Rig rig = research::strand_rig(6);
  for (RigBone& bone : rig.bones) {
    bone.joint = Vector3d(0, 0, -0.1);
    bone.length = 0.04;
    bone.rest_direction = Vector3d(0.1, -1, -0.3).normalized();
    bone.stiffness = 300;
    bone.damping = 45;
    bone.hit_radius = 0.004;
  }
  return with_tips(rig);
}

/// Calls `look` with all bone ends after each step.
void follow(const Rig& rig, const motion::HeadPath& path, double seconds, double dt,
            const std::function<void(std::span<const Vector3d>)>& look) {
  ReferenceTree tree(rig, trees_of(rig).front(), kEarth);
  std::vector<Vector3d> ends(rig.bones.size());
  tree.reset(path.at(0));
  for (long i = 0; i < std::lround(seconds / dt); ++i) {
    const double t = double(i) * dt;
    tree.step({dt, path.at(t), path.at(t + dt / 2), path.at(t + dt)});
    tree.bone_ends(path.at(t + dt).rotation, ends);
    look(ends);
  }
}

TEST_P(Resting, HairTouchesAndNeverEnters) {
  const Rig rig = touching(soft_strand(), GetParam().collider);
  const std::vector<SolidShape> solids = solid_shapes(rig.colliders);
  ConstraintMeter meter(rig);
  double nearest = 1;
  follow(rig, *motion::path_of(motion::Motion::kNod), 2, 1.0 / 1440, [&](std::span<const Vector3d> ends) {
    meter.look(ends);
    Vector3d start = rig.bones[0].joint;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      const RigBone& bone = rig.bones[i];
      const HairSegment segment{start, (ends[i] - start).normalized(), bone.length, bone.hit_radius};
      nearest = std::min(nearest, nearest_contact(solids[0], segment).gap);
      start = ends[i];
    }
  });
  EXPECT_LT(nearest, 1e-6) << "nothing was touched";
  EXPECT_LT(meter.worst().segment_depth, 1e-6);
  EXPECT_LT(meter.worst().stretch, 1e-12);
}

TEST_P(Resting, ConvergesThroughContact) {
  const Rig rig = touching(soft_strand(), GetParam().collider);
  const auto path = motion::path_of(motion::Motion::kNod);
  const ReferenceRun coarse = solve_at(rig, kEarth, *path, 2, 720), fine = solve_at(rig, kEarth, *path, 2, 5760);
  EXPECT_LT(fine.self_difference_pct(), 0.05);
  // Eight times shorter steps; first order cuts the error by eight, but for the moments at which contacts begin.
  EXPECT_LT(fine.self_difference_pct(), coarse.self_difference_pct() / 3);
}

INSTANTIATE_TEST_SUITE_P(Colliders, Resting, testing::ValuesIn(kBesideTheHair),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(ReferenceContact, ChildOfAHeldBoneFallsOnAsIfItsParentHadStopped) {
  // Two bones fall; the ground stops the first when it is level with its end. The second is a pendulum from then on: it
  // must not go on with the acceleration that its parent no longer has.
  Rig rig = soft_strand();
  rig.bones.resize(2);
  for (RigBone& bone : rig.bones) bone.stiffness = bone.damping = bone.friction = bone.hit_radius = 0;
  for (RigBone& bone : rig.bones) {
    bone.joint.setZero();
    bone.rest_direction = -Vector3d::UnitZ();
  }
  rig.colliders.push_back(shaped(ColliderShape::kPlane, Vector3d::Zero(), Vector3d::Zero(), Vector3d::UnitY()));
  rig.bones[0].colliders = 1;
  Rig alone = rig;
  alone.bones = {rig.bones[1]};
  alone.bones[0].parent = -1;
  alone.bones[0].joint = Vector3d(0, 0, -0.04);
  std::vector<Vector3d> second, pendulum;
  follow(rig, *motion::path_of(motion::Motion::kStill), 1, 1.0 / 2880, [&](auto ends) { second.push_back(ends[1]); });
  follow(alone, *motion::path_of(motion::Motion::kStill), 1, 1.0 / 2880,
         [&](auto ends) { pendulum.push_back(ends[0]); });
  EXPECT_LT(research::worst_distance(second, pendulum), 1e-4 * 0.04);
  EXPECT_LT(pendulum[330].y(), -0.039);
}

TEST(ReferenceContact, AngleLimitIsReachedAndHolds) {
  Rig rig = soft_strand();
  for (RigBone& bone : rig.bones) {
    bone.angle_limit = 0.2;
    bone.stiffness = 30;
  }
  double widest = 0;
  follow(rig, *motion::path_of(motion::Motion::kRun), 2, 1.0 / 1440, [&](std::span<const Vector3d> ends) {
    // The first bone's default direction turns with the head alone.
    const Vector3d way = (ends[0] - rig.bones[0].joint).normalized();
    const double angle = std::acos(std::min(1.0, way.dot(rig.bones[0].rest_direction)));
    widest = std::max(widest, angle);
  });
  EXPECT_NEAR(widest, 0.2, 1e-6);
}

TEST(ReferenceContact, LimitOfNothingMakesHairRigid) {
  Rig rig = soft_strand();
  for (RigBone& bone : rig.bones) bone.angle_limit = 0;
  const ReferenceRun run = solve_at(rig, kEarth, *motion::path_of(motion::Motion::kTumble), 1, 720);
  for (const Vector3d& place : run.places) EXPECT_LT((place - run.places.front()).norm(), 1e-6);
}

// Bones that never twist: the reference of a torsion of kShortestArc, and the runtime beside it.

using Eigen::AngleAxisd;

Rig with_torsion(Rig rig, double torsion) {
  for (RigBone& bone : rig.bones) bone.torsion = torsion;
  return rig;
}

/// A strand that winds forwards, with another that forks off sideways: a twist of a bone moves all that hang from it.
Rig curl() {
  Rig rig = research::forked_rig();
  for (std::size_t i = 0; i < rig.bones.size(); ++i) {
    rig.bones[i].rest_direction =
        (Quaterniond(AngleAxisd(0.7 * double(i), Vector3d(0, 1, 0.4).normalized())) * rig.bones[i].rest_direction)
            .normalized();
  }
  return with_tips(rig);
}

double difference_pct(const Rig& rig, const ReferenceRun& a, const ReferenceRun& b) {
  return 100 * worst_apart(a, b) / *std::ranges::max_element(rig.tip_length);
}

TEST(ReferenceTwist, SpinOfTheArcIsTheDerivativeOfItsFrame) {
  RigBone bone;
  bone.rest_direction = Vector3d(0.2, -0.9, 0.4).normalized();
  bone.torsion = double(kShortestArc);
  const Vector3d parent_spin(1.2, -2.1, 0.7);
  for (const double bend : {0.0, 0.4, 1.5, 2.8}) {
    const Vector3d swing = Vector3d(-0.5, 0.3, 1.7);
    const auto turned_by = [](const Vector3d& spin, double t) {
      return Quaterniond(AngleAxisd(spin.norm() * t, spin.normalized()));
    };
    const auto state_at = [&](double t) {
      BoneMotion parent = motion_of_joint(Vector3d::Zero(), {});
      parent.frame = turned_by(parent_spin, t) * Quaterniond(AngleAxisd(0.8, Vector3d::UnitZ()));
      parent.angular_velocity = parent_spin;
      const Vector3d start =
          Quaterniond(AngleAxisd(0.8, Vector3d::UnitZ())) *
          (Quaterniond(AngleAxisd(bend, bone.rest_direction.unitOrthogonal())) * bone.rest_direction);
      const Vector3d direction = turned_by(swing, t) * start;
      return std::pair(parent, BoneState{frame_of_arc(bone, parent.frame, direction), swing.cross(direction)});
    };
    const double small = 1e-5;
    const Quaterniond change = state_at(small).second.frame * state_at(-small).second.frame.conjugate();
    const Vector3d expected = change.vec() * (change.w() < 0 ? -2 : 2) / (2 * small);
    const auto [parent, state] = state_at(0);
    EXPECT_LT((angular_velocity_of(bone, parent, state) - expected).norm(), 1e-5 * (1 + expected.norm())) << bend;
  }
}

TEST(ReferenceTwist, NoTwistIsWhatAFastTorsionTendsTo) {
  const Rig rig = curl(), arcs = with_torsion(rig, double(kShortestArc));
  for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kRun, motion::Motion::kTumble}) {
    const auto path = motion::path_of(motion);
    const auto solve = [&](const Rig& r) { return solve_at(r, kEarth, *path, 2, 5760); };
    const ReferenceRun without = solve(arcs);
    EXPECT_LT(difference_pct(rig, without, solve(with_torsion(rig, 1.0e4))), 0.1) << "motion " << int(motion);
    EXPECT_GT(difference_pct(rig, without, solve(with_torsion(rig, 1))), 0.5) << "or a twist moves nothing";
  }
}

TEST(ReferenceTwist, HalvingTheStepCutsTheErrorByMoreThanEight) {
  const Rig rig = with_torsion(curl(), double(kShortestArc));
  for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kRun, motion::Motion::kTumble}) {
    const auto path = motion::path_of(motion);
    const double coarse = solve_at(rig, kEarth, *path, 2, 480).self_difference_pct();
    const double fine = solve_at(rig, kEarth, *path, 2, 960).self_difference_pct();
    EXPECT_GT(coarse, 1e-10);
    EXPECT_LT(fine, coarse / 8) << "motion " << int(motion);
  }
}

TEST(ReferenceTwist, ContactsAndLimitsLeaveNoTwistBehind) {
  Rig rig = touching(curl(), research::sphere(Vector3d(0, -0.1, 0.02), 0.08));
  for (RigBone& bone : rig.bones) bone.angle_limit = 0.6;
  const auto path = motion::path_of(motion::Motion::kTurn);
  const auto solve = [&](double torsion) { return solve_at(with_torsion(rig, torsion), kEarth, *path, 2, 5760); };
  const ReferenceRun without = solve(double(kShortestArc));
  EXPECT_LT(without.self_difference_pct(), 0.01);
  const double slow = difference_pct(rig, without, solve(1));
  EXPECT_GT(slow, 0.5) << "or a twist moves nothing";
  EXPECT_LT(difference_pct(rig, without, solve(1.0e4)), 0.1 * slow);
}

TEST(ReferenceTwist, NeedsNoShorterStepsForWhatIsAlwaysThere) {
  const auto rate_of = [](double torsion) {
    const ReferenceSettings settings{.sample_times = evenly(30, 1)};
    return solve_reference(with_torsion(curl(), torsion), kEarth, *motion::path_of(motion::Motion::kNod), settings)
        .steps_per_second();
  };
  EXPECT_EQ(rate_of(double(kShortestArc)), rate_of(20));
  EXPECT_GT(rate_of(1.0e4), rate_of(20));
}

/// The default solver's RMS errors by motion and frame rate, in % of the chain's length, on a tree that branches.
std::map<std::pair<std::string, double>, double> runtime_errors(double torsion) {
  const report::StressAsset tree(report::StressRig{
      .chains = 1, .bones_per_chain = 7, .branching = 2, .torsion = torsion, .head_radius = 0.001, .root_offset = 0.1});
  report::AccuracySettings settings;
  settings.motions = {motion::Motion::kTurn, motion::Motion::kRun, motion::Motion::kTumble};
  settings.fps = {60, 120, 240};
  settings.substeps = {1};
  settings.seconds = 2;
  settings.solvers = {"coif"};
  const auto report = report::measure_accuracy(tree.asset(), settings, {});
  EXPECT_TRUE(report) << (report ? "" : report.error().message);
  std::map<std::pair<std::string, double>, double> errors;
  if (!report) return errors;
  for (const report::ReferenceRow& row : report->reference) EXPECT_LT(row.self_difference_pct, 0.05) << row.motion;
  for (const report::AccuracyRow& row : report->rows) errors[{row.motion, row.fps}] = row.rms_error_pct;
  return errors;
}

TEST(RuntimeTwist, WithoutItTheRuntimeIsAsNearToTheReference) {
  const auto with = runtime_errors(20), without = runtime_errors(double(kShortestArc));
  ASSERT_EQ(with.size(), 9u);
  for (const auto& [setting, error] : without) {
    EXPECT_GT(error, 0);
    EXPECT_LT(error, 1.2 * with.at(setting) + 0.01) << setting.first << " at " << setting.second;
  }
}

/// A strand that winds around, so that its bones twist as they swing.
TestRig winding_strand(float torsion) {
  TestRig rig;
  for (std::uint32_t i = 0; i < 4; ++i) {
    const Quat turn = turned_about({0, 1, 0}, 0.9 * i);
    const Vec3 aside = rotated(turn, {0.6f, -0.8f, 0});
    rig.add({.parent = i,
             .joint = {0, 0, -0.1f},
             .rest_direction = i == 0 ? Vec3{0, -1, 0} : aside,
             .length = 0.1f,
             .friction = 30,
             .stiffness = 700,
             .damping = 12,
             .torsion = torsion});
  }
  return rig;
}

TEST(RuntimeTwist, HalvingTheStepDividesTheErrorByThree) {
  for (const float torsion : {5.0f, 20.0f, 80.0f}) {
    const OpenedAsset opened(winding_strand(torsion).contents());
    const Rig rig = rig_of(opened.asset());
    for (const motion::Motion motion : {motion::Motion::kTurn, motion::Motion::kRun, motion::Motion::kTumble}) {
      const KnownMotion known{motion, solve_at(rig, kEarth, *motion::path_of(motion), 2, 5760)};
      EXPECT_LT(known.reference.self_difference_pct(), 0.001);
      double coarser = 0;
      for (const std::uint32_t substeps : {1u, 2u, 4u, 8u}) {
        const double error = 100 * measure_runtime(opened.asset(), rig, known, 60, substeps).rms;
        if (substeps > 1) {
          EXPECT_LT(3 * error, coarser) << "motion " << int(motion) << ", " << substeps << " steps, torsion "
                                        << torsion;
        }
        coarser = error;
      }
      EXPECT_LT(coarser, 0.05);
    }
  }
}

}  // namespace coif::lab::reference_contact_test
