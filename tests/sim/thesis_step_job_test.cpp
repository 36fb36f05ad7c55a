// Single steps of Algorithm 1 with numbers that can be followed by hand: dt is 0.1 s, bones are 1 m long and hang
// straight down, so that velocities are ten times the way moved.

#include "sim/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

constexpr float kNear = 1e-5f;
const float kDiagonal = std::sqrt(0.5f);
constexpr double kQuarterTurn = 1.5707963267948966;

TestRig one_bone(float resistance = 0) {
  TestRig rig;
  rig.add({.resistance = resistance});
  return rig;
}

TestRig two_bones() {
  TestRig rig;
  rig.add({});
  rig.add({.parent = 1});
  return rig;
}

void expect_particle(const Particle& particle, const Vec3& position, const Vec3& velocity) {
  EXPECT_LT(distance(particle.position, position), kNear)
      << particle.position.x << " " << particle.position.y << " " << particle.position.z;
  EXPECT_LT(distance(particle.velocity, velocity), 20 * kNear)
      << particle.velocity.x << " " << particle.velocity.y << " " << particle.velocity.z;
}

TEST(ThesisStep, GravityThenFrictionThenLength) {
  TestStep step(one_bone());
  step.particles[0].velocity = {2, 0, 0};
  step.friction_factors[0] = 0.5f;
  auto job = step.job();
  job.gravity = {0, -10, 0};
  ASSERT_EQ(job.run(), Status::kOk);
  // v = (2, -1, 0) after gravity, (1, -0.5, 0) after friction; x = (0.1, -1.05, 0), 1.054751 m from the joint,
  // scaled back to 1 m: (0.094809, -0.995495, 0). The way from (0, -1, 0), times ten, is the velocity.
  expect_particle(step.particles[0], {0.094809f, -0.995495f, 0}, {0.94809f, 0.04505f, 0});
}

TEST(ThesisStep, GravityScaleIsTheShareOfGravityThatABoneFeels) {
  TestStep step(one_bone());
  step.rig.dynamics[1].gravity_scale = 0.5f;
  auto job = step.job();
  job.gravity = {10, 0, 0};  // sideways: v = 0.5, x = (0.05, -1, 0), 1.001249 m
  ASSERT_EQ(job.run(), Status::kOk);
  expect_particle(step.particles[0], {0.049938f, -0.998752f, 0}, {0.49938f, 0.01248f, 0});
}

TEST(ThesisStep, FrictionBrakesTowardsTheAir) {
  TestStep step(one_bone());
  step.friction_factors[0] = 0.5f;
  auto job = step.job();
  job.air_velocity = {0, 0, 4};
  ASSERT_EQ(job.run(), Status::kOk);
  // v = 4 + (0 - 4) / 2 = 2 along z; x = (0, -1, 0.2), 1.019804 m.
  expect_particle(step.particles[0], {0, -0.980581f, 0.196116f}, {0, 0.19419f, 1.96116f});
}

TEST(ThesisStep, FrictionFactorIsTheExponentialAndNeverNegative) {
  DynamicsRecord dynamics[4] = {};
  dynamics[1].friction = 10 * std::log(2.0f);
  dynamics[2].friction = 1000;
  float factors[3] = {-1, -1, -1};
  compute_friction_factors(dynamics, 0.1f, factors);
  EXPECT_NEAR(factors[0], 0.5f, 1e-6f);
  EXPECT_GE(factors[1], 0.0f);
  EXPECT_LT(factors[1], 1e-30f);
  EXPECT_EQ(factors[2], 1.0f);
}

TEST(ThesisStep, WithoutResistanceAParticleStaysWhereItsLengthAllows) {
  TestStep step(one_bone(0));
  step.particles[0].position = {1, 0, 0};
  ASSERT_EQ(step.job().run(), Status::kOk);
  expect_particle(step.particles[0], {1, 0, 0}, {0, 0, 0});
}

TEST(ThesisStep, HalfResistanceGoesHalfTheWayToTheDefaultPosition) {
  TestStep step(one_bone(0.5f));
  step.particles[0].position = {1, 0, 0};
  ASSERT_EQ(step.job().run(), Status::kOk);
  // Half the way from (1, 0, 0) to (0, -1, 0) is (0.5, -0.5, 0); then the length makes it a unit vector.
  expect_particle(step.particles[0], {kDiagonal, -kDiagonal, 0}, {10 * (kDiagonal - 1), -10 * kDiagonal, 0});
}

TEST(ThesisStep, FullResistanceGoesAllTheWay) {
  TestStep step(one_bone(1));
  step.particles[0].position = {1, 0, 0};
  ASSERT_EQ(step.job().run(), Status::kOk);
  expect_particle(step.particles[0], {0, -1, 0}, {-10, -10, 0});
}

