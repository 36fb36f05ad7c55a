// What a renderer gets: matrices that take the rest pose to where the particles are.

#include "models/playback.h"
#include "sim/thesis_step.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif::palette_test {

constexpr float kNear = 2e-5f;
constexpr double kQuarterTurn = 1.5707963267948966;

TestRig bent_fork() {
  TestRig rig;
  rig.add({.joint = {1, 0, 0}, .length = 2});
  rig.add({.parent = 1, .rest_direction = {1, 0, 0}, .length = 0.5f});
  rig.add({.parent = 1, .rest_direction = {0, 0.6f, -0.8f}, .length = 0.7f});
  return rig;
}

TEST(Palette, RestPoseGivesIdentityMatrices) {
  ThesisStep test(bent_fork());
  test.run();
  const Vec3 somewhere{0.3f, -2, 5};
  for (const Mat34& matrix : test.palette) {
    EXPECT_LT(distance(transformed(matrix, somewhere), somewhere), kNear);
  }
}

TEST(Palette, QuarterTurnCarriesTheBoneAboutItsJoint) {
  ThesisStep test(bent_fork());
  test.particles[0].position = {3, 0, 0};
  test.particles[1].position = {3, 0.5f, 0};
  test.particles[2].position = {2.58f, 0, -0.56f};
  test.run();
  EXPECT_LT(distance(transformed(test.palette[1], {1, 0, 0}), {1, 0, 0}), kNear);
  EXPECT_LT(distance(transformed(test.palette[1], {1, -2, 0}), {3, 0, 0}), kNear);
  EXPECT_LT(distance(transformed(test.palette[1], {2, 0, 0}), {1, 1, 0}), kNear);
}

TEST(Palette, MatricesTakeRestSegmentsOntoParticles) {
  ThesisStep test(bent_fork());
  // Lengths hold, directions are arbitrary.
  test.particles[0].position = {1 + 1.2f, 0, 1.6f};
  test.particles[1].position = {2.2f, 0.3f, 1.6f + 0.4f};
  test.particles[2].position = {2.2f - 0.7f, 0, 1.6f};
  test.run();
  const auto rest = bent_fork().rest_ends();
  for (std::size_t bone = 1; bone < test.palette.size(); ++bone) {
    EXPECT_LT(distance(transformed(test.palette[bone], rest[bone - 1]), test.particles[bone - 1].position), kNear);
  }
  for (const std::size_t child : {2u, 3u}) {  // the fork does not tear open
    EXPECT_LT(distance(transformed(test.palette[child], rest[0]), test.particles[0].position), kNear);
  }
}

TEST(Palette, HeadRotationIsTakenOut) {
  ThesisStep plain(bent_fork()), turned(bent_fork());
  plain.particles[1].position = {1, -2, 0.5f};
  turned.head_rotation = turned_about({0, 1, 0}, kQuarterTurn);
  for (std::size_t i = 0; i < plain.particles.size(); ++i) {
    const Vec3& p = plain.particles[i].position;
    turned.particles[i].position = {p.z, p.y, -p.x};
  }
  plain.run();
  turned.run();
  for (std::size_t bone = 0; bone < plain.palette.size(); ++bone) {
    const Vec3 probe{1, 2, 3};
    EXPECT_LT(distance(transformed(plain.palette[bone], probe), transformed(turned.palette[bone], probe)), kNear);
  }
}

TEST(Palette, BoneFoldedBackTurnsHalfWay) {
  ThesisStep test(bent_fork());
  test.particles[0].position = {1, 2, 0};
  test.particles[1].position = {1.5f, 2, 0};
  test.particles[2].position = {1, 2.42f, -0.56f};
  test.run();
  EXPECT_LT(distance(transformed(test.palette[1], {1, -2, 0}), {1, 2, 0}), kNear);
}

TEST(Palette, BoneEndsAreWhereTheMatricesTakeTheRestPose) {
  const TestRig rig = nine_bone_rig();
  const std::vector<Vec3> rest = rig.rest_ends();
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    TestHair test(rig, {.solver = solver});
    for (int frame = 1; frame <= 200; ++frame) {
      ASSERT_EQ(test.hair.set_head(0, wander(frame / 60.0)), Status::kOk);
      ASSERT_EQ(test.hair.step({.iterations = kMaxIterations}), Status::kOk);
      const std::vector<Vec3> ends = test.ends();
      // Matrices do not scale: what the thesis's lengths are off by is left between the two.
      const float slack = solver == &kThesisSolver ? 0.1f * worst_stretch(rig, ends) + kNear : kNear;
      for (std::size_t i = 0; i < ends.size(); ++i) {
        ASSERT_LT(distance(transformed(test.hair.palette(0)[i + 1], rest[i]), ends[i]), 3 * slack) << frame << " " << i;
      }
    }
  }
}

TEST(Palette, BoneEndsOfTheRestPoseAreItsOwn) {
  for (const Solver* const solver : {&kCoifSolver, &kPassiveSolver, &kThesisSolver}) {
    const TestHair test(bent_fork(), {.solver = solver});
    EXPECT_LT(largest_distance(test.ends(), bent_fork().rest_ends()), kNear);
  }
}

}  // namespace coif::palette_test
