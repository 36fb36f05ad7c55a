#include <coif/palette_job.h>

#include "sim/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>

namespace coif {
namespace {

constexpr float kNear = 2e-5f;
constexpr double kQuarterTurn = 1.5707963267948966;

/// A PaletteJob with its outputs.
struct TestPalette {
  explicit TestPalette(const TestRig& from)
      : rig(from), frames(from.simulated_count()), palette(from.bones.size()), ends(from.bones.size()) {
    for (const Vec3& end : rig.rest_ends()) particles.push_back({end, {}});
  }
  PaletteJob job() {
    PaletteJob job;
    job.bones = rig.bones;
    job.particles = particles;
    job.frames = frames;
    job.palette = palette;
    job.bone_ends = ends;
    return job;
  }

  TestRig rig;
  std::vector<Particle> particles;
  std::vector<Quat> frames;
  std::vector<Mat34> palette;
  std::vector<Vec3> ends;
};

TestRig bent_fork() {
  TestRig rig;
  rig.add({.joint = {1, 0, 0}, .length = 2});
  rig.add({.parent = 1, .rest_direction = {1, 0, 0}, .length = 0.5f});
  rig.add({.parent = 1, .rest_direction = {0, 0.6f, -0.8f}, .length = 0.7f});
  return rig;
}

TEST(PaletteJob, RestPoseGivesIdentityMatrices) {
  TestPalette test(bent_fork());
  ASSERT_EQ(test.job().run(), Status::kOk);
  const Vec3 somewhere{0.3f, -2, 5};
  for (const Mat34& matrix : test.palette) {
    EXPECT_LT(distance(transformed(matrix, somewhere), somewhere), kNear);
  }
  EXPECT_LT(distance(test.ends[0], {0, 0, 0}), kNear);
  EXPECT_LT(distance(test.ends[1], {1, -2, 0}), kNear);
  EXPECT_LT(distance(test.ends[2], {1.5f, -2, 0}), kNear);
}

TEST(PaletteJob, QuarterTurnCarriesTheBoneAboutItsJoint) {
  TestPalette test(bent_fork());
  test.particles[0].position = {3, 0, 0};
  ASSERT_EQ(test.job().run(), Status::kOk);
  EXPECT_LT(distance(transformed(test.palette[1], {1, 0, 0}), {1, 0, 0}), kNear);
  EXPECT_LT(distance(transformed(test.palette[1], {1, -2, 0}), {3, 0, 0}), kNear);
  EXPECT_LT(distance(transformed(test.palette[1], {2, 0, 0}), {1, 1, 0}), kNear);
}

TEST(PaletteJob, MatricesTakeRestSegmentsOntoParticles) {
  TestPalette test(bent_fork());
  // Lengths hold, directions are arbitrary.
  test.particles[0].position = {1 + 1.2f, 0, 1.6f};
  test.particles[1].position = {2.2f, 0.3f, 1.6f + 0.4f};
  test.particles[2].position = {2.2f - 0.7f, 0, 1.6f};
  ASSERT_EQ(test.job().run(), Status::kOk);
  const auto rest = test.rig.rest_ends();
  for (std::size_t bone = 1; bone < test.palette.size(); ++bone) {
    EXPECT_LT(distance(transformed(test.palette[bone], rest[bone - 1]), test.particles[bone - 1].position), kNear);
  }
  for (const std::size_t child : {2u, 3u}) {  // the fork does not tear open
    EXPECT_LT(distance(transformed(test.palette[child], rest[0]), test.particles[0].position), kNear);
  }
}

TEST(PaletteJob, HeadRotationIsTakenOut) {
  TestPalette plain(bent_fork()), turned(bent_fork());
  plain.particles[1].position = {1, -2, 0.5f};
  auto job = turned.job();
  job.head_rotation = turned_about({0, 1, 0}, kQuarterTurn);
  for (std::size_t i = 0; i < plain.particles.size(); ++i) {
    const Vec3& p = plain.particles[i].position;
    turned.particles[i].position = {p.z, p.y, -p.x};
  }
  ASSERT_EQ(plain.job().run(), Status::kOk);
  ASSERT_EQ(job.run(), Status::kOk);
  EXPECT_LT(largest_distance(plain.ends, turned.ends), kNear);
  for (std::size_t bone = 0; bone < plain.palette.size(); ++bone) {
    const Vec3 probe{1, 2, 3};
    EXPECT_LT(distance(transformed(plain.palette[bone], probe), transformed(turned.palette[bone], probe)), kNear);
  }
}

TEST(PaletteJob, BoneFoldedBackTurnsHalfWay) {
  TestPalette test(bent_fork());
  test.particles[0].position = {1, 2, 0};
  ASSERT_EQ(test.job().run(), Status::kOk);
  EXPECT_LT(distance(transformed(test.palette[1], {1, -2, 0}), {1, 2, 0}), kNear);
}

TEST(PaletteJob, BoneWithoutLengthKeepsItsRestDirection) {
  TestPalette test(bent_fork());
  test.particles[0].position = {1, 0, 0};
  ASSERT_EQ(test.job().run(), Status::kOk);
  EXPECT_LT(distance(transformed(test.palette[1], {1, -2, 0}), {1, -2, 0}), kNear);
}

TEST(PaletteJob, RefusedJobsLeaveTheirOutputs) {
  TestPalette test(bent_fork());
  const auto expect_refused = [&test](const PaletteJob& job, Status expected) {
    test.palette[1].m[0][0] = 42;
    EXPECT_EQ(job.run(), expected);
    EXPECT_EQ(test.palette[1].m[0][0], 42);
  };
  auto job = test.job();
  job.head_rotation.w = 2;
  expect_refused(job, Status::kBadPose);
  job = test.job();
  job.frames = job.frames.first(2);
  expect_refused(job, Status::kSizeMismatch);
  job = test.job();
  job.palette = job.palette.first(3);
  expect_refused(job, Status::kSizeMismatch);
  job = test.job();
  job.bone_ends = job.bone_ends.first(3);
  expect_refused(job, Status::kSizeMismatch);
  test.rig.bones[2].parent = 2;
  expect_refused(test.job(), Status::kBadIndex);
}

}  // namespace
}  // namespace coif