TEST(ThesisStep, DefaultPositionTurnsWithTheParent) {
  TestRig rig = two_bones();
  rig.dynamics[2].resistance = 1;
  TestStep step(rig);
  step.particles[0].position = {1, 0, 0};  // the parent points sideways: its frame is a quarter turn about z
  ASSERT_EQ(step.job().run(), Status::kOk);
  EXPECT_LT(distance(step.particles[0].position, {1, 0, 0}), kNear);
  EXPECT_LT(distance(step.particles[1].position, {2, 0, 0}), kNear);
}

TEST(ThesisStep, DefaultPositionTurnsWithTheHead) {
  TestStep step(one_bone(1));
  auto job = step.job();
  job.head_rotation = turned_about({0, 0, 1}, kQuarterTurn);
  ASSERT_EQ(job.run(), Status::kOk);
  EXPECT_LT(distance(step.particles[0].position, {1, 0, 0}), kNear);
}

TEST(ThesisStep, ParticleAndParentEachTakeHalfOfTheLengthError) {
  TestStep step(two_bones());
  step.particles[1].position = {0, -2.4f, 0};  // 0.4 m too far
  ASSERT_EQ(step.job().run(), Status::kOk);
  expect_particle(step.particles[0], {0, -1.2f, 0}, {0, -2, 0});
  expect_particle(step.particles[1], {0, -2.2f, 0}, {0, 2, 0});
}

TEST(ThesisStep, SecondIterationRepeatsLengthsFromWhereTheFirstLeftThem) {
  TestStep step(two_bones());
  step.particles[1].position = {0, -2.4f, 0};
  auto job = step.job();
  job.iterations = 2;
  ASSERT_EQ(job.run(), Status::kOk);
  // First pass as above: -1.2 and -2.2. Second: the parent returns to -1, the child is 0.2 m too far, half each.
  expect_particle(step.particles[0], {0, -1.1f, 0}, {0, -1, 0});
  expect_particle(step.particles[1], {0, -2.1f, 0}, {0, 3, 0});
}

TEST(ThesisStep, IterationsDoNotRepeatThePullToTheDefaultPosition) {
  TestStep once(one_bone(0.5f)), often(one_bone(0.5f));
  once.particles[0].position = often.particles[0].position = {1, 0, 0};
  ASSERT_EQ(once.job().run(), Status::kOk);
  auto job = often.job();
  job.iterations = kMaxIterations;
  ASSERT_EQ(job.run(), Status::kOk);
  EXPECT_LT(distance(once.particles[0].position, often.particles[0].position), kNear);
}

TEST(ThesisStep, BranchesShareTheirParent) {
  TestRig rig;
  rig.add({});
  rig.add({.parent = 1, .rest_direction = {1, 0, 0}});
  rig.add({.parent = 1, .rest_direction = {-1, 0, 0}});
  TestStep step(rig);
  step.particles[1].position = {1.4f, -1, 0};
  ASSERT_EQ(step.job().run(), Status::kOk);
  // The right bone is 0.4 m too long: it and the fork move 0.2 m towards each other. That makes the left bone
  // 0.2 m too long: it and the fork move 0.1 m towards each other.
  EXPECT_LT(distance(step.particles[0].position, {0.1f, -1, 0}), kNear);
  EXPECT_LT(distance(step.particles[1].position, {1.2f, -1, 0}), kNear);
  EXPECT_LT(distance(step.particles[2].position, {-0.9f, -1, 0}), kNear);
}

TEST(ThesisStep, HeadMovesAwayFromAParticleThatStaysInTheWorld) {
  TestStep step(one_bone());
  auto job = step.job();
  job.head_displacement = {1, 0, 0};
  ASSERT_EQ(job.run(), Status::kOk);
  // Seen from the head the particle is now at (-1, -1, 0); its length brings it to the unit diagonal. In the world
  // it moved by (1 - d, 1 - d, 0).
  expect_particle(step.particles[0], {-kDiagonal, -kDiagonal, 0}, {10 * (1 - kDiagonal), 10 * (1 - kDiagonal), 0});
}

TEST(ThesisStep, ParticleInASphereLeavesAlongTheRadius) {
  TestRig rig;
  rig.add({.joint = {0.3f, 1.4f, 0}});
  rig.add_sphere({0, 0, 0}, 1);
  TestStep step(rig);  // rests at (0.3, 0.4, 0), half a radius from the centre
  ASSERT_EQ(step.job().run(), Status::kOk);
  expect_particle(step.particles[0], {0.6f, 0.8f, 0}, {3, 4, 0});
}

TEST(ThesisStep, ParticleOutsideASphereIsLeftAlone) {
  TestRig rig;
  rig.add({.joint = {0, 2.5f, 0}});
  rig.add_sphere({0, 0, 0}, 1);
  TestStep step(rig);
  ASSERT_EQ(step.job().run(), Status::kOk);
  expect_particle(step.particles[0], {0, 1.5f, 0}, {0, 0, 0});
}

