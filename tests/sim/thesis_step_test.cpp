// Single steps of Algorithm 1 with numbers that can be followed by hand: dt is 0.1 s, bones are 1 m long and hang
// straight down, so that velocities are ten times the way moved. Every step runs on every instruction set.

#include "sim/thesis_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::thesis_step_test {

constexpr float kNear = 1e-5f;
const float kDiagonal = std::sqrt(0.5f);
constexpr double kQuarterTurn = 1.5707963267948966;

TestRig one_bone(float resistance = 0) {
  TestRig rig;
  rig.add({.resistance = resistance});
  return rig;
}

/// Half of its velocity in a tenth of a second.
TestRig one_bone_that_keeps_half() {
  TestRig rig;
  rig.add({.friction = 10 * std::log(2.0f)});
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
  ThesisStep step(one_bone_that_keeps_half());
  step.particles[0].velocity = {2, 0, 0};
  step.gravity = {0, -10, 0};
  step.run();
  // v = (2, -1, 0) after gravity, (1, -0.5, 0) after friction; x = (0.1, -1.05, 0), 1.054751 m from the joint,
  // scaled back to 1 m: (0.094809, -0.995495, 0). The way from (0, -1, 0), times ten, is the velocity.
  expect_particle(step.particles[0], {0.094809f, -0.995495f, 0}, {0.94809f, 0.04505f, 0});
}

TEST(ThesisStep, GravityScaleIsTheShareOfGravityThatABoneFeels) {
  TestRig rig = one_bone();
  rig.dynamics[1].gravity_scale = 0.5f;
  ThesisStep step(rig);
  step.gravity = {10, 0, 0};  // sideways: v = 0.5, x = (0.05, -1, 0), 1.001249 m
  step.run();
  expect_particle(step.particles[0], {0.049938f, -0.998752f, 0}, {0.49938f, 0.01248f, 0});
}

TEST(ThesisStep, FrictionBrakesTowardsTheAir) {
  ThesisStep step(one_bone_that_keeps_half());
  step.air_velocity = {0, 0, 4};
  step.run();
  // v = 4 + (0 - 4) / 2 = 2 along z; x = (0, -1, 0.2), 1.019804 m.
  expect_particle(step.particles[0], {0, -0.980581f, 0.196116f}, {0, 0.19419f, 1.96116f});
}

TEST(ThesisStep, FrictionTakesAllOfTheVelocityAndNeverTurnsIt) {
  TestRig rig;
  rig.add({.friction = 1000});  // 1 - friction * dt would be -99
  ThesisStep step(rig);
  step.particles[0].velocity = {2, 0, 0};
  step.run();
  expect_particle(step.particles[0], {0, -1, 0}, {0, 0, 0});
}

TEST(ThesisStep, WithoutResistanceAParticleStaysWhereItsLengthAllows) {
  ThesisStep step(one_bone(0));
  step.particles[0].position = {1, 0, 0};
  step.run();
  expect_particle(step.particles[0], {1, 0, 0}, {0, 0, 0});
}

TEST(ThesisStep, HalfResistanceGoesHalfTheWayToTheDefaultPosition) {
  ThesisStep step(one_bone(0.5f));
  step.particles[0].position = {1, 0, 0};
  step.run();
  // Half the way from (1, 0, 0) to (0, -1, 0) is (0.5, -0.5, 0); then the length makes it a unit vector.
  expect_particle(step.particles[0], {kDiagonal, -kDiagonal, 0}, {10 * (kDiagonal - 1), -10 * kDiagonal, 0});
}

TEST(ThesisStep, FullResistanceGoesAllTheWay) {
  ThesisStep step(one_bone(1));
  step.particles[0].position = {1, 0, 0};
  step.run();
  expect_particle(step.particles[0], {0, -1, 0}, {-10, -10, 0});
}

TEST(ThesisStep, DefaultPositionTurnsWithTheParent) {
  TestRig rig = two_bones();
  rig.dynamics[2].resistance = 1;
  ThesisStep step(rig);
  step.particles[0].position = {1, 0, 0};  // the parent points sideways: its frame is a quarter turn about z
  step.run();
  EXPECT_LT(distance(step.particles[0].position, {1, 0, 0}), kNear);
  EXPECT_LT(distance(step.particles[1].position, {2, 0, 0}), kNear);
}

TEST(ThesisStep, DefaultPositionTurnsWithTheHead) {
  ThesisStep step(one_bone(1));
  step.head_rotation = turned_about({0, 0, 1}, kQuarterTurn);
  step.run();
  EXPECT_LT(distance(step.particles[0].position, {1, 0, 0}), kNear);
}

