#include "report/solvers/point_collisions.h"

#include "report/solver_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

void set(float (&to)[3], const Vector3d& value) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = float(value[axis]);
}

/// A bone that keeps 1 cm from one collider.
Rig rig_with(const ColliderRecord& collider) {
  Rig rig = pendulum_rig();
  rig.bones[0].hit_radius = 0.01;
  rig.bones[0].colliders = 1;
  rig.colliders = {collider};
  return rig;
}

const Vector3d kFrom(0.02, 0.05, -0.01), kAxis(0.06, -0.09, 0.03);
constexpr double kThick = 0.08, kThin = 0.05;

ColliderRecord capsule(ColliderShape shape) {
  ColliderRecord record = sphere(kFrom, kThick);
  record.shape = shape;
  set(record.axis, kAxis);
  if (shape == ColliderShape::kTaperedCapsule) set(record.radii, {kThick, kThin, 0});
  return record;
}

/// To the surface of the union of balls along the capsule's segment, by trying many of them.
double distance_to_capsule(const Vector3d& point, double last_radius) {
  double nearest = 1e9;
  for (int i = 0; i <= 4000; ++i) {
    const double share = i / 4000.0;
    const double radius = kThick + (last_radius - kThick) * share;
    nearest = std::min(nearest, (point - kFrom - kAxis * share).norm() - radius);
  }
  return nearest;
}

/// A grid of points that fills half a metre around the origin and hits no centre.
template <typename Visit>
void for_points(Visit visit) {
  for (int i = 0; i < 1000; ++i) {
    visit(Vector3d(i % 10 - 4.6, i / 10 % 10 - 4.4, i / 100 - 4.55) * 0.05);
  }
}

const Quaterniond kTurned(Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()));

/// Points inside end `hit_radius` from the surface, points outside stay; whatever the head's rotation.
template <typename Distance>
void expect_clear(const Rig& rig, double tolerance, Distance distance) {
  int moved = 0, stayed = 0;
  for_points([&](const Vector3d& point) {
    const Vector3d cleared = kTurned.conjugate() * clear_of_colliders(rig, 0, kTurned, kTurned * point);
    if (distance(point) >= 0.01 + tolerance) {
      EXPECT_LT((cleared - point).norm(), 1e-12);
      ++stayed;
    } else {
      EXPECT_NEAR(distance(cleared), 0.01, tolerance);
      ++moved;
    }
  });
  EXPECT_GT(moved, 10);
  EXPECT_GT(stayed, 10);
}

TEST(PointCollisions, ClearASphere) {
  expect_clear(rig_with(sphere(kFrom, 0.12)), 1e-6, [](const Vector3d& p) { return (p - kFrom).norm() - 0.12; });
}

TEST(PointCollisions, KeepInsideOfASphereThatHoldsHair) {
  ColliderRecord record = sphere(kFrom, 0.12);
  record.flags = kColliderKeepsInside;
  expect_clear(rig_with(record), 1e-6, [](const Vector3d& p) { return 0.12 - (p - kFrom).norm(); });
}

TEST(PointCollisions, ClearACapsule) {
  expect_clear(rig_with(capsule(ColliderShape::kCapsule)), 1e-5,
               [](const Vector3d& p) { return distance_to_capsule(p, kThick); });
}

TEST(PointCollisions, ClearATaperedCapsule) {
  expect_clear(rig_with(capsule(ColliderShape::kTaperedCapsule)), 1e-5,
               [](const Vector3d& p) { return distance_to_capsule(p, kThin); });
}

TEST(PointCollisions, ClearAPlane) {
  ColliderRecord record{};
  record.shape = ColliderShape::kPlane;
  const Vector3d normal = Vector3d(1, 3, 2).normalized();
  set(record.center, kFrom);
  set(record.axis, normal);
  expect_clear(rig_with(record), 1e-6, [&](const Vector3d& p) { return (p - kFrom).dot(normal); });
}

TEST(PointCollisions, ClearAnEllipsoid) {
  const Quaterniond turn(Eigen::AngleAxisd(0.5, Vector3d::UnitZ()));
  ColliderRecord record = sphere(kFrom, 0);
  record.shape = ColliderShape::kEllipsoid;
  set(record.radii, {0.08, 0.12, 0.1});
  for (int i = 0; i < 4; ++i) record.rotation[i] = float(turn.coeffs()[i]);
  const Vector3d grown = Vector3d(0.09, 0.13, 0.11);
  // 0.01 on the grown ellipsoid, below within, above outside.
  expect_clear(rig_with(record), 1e-6,
               [&](const Vector3d& p) { return (turn.conjugate() * (p - kFrom)).cwiseQuotient(grown).norm() - 0.99; });
}

TEST(PointCollisions, LeaveTheVeryCentreSomewhere) {
  for (const ColliderRecord& record : {sphere(kFrom, 0.1), capsule(ColliderShape::kCapsule)}) {
    const Vector3d center(double(record.center[0]), double(record.center[1]), double(record.center[2]));
    const Vector3d cleared = clear_of_colliders(rig_with(record), 0, kTurned, kTurned * center);
    ASSERT_TRUE(cleared.allFinite());
    EXPECT_NEAR((cleared - kTurned * center).norm(), double(record.radii[0]) + 0.01, 1e-6);
  }
}

TEST(PointCollisions, TouchOnlyWhatTheBoneMay) {
  Rig rig = rig_with(sphere({0, 0, 0}, 0.1));
  const Vector3d inside(0.01, 0.02, 0.03);
  for (const std::uint32_t colliders : {0u, 2u}) {  // None, and one that does not exist.
    rig.bones[0].colliders = colliders;
    EXPECT_EQ(clear_of_colliders(rig, 0, kTurned, inside), inside);
  }
}

TEST(PointCollisions, PushOutTakesTheSpeedIntoTheMovingHeadAndNoOther) {
  const Rig rig = rig_with(sphere({0, 0, 0}, 0.1));
  const Vector3d zero = Vector3d::Zero();
  ParticleStep step{1.0 / 60, Quaterniond::Identity(), Quaterniond::Identity(), zero, zero, Vector3d(0, 1, 0), zero};
  Vector3d position(0, 0.1, 0), velocity(3, 0.4, 0);  // Upwards, but the head comes after faster.
  ASSERT_TRUE(push_out(rig, 0, step, position, velocity));
  EXPECT_LT((position - Vector3d(0, 0.11, 0)).norm(), 1e-6);
  EXPECT_LT((velocity - Vector3d(3, 1, 0)).norm(), 1e-6);
  velocity = Vector3d(3, 2, 0);  // Leaves already.
  position.y() = 0.1;
  ASSERT_TRUE(push_out(rig, 0, step, position, velocity));
  EXPECT_EQ(velocity, Vector3d(3, 2, 0));
  EXPECT_FALSE(push_out(rig, 0, step, position = Vector3d(0, 0.2, 0), velocity));
}

TEST(PointCollisions, KeepTheLengthWhereTheyMust) {
  const Rig rig = rig_with(sphere({0, 0, 0}, 0.1));  // The bone is 0.1 m long.
  const Vector3d start(0, 0.12, 0), wanted = start + Vector3d(0.02, -0.1, 0);
  const Vector3d end = clear_of_colliders_at_length(rig, 0, kTurned, start, wanted);
  EXPECT_NEAR((end - start).norm(), 0.1, 1e-9);
  EXPECT_GT(end.norm(), 0.109);
}

}  // namespace
}  // namespace coif
