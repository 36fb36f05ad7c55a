#include "report/constraint_meter.h"
#include "report/reference/reference_tree.h"
#include "report/reference_trial.h"
#include "report/solver_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <ostream>

namespace coif {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

const SolverScene kEarth;

ColliderRecord shaped(ColliderShape shape, const Vector3d& center, const Vector3d& radii, const Vector3d& axis) {
  ColliderRecord record = sphere(center, 0);
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
  ColliderRecord record = sphere({0, -0.1, 0}, 0.16);
  record.flags = kColliderKeepsInside;
  return record;
}

/// A back of the head, or what else hair lies against.
const NamedCollider kBesideTheHair[] = {
    {"sphere", sphere({0, -0.12, -0.05}, 0.08)},
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
  Rig rig = strand_rig(6);
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
void follow(const Rig& rig, const HeadPath& path, double seconds, double dt,
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
  follow(rig, *path_of(Motion::kNod), 2, 1.0 / 1440, [&](std::span<const Vector3d> ends) {
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
  const auto path = path_of(Motion::kNod);
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
  follow(rig, *path_of(Motion::kStill), 1, 1.0 / 2880, [&](auto ends) { second.push_back(ends[1]); });
  follow(alone, *path_of(Motion::kStill), 1, 1.0 / 2880, [&](auto ends) { pendulum.push_back(ends[0]); });
  EXPECT_LT(worst_distance(second, pendulum), 1e-4 * 0.04);
  EXPECT_LT(pendulum[330].y(), -0.039);
}

TEST(ReferenceContact, AngleLimitIsReachedAndHolds) {
  Rig rig = soft_strand();
  for (RigBone& bone : rig.bones) {
    bone.angle_limit = 0.2;
    bone.stiffness = 30;
  }
  double widest = 0;
  follow(rig, *path_of(Motion::kRun), 2, 1.0 / 1440, [&](std::span<const Vector3d> ends) {
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
  const ReferenceRun run = solve_at(rig, kEarth, *path_of(Motion::kTumble), 1, 720);
  for (const Vector3d& place : run.places) EXPECT_LT((place - run.places.front()).norm(), 1e-6);
}

}  // namespace
}  // namespace coif