TEST(ThesisStep, ParticleAndParentEachTakeHalfOfTheLengthError) {
  ThesisStep step(two_bones());
  step.particles[1].position = {0, -2.4f, 0};  // 0.4 m too far
  step.run();
  expect_particle(step.particles[0], {0, -1.2f, 0}, {0, -2, 0});
  expect_particle(step.particles[1], {0, -2.2f, 0}, {0, 2, 0});
}

TEST(ThesisStep, SecondIterationRepeatsLengthsFromWhereTheFirstLeftThem) {
  ThesisStep step(two_bones());
  step.particles[1].position = {0, -2.4f, 0};
  step.iterations = 2;
  step.run();
  // First pass as above: -1.2 and -2.2. Second: the parent returns to -1, the child is 0.2 m too far, half each.
  expect_particle(step.particles[0], {0, -1.1f, 0}, {0, -1, 0});
  expect_particle(step.particles[1], {0, -2.1f, 0}, {0, 3, 0});
}

TEST(ThesisStep, IterationsDoNotRepeatThePullToTheDefaultPosition) {
  ThesisStep once(one_bone(0.5f)), often(one_bone(0.5f));
  once.particles[0].position = often.particles[0].position = {1, 0, 0};
  once.run();
  often.iterations = kMaxIterations;
  often.run();
  EXPECT_LT(distance(once.particles[0].position, often.particles[0].position), kNear);
}

TEST(ThesisStep, BranchesShareTheirParent) {
  TestRig rig;
  rig.add({});
  rig.add({.parent = 1, .rest_direction = {1, 0, 0}});
  rig.add({.parent = 1, .rest_direction = {-1, 0, 0}});
  ThesisStep step(rig);
  step.particles[1].position = {1.4f, -1, 0};
  step.run();
  // The right bone is 0.4 m too long: it and the fork move 0.2 m towards each other. That makes the left bone
  // 0.2 m too long: it and the fork move 0.1 m towards each other.
  EXPECT_LT(distance(step.particles[0].position, {0.1f, -1, 0}), kNear);
  EXPECT_LT(distance(step.particles[1].position, {1.2f, -1, 0}), kNear);
  EXPECT_LT(distance(step.particles[2].position, {-0.9f, -1, 0}), kNear);
}

TEST(ThesisStep, HeadMovesAwayFromAParticleThatStaysInTheWorld) {
  ThesisStep step(one_bone());
  step.head_displacement = {1, 0, 0};
  step.run();
  // Seen from the head the particle is now at (-1, -1, 0); its length brings it to the unit diagonal. In the world
  // it moved by (1 - d, 1 - d, 0).
  expect_particle(step.particles[0], {-kDiagonal, -kDiagonal, 0}, {10 * (1 - kDiagonal), 10 * (1 - kDiagonal), 0});
}

TEST(ThesisStep, ParticleInASphereLeavesAlongTheRadius) {
  TestRig rig;
  rig.add({.joint = {0.3f, 1.4f, 0}});
  rig.add_sphere({0, 0, 0}, 1);
  ThesisStep step(rig);  // rests at (0.3, 0.4, 0), half a radius from the centre
  step.run();
  expect_particle(step.particles[0], {0.6f, 0.8f, 0}, {3, 4, 0});
}

TEST(ThesisStep, ParticleOutsideASphereIsLeftAlone) {
  TestRig rig;
  rig.add({.joint = {0, 2.5f, 0}});
  rig.add_sphere({0, 0, 0}, 1);
  ThesisStep step(rig);
  step.run();
  expect_particle(step.particles[0], {0, 1.5f, 0}, {0, 0, 0});
}

TEST(ThesisStep, ParticleInAnEllipsoidLeavesAlongTheRadiusOfItsUnitSphere) {
  TestRig rig;
  rig.add({.joint = {0.6f, 1.4f, 0}});
  rig.add_ellipsoid({0, 0, 0}, {2, 1, 1});
  ThesisStep step(rig);  // (0.6, 0.4, 0) is (0.3, 0.4, 0) in the unit sphere: half way out
  step.run();
  expect_particle(step.particles[0], {1.2f, 0.8f, 0}, {6, 4, 0});
}

