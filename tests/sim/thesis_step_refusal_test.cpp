#include "sim/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace coif {
namespace {

/// Every refused job must leave its particles as they were.
class ThesisStepRejects : public testing::Test {
 protected:
  void expect_refused(const ThesisStepJob& job, Status expected) {
    step_.particles[0].velocity = {1, 2, 3};
    const auto before = step_.particles;
    EXPECT_EQ(job.run(), expected);
    EXPECT_EQ(std::memcmp(before.data(), step_.particles.data(), before.size() * sizeof(Particle)), 0);
  }
  static TestRig two_bones() {
    TestRig rig;
    rig.add({});
    rig.add({.parent = 1});
    return rig;
  }
  TestStep step_{two_bones()};
  ThesisStepJob job_ = step_.job();
};

TEST_F(ThesisStepRejects, TimeSteps) {
  for (const float dt : {0.0f, -0.1f, 0.1001f, INFINITY, NAN}) {
    job_.dt = dt;
    expect_refused(job_, Status::kBadTimeStep);
  }
}

TEST_F(ThesisStepRejects, Iterations) {
  for (const std::uint32_t iterations : {0u, kMaxIterations + 1, kNone}) {
    job_.iterations = iterations;
    expect_refused(job_, Status::kBadArgument);
  }
}

TEST_F(ThesisStepRejects, ForcesThatAreNotFinite) {
  for (Vec3 ThesisStepJob::*field :
       {&ThesisStepJob::gravity, &ThesisStepJob::air_velocity, &ThesisStepJob::head_displacement}) {
    for (const float bad : {NAN, INFINITY, -INFINITY}) {
      ThesisStepJob job = step_.job();
      (job.*field).z = bad;
      expect_refused(job, Status::kBadArgument);
    }
  }
}

TEST_F(ThesisStepRejects, RotationsThatAreNotUnit) {
  for (const Quat& q : {Quat{0, 0, 0, 0}, Quat{0, 0, 0, 1.01f}, Quat{NAN, 0, 0, 1}, Quat{0, INFINITY, 0, 1}}) {
    job_.head_rotation = q;
    expect_refused(job_, Status::kBadPose);
  }
}

TEST_F(ThesisStepRejects, SpansThatDoNotBelongTogether) {
  auto job = step_.job();
  job.dynamics = job.dynamics.first(2);
  expect_refused(job, Status::kSizeMismatch);
  job = step_.job();
  job.friction_factors = job.friction_factors.first(1);
  expect_refused(job, Status::kSizeMismatch);
  job = step_.job();
  job.scratch = job.scratch.first(1);
  expect_refused(job, Status::kSizeMismatch);
  job = step_.job();
  job.bones = job.bones.first(1);
  expect_refused(job, Status::kSizeMismatch);
}

TEST_F(ThesisStepRejects, ParentsThatComeLater) {
  for (const std::uint32_t parent : {2u, 3u, kNone}) {
    step_.rig.bones[2].parent = parent;
    expect_refused(step_.job(), Status::kBadIndex);
  }
}

}  // namespace
}  // namespace coif
