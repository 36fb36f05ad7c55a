// How deep hair lies in colliders that move, as the lab tells.

#include "lab/placed_solid.h"
#include "research/solver_trial.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace coif::lab::placed_solid_test {

using Eigen::Vector3d;

/// One of each shape, turned and off the origin.
std::vector<MovingCollider> shapes() {
  std::vector<MovingCollider> all(6);
  constexpr ColliderShape kShapes[] = {ColliderShape::kSphere,         ColliderShape::kCapsule,
                                       ColliderShape::kTaperedCapsule, ColliderShape::kBox,
                                       ColliderShape::kEllipsoid,      ColliderShape::kPlane};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i].shape = kShapes[i];
    all[i].center[0] = 0.02, all[i].center[1] = -0.01;
    all[i].rotation = turned_about({0.6f, 0, 0.8f}, 0.9);
    all[i].axis = {0.05f, 0.1f, 0};
    all[i].radius = 0.05f;
    all[i].end_radius = 0.02f;
    all[i].half_extents = {0.03f, 0.05f, 0.02f};
  }
  all[3].radius = 0.01f;
  return all;
}

TEST(PlacedSolid, IsAsDeepAsTheDeepestOfManyPoints) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] { return Vector3d(uniform(random), uniform(random), uniform(random)); };
  for (const MovingCollider& collider : shapes()) {
    const PlacedSolid solid(collider, {});
    int met = 0;
    for (int i = 0; i < 300; ++i) {
      const HairSegment segment{0.15 * vector(), vector().normalized(), 0.15, 0.004};
      if (collider.shape == ColliderShape::kPlane || solid.gap(segment.start) < segment.radius) continue;
      double least = 1;
      for (int k = 0; k <= 2000; ++k) {
        least = std::min(least, solid.gap(segment.start + segment.direction * (segment.length * k / 2000)));
      }
      // Between two points it may be deeper by half of what lies between them, and no more.
      const double depth = avoidable_depth(solid, segment), looked = std::max(0.0, segment.radius - least);
      EXPECT_GE(depth, looked - 1e-6) << int(collider.shape);
      EXPECT_LE(depth, looked + 0.5 * segment.length / 2000 + 1e-6) << int(collider.shape);
      met += least < segment.radius;
    }
    if (collider.shape != ColliderShape::kPlane) EXPECT_GT(met, 2) << int(collider.shape);
  }
}

TEST(PlacedSolid, HasASurfaceWhereItsShapeSays) {
  const auto all = shapes();
  const auto gap_at = [](const MovingCollider& collider, const Vec3& own) {
    const Vec3 turned = rotated(collider.rotation, own);
    return PlacedSolid(collider, {}).gap({collider.center[0] + turned.x, collider.center[1] + turned.y, turned.z});
  };
  EXPECT_NEAR(gap_at(all[0], {0, 0.05f, 0}), 0, 1e-8);
  EXPECT_NEAR(gap_at(all[1], {0.05f, 0.1f, 0.05f}), 0, 1e-8);
  EXPECT_NEAR(gap_at(all[2], {0, 0, 0.05f}), 0, 1e-8);
  EXPECT_NEAR(gap_at(all[2], {0.05f, 0.1f, 0.02f}), -0.02 * (1 - std::sqrt(1 - 0.03 * 0.03 / 0.0125)), 1e-8)
      << "a cone is wider than its thin end's ball beside that";
  EXPECT_NEAR(gap_at(all[3], {0.03f, 0, 0.03f}), 0, 1e-8) << "a box's face is rounded outwards";
  EXPECT_NEAR(gap_at(all[3], {0, 0, 0}), -0.03, 1e-8) << "and the middle is as deep as its nearest face";
  EXPECT_NEAR(gap_at(all[4], {0.03f, 0, 0}), 0, 1e-8);
  EXPECT_NEAR(gap_at(all[5], {0.1f, -0.05f, 3}), 0, 1e-7);
}

TEST(PlacedSolid, IsSeenFromTheHeadInItsOwnMetres) {
  HeadPose head;
  head.position[0] = 100, head.position[2] = -3;
  head.rotation = turned_about({0, 1, 0}, 0.5);
  head.scale = 2;
  MovingCollider ball;
  const Vec3 beside = rotated(head.rotation, {0.4f, 0, 0});
  ball.center[0] = 100 + double(beside.x), ball.center[2] = -3 + double(beside.z);
  ball.radius = 0.1f;
  const PlacedSolid solid(ball, head);
  EXPECT_NEAR((solid.center - Vector3d(0.2, 0, 0)).norm(), 0, 1e-7);
  EXPECT_NEAR(solid.gap(Vector3d::Zero()), 0.15, 1e-7);
  EXPECT_NEAR(solid.size, 0.05, 1e-8);
}

TEST(PlacedSolid, CountsTheEndAloneOfWhatStartsInside) {
  MovingCollider ball;
  ball.radius = 0.1f;
  const PlacedSolid solid(ball, {});
  const Vector3d start(0.05, 0, 0);
  EXPECT_EQ(avoidable_depth(solid, {start, -Vector3d::UnitX(), 0.2, 0}), 0) << "out on the other side";
  EXPECT_NEAR(avoidable_depth(solid, {start, Vector3d::UnitX(), 0.02, 0}), 0, 1e-8) << "too short to come out";
  EXPECT_NEAR(avoidable_depth(solid, {start, -Vector3d::UnitX(), 0.02, 0}), 0.04, 1e-8)
      << "could be nearer the surface";
}

TEST(MovingMeter, KeepsTheWorstAndWhereItWas) {
  Rig rig = research::strand_rig(3);
  std::vector<Vector3d> ends;
  for (const RigBone& bone : rig.bones) {
    const Vector3d start = bone.parent < 0 ? bone.joint : ends[std::size_t(bone.parent)];
    ends.push_back(start + bone.length * bone.rest_direction);
  }
  MovingCollider ball;
  ball.radius = 0.05f;
  std::copy_n(ends[2].data(), 3, ball.center);
  ball.center[0] += 0.04;
  MovingMeter meter(rig);
  meter.look(ends, {});
  EXPECT_EQ(meter.worst(), 0);
  const PlacedSolid far(MovingCollider{.center = {5, 0, 0}, .radius = 0.05f}, {}), near(ball, {});
  const PlacedSolid both[] = {far, near};
  meter.look(ends, both);
  EXPECT_GT(meter.worst(), 0.15);
  EXPECT_EQ(meter.where().look, 1u);
  EXPECT_EQ(meter.where().collider, 1u);
  const double worst = meter.worst();
  meter.look(ends, {both, 1});
  EXPECT_EQ(meter.worst(), worst);
}

}  // namespace coif::lab::placed_solid_test