TEST(ThesisStep, EllipsoidTurnsWithItsOwnRotation) {
  TestRig rig;
  rig.add({.joint = {-0.4f, 1.6f, 0}});
  rig.add_ellipsoid({0, 0, 0}, {2, 1, 1}, turned_about({0, 0, 1}, kQuarterTurn));  // long along y now
  ThesisStep step(rig);
  step.run();
  expect_particle(step.particles[0], {-0.8f, 1.2f, 0}, {-4, 6, 0});
}

TEST(ThesisStep, CollidersMoveWithTheHead) {
  TestRig rig;
  rig.add({});
  rig.add_sphere({1, 0, 0}, 0.5f);
  ThesisStep step(rig);
  step.head_rotation = turned_about({0, 0, 1}, -kQuarterTurn);  // carries the sphere to (0, -1, 0)
  step.particles[0].position = {0, -1, 0.1f};                   // length puts it at (0, -0.995037, 0.099504)
  step.run();
  EXPECT_NEAR(distance(step.particles[0].position, {0, -1, 0}), 0.5f, kNear);
  EXPECT_GT(step.particles[0].position.z, 0.49f);
}

TEST(ThesisStep, ParticleAtTheCentreLeavesAlongTheCollidersOwnUp) {
  TestRig sphere, ellipsoid;
  sphere.add({.joint = {0, 1, 0}});
  sphere.add_sphere({0, 0, 0}, 0.5f);
  ellipsoid.add({.joint = {0, 1, 0}});
  ellipsoid.add_ellipsoid({0, 0, 0}, {3, 2, 1}, turned_about({0, 0, 1}, kQuarterTurn));
  ThesisStep in_sphere(sphere), in_ellipsoid(ellipsoid);
  in_sphere.run();
  in_ellipsoid.run();
  expect_particle(in_sphere.particles[0], {0, 0.5f, 0}, {0, 5, 0});
  expect_particle(in_ellipsoid.particles[0], {-2, 0, 0}, {-20, 0, 0});
}

TEST(ThesisStep, ParticleOnItsOwnStartLeavesInItsDefaultDirection) {
  ThesisStep first(one_bone()), second(two_bones());
  first.particles[0].position = {0, 0, 0};
  second.particles[1].position = {0, -1, 0};  // on its parent's particle: 1 m too short, half for each
  first.run();
  second.run();
  expect_particle(first.particles[0], {0, -1, 0}, {0, -10, 0});
  expect_particle(second.particles[0], {0, -0.5f, 0}, {0, 5, 0});
  expect_particle(second.particles[1], {0, -1.5f, 0}, {0, -5, 0});
}

TEST(ThesisStep, BoneFoldedBackOntoItselfStaysFinite) {
  TestRig rig = two_bones();
  rig.dynamics[2].resistance = 1;
  ThesisStep step(rig);
  step.particles[0].position = {0, 1, 0};  // straight up, where the shortest arc has no axis
  step.run();
  EXPECT_LT(distance(step.particles[1].position, {0, 2, 0}), kNear);
}

TEST(ThesisStep, BoneFoldedBackTurnsWithTheHead) {
  TestRig rig = two_bones();
  rig.bones[2].rest_direction[0] = 0.6f;
  rig.bones[2].rest_direction[1] = -0.8f;
  rig.dynamics[2].resistance = 1;
  ThesisStep upright(rig), turned(rig);
  upright.particles[0].position = {0, 1, 0};
  turned.particles[0].position = {0, 0, 1};  // the same, under a head that lies on its face
  turned.head_rotation = turned_about({1, 0, 0}, kQuarterTurn);
  upright.run();
  turned.run();
  const Vec3 end = upright.particles[1].position;
  EXPECT_LT(distance(turned.particles[1].position, {end.x, -end.z, end.y}), kNear);
}

TEST(ThesisStep, BonesOfDifferentFrictionEachLoseTheirOwnShare) {
  TestRig rig;
  rig.add({.friction = 0});
  rig.add({.joint = {3, 0, 0}, .friction = 10 * std::log(4.0f)});
  ThesisStep step(rig);
  for (Particle& particle : step.particles) particle.velocity = {0, -1, 0};
  step.air_velocity = {0, -1, 0};
  step.gravity = {0, 0, 4};
  step.run();
  // v = 0.4 along z, of which the second keeps a quarter; x = (0, -1.1, 0.04) and (3, -1.1, 0.01), brought to 1 m.
  EXPECT_NEAR(step.particles[0].position.z / step.particles[0].position.y, -0.04f / 1.1f, kNear);
  EXPECT_NEAR(step.particles[1].position.z / step.particles[1].position.y, -0.01f / 1.1f, kNear);
}

}  // namespace coif::thesis_step_test
