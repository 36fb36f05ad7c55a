// How deep in a collider a bone may start and still be kept out of it over its whole length.

#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace coif::contact_depth_test {

constexpr float kRadius = 0.1f;

/// Round about the origin, seen from the z axis.
struct Round {
  const char* name;
  std::function<void(TestRig&)> add;
};

std::vector<Round> round_shapes() {
  return {{"sphere", [](TestRig& rig) { rig.add_sphere({}, kRadius); }},
          {"ellipsoid",
           [](TestRig& rig) {
             rig.add_ellipsoid({}, {kRadius, kRadius, kRadius});
           }},
          {"capsule", [](TestRig& rig) {
             rig.add_capsule({0, 0, -1}, {0, 0, 1}, kRadius);
           }}};
}

struct Depths {
  float middle = 0, end = 0;
};

/// Metres in the shape, of a bone that starts so deep on its top and points a quarter of a right angle downwards.
Depths depths_of(const Round& round, float share) {
  TestRig rig;
  const TestBone bone{.joint = {0, kRadius * (1 - share), 0},
                      .rest_direction = {0.92387953f, -0.38268343f, 0},
                      .length = 0.05f,
                      .stiffness = 1e4f,
                      .damping = 200,
                      .torsion = kShortestArc};
  rig.add(bone);
  round.add(rig);
  TestHair test(rig);
  StepSettings settings;
  settings.environment.gravity = {};
  for (int frame = 0; frame < 5; ++frame) EXPECT_EQ(test.hair.step(settings), Status::kOk);
  const Vec3 end = test.ends()[0];
  const auto depth = [](float x, float y) { return kRadius - std::hypot(x, y); };
  return {depth(0.5f * end.x, 0.5f * (end.y + bone.joint.y)), depth(end.x, end.y)};
}

/// MODEL.md: a start that is a thousandth of the collider's size deep is on its surface.
TEST(ContactDepth, FromAStartOnTheSurfaceAllOfABoneStaysOutFromADeeperOneItsEnd) {
  for (const Round& round : round_shapes()) {
    for (const float share : {0.0f, 3e-4f, 9e-4f}) {
      const Depths on_surface = depths_of(round, share);
      EXPECT_LT(on_surface.middle, kRadius * (share + 1e-4f)) << round.name << ' ' << share;
      EXPECT_LT(on_surface.end, 1e-5f) << round.name << ' ' << share;
    }
    for (const float share : {1.05e-3f, 3e-3f, 3e-2f}) {
      const Depths deep = depths_of(round, share);
      EXPECT_LT(std::fabs(deep.end), 1e-5f) << round.name << ' ' << share << ": no further than it has to";
      EXPECT_GT(deep.middle, 1e-3f) << round.name << ' ' << share;
    }
  }
}

}  // namespace coif::contact_depth_test