TEST(ThesisStep, ParticleInAnEllipsoidLeavesAlongTheRadiusOfItsUnitSphere) {
  TestRig rig;
  rig.add({.joint = {0.6f, 1.4f, 0}});
  rig.add_ellipsoid({0, 0, 0}, {2, 1, 1});
  TestStep step(rig);  // (0.6, 0.4, 0) is (0.3, 0.4, 0) in the unit sphere: half way out
  ASSERT_EQ(step.job().run(), Status::kOk);
  expect_particle(step.particles[0], {1.2f, 0.8f, 0}, {6, 4, 0});
}

TEST(ThesisStep, EllipsoidTurnsWithItsOwnRotation) {
  TestRig rig;
  rig.add({.joint = {-0.4f, 1.6f, 0}});
  rig.add_ellipsoid({0, 0, 0}, {2, 1, 1}, turned_about({0, 0, 1}, kQuarterTurn));  // long along y now
  TestStep step(rig);
  ASSERT_EQ(step.job().run(), Status::kOk);
  expect_particle(step.particles[0], {-0.8f, 1.2f, 0}, {-4, 6, 0});
}

TEST(ThesisStep, CollidersMoveWithTheHead) {
  TestRig rig;
  rig.add({});
  rig.add_sphere({1, 0, 0}, 0.5f);
  TestStep step(rig);
  auto job = step.job();
  job.head_rotation = turned_about({0, 0, 1}, -kQuarterTurn);  // carries the sphere to (0, -1, 0)
  step.particles[0].position = {0, -1, 0.1f};                  // length puts it at (0, -0.995037, 0.099504)
  ASSERT_EQ(job.run(), Status::kOk);
  EXPECT_NEAR(distance(step.particles[0].position, {0, -1, 0}), 0.5f, kNear);
  EXPECT_GT(step.particles[0].position.z, 0.49f);
}

TEST(ThesisStep, ParticleAtTheCentreLeavesAlongTheCollidersOwnUp) {
  TestRig sphere, ellipsoid;
  sphere.add({.joint = {0, 1, 0}});
  sphere.add_sphere({0, 0, 0}, 0.5f);
  ellipsoid.add({.joint = {0, 1, 0}});
  ellipsoid.add_ellipsoid({0, 0, 0}, {3, 2, 1}, turned_about({0, 0, 1}, kQuarterTurn));
  TestStep in_sphere(sphere), in_ellipsoid(ellipsoid);
  ASSERT_EQ(in_sphere.job().run(), Status::kOk);
  ASSERT_EQ(in_ellipsoid.job().run(), Status::kOk);
  expect_particle(in_sphere.particles[0], {0, 0.5f, 0}, {0, 5, 0});
  expect_particle(in_ellipsoid.particles[0], {-2, 0, 0}, {-20, 0, 0});
}

TEST(ThesisStep, ParticleOnItsOwnStartLeavesInItsDefaultDirection) {
  TestStep first(one_bone()), second(two_bones());
  first.particles[0].position = {0, 0, 0};
  second.particles[1].position = {0, -1, 0};  // on its parent's particle: 1 m too short, half for each
  ASSERT_EQ(first.job().run(), Status::kOk);
  ASSERT_EQ(second.job().run(), Status::kOk);
  expect_particle(first.particles[0], {0, -1, 0}, {0, -10, 0});
  expect_particle(second.particles[0], {0, -0.5f, 0}, {0, 5, 0});
  expect_particle(second.particles[1], {0, -1.5f, 0}, {0, -5, 0});
}

TEST(ThesisStep, BoneFoldedBackOntoItselfStaysFinite) {
  TestRig rig = two_bones();
  rig.dynamics[2].resistance = 1;
  TestStep step(rig);
  step.particles[0].position = {0, 1, 0};  // straight up, where the shortest arc has no axis
  ASSERT_EQ(step.job().run(), Status::kOk);
  EXPECT_LT(distance(step.particles[1].position, {0, 2, 0}), kNear);
}

TEST(ThesisStep, BoneFoldedBackTurnsWithTheHead) {
  TestRig rig = two_bones();
  rig.bones[2].rest_direction[0] = 0.6f;
  rig.bones[2].rest_direction[1] = -0.8f;
  rig.dynamics[2].resistance = 1;
  TestStep upright(rig), turned(rig);
  upright.particles[0].position = {0, 1, 0};
  turned.particles[0].position = {0, 0, 1};  // the same, under a head that lies on its face
  auto job = turned.job();
  job.head_rotation = turned_about({1, 0, 0}, kQuarterTurn);
  ASSERT_EQ(upright.job().run(), Status::kOk);
  ASSERT_EQ(job.run(), Status::kOk);
  const Vec3 end = upright.particles[1].position;
  EXPECT_LT(distance(turned.particles[1].position, {end.x, -end.z, end.y}), kNear);
}

TEST(ThesisStep, AllFiniteFindsEveryBadComponent) {
  TestStep step(two_bones());
  EXPECT_TRUE(all_finite(step.particles));
  for (float* const component : {&step.particles[1].position.y, &step.particles[0].velocity.z}) {
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
      const float good = *component;
      *component = bad;
      EXPECT_FALSE(all_finite(step.particles));
      *component = good;
    }
  }
}

}  // namespace
}  // namespace coif
