// What holds after every step of the default solver, whatever the head does: no bone stretches, and no part of a bone
// is nearer to a collider than its hit radius.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace coif::constraint_test {

constexpr float kAnywhere = std::numeric_limits<float>::infinity();
constexpr double kRounding = 1e-5;  // metres

struct Point {
  double x, y, z;
};

/// Distance from the hull of two balls, metres, negative inside: from the nearest of the balls between them, which a
/// search finds since the distance has one minimum along the axis.
double gap_to_capsule(const Point& a, double radius_a, const Point& b, double radius_b, const Point& p) {
  const auto gap = [&](double s) {
    const double x = a.x + s * (b.x - a.x), y = a.y + s * (b.y - a.y), z = a.z + s * (b.z - a.z);
    return std::hypot(p.x - x, p.y - y, p.z - z) - radius_a - s * (radius_b - radius_a);
  };
  double low = 0, high = 1;
  for (int i = 0; i < 25; ++i) {
    const double left = low + (high - low) / 3, right = high - (high - low) / 3;
    if (gap(left) < gap(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  return gap((low + high) / 2);
}

/// A collider, and its distance from a point as a formula of its own.
struct Shape {
  const char* name;
  std::function<void(TestRig&)> add;
  std::function<double(const Point&, double hit_radius)> gap;  ///< Metres beyond the hit radius; negative: too near.
};

double gap_to_ellipsoid(const Point& p, double grown) {
  const Vec3 own = rotated(turned_about({0.6f, 0, 0.8f}, -0.7), {float(p.x), float(p.y - 0.02), float(p.z)});
  const double a = 0.08 + grown, b = 0.12 + grown, c = 0.1 + grown;
  const double ratio = std::hypot(own.x / a, own.y / b, own.z / c);
  const double slope = std::hypot(own.x / a / a, own.y / b / b, own.z / c / c) / ratio;
  return (ratio - 1) / slope;
}

std::vector<Shape> shapes() {
  return {
      {"sphere",
       [](TestRig& rig) {
         rig.add_sphere({0.01f, 0.02f, 0}, 0.1f);
       },
       [](const Point& p, double hit) { return std::hypot(p.x - 0.01, p.y - 0.02, p.z) - 0.1 - hit; }},
      {"ellipsoid",
       [](TestRig& rig) {
         rig.add_ellipsoid({0, 0.02f, 0}, {0.08f, 0.12f, 0.1f}, turned_about({0.6f, 0, 0.8f}, 0.7));
       },
       gap_to_ellipsoid},
      {"capsule",
       [](TestRig& rig) {
         rig.add_capsule({-0.03f, -0.04f, 0}, {0.04f, 0.05f, 0.02f}, 0.07f);
       },
       [](const Point& p, double hit) {
         return gap_to_capsule({-0.03, -0.04, 0}, 0.07, {0.04, 0.05, 0.02}, 0.07, p) - hit;
       }},
      {"tapered capsule",
       [](TestRig& rig) {
         rig.add_tapered_capsule({0, 0.04f, 0}, 0.09f, {0.02f, -0.06f, 0.02f}, 0.03f);
       },
       [](const Point& p, double hit) {
         return gap_to_capsule({0, 0.04, 0}, 0.09, {0.02, -0.06, 0.02}, 0.03, p) - hit;
       }},
      {"plane",
       [](TestRig& rig) {
         rig.add_plane({0, -0.16f, 0}, {0, 0.8f, 0.6f});
       },
       [](const Point& p, double hit) { return 0.8 * (p.y + 0.16) + 0.6 * p.z - hit; }},
  };
}

/// Chains of four bones all around a head at the origin, their joints clear of every shape above.
TestRig ring(float hit_radius) {
  TestRig rig;
  for (int chain = 0; chain < 8; ++chain) {
    const double heading = 0.785398 * chain;
    const Vec3 out{float(std::cos(heading)), 0, float(std::sin(heading))};
    std::uint32_t parent = 0;
    for (int i = 0; i < 4; ++i) {
      const float stiffness = chain % 2 == 0 ? 20.0f : 400.0f;
      parent = rig.add({.parent = parent,
                        .joint = {0.15f * out.x, 0.02f, 0.15f * out.z},
                        .rest_direction = {0.6f * out.x, -0.8f, 0.6f * out.z},
                        .length = 0.06f,
                        .friction = 0.5f,
                        .hit_radius = hit_radius,
                        .stiffness = stiffness,
                        .damping = 2 * std::sqrt(stiffness)});
    }
  }
  return rig;
}

/// The smallest gap of any part of any bone.
double smallest_gap(const TestRig& rig, const std::vector<Vec3>& ends, const Shape& shape, double hit_radius) {
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Vec3 a = start_of(rig, ends, i), b = ends[i];
    for (int k = 0; k <= 20; ++k) {
      const double s = k / 20.0;
      const Point p{a.x + s * (b.x - a.x), a.y + s * (b.y - a.y), a.z + s * (b.z - a.z)};
      smallest = std::min(smallest, shape.gap(p, hit_radius));
    }
  }
  return smallest;
}

StepSettings believing_all(float dt) { return {.dt = dt, .teleport_distance = kAnywhere, .teleport_angle = kAnywhere}; }

TEST(Constraints, HoldUnderViolenceForEveryShapeAtEveryTimeStep) {
  for (const Shape& shape : shapes()) {
    for (const float hit_radius : {0.0f, 0.02f}) {
      TestRig rig = ring(hit_radius);
      shape.add(rig);
      for (const float dt : {1.0f / 240, 1.0f / 60, 1.0f / 15, 0.1f}) {
        SCOPED_TRACE(testing::Message() << shape.name << ", hit radius " << hit_radius << ", dt " << dt);
        TestHair test(rig);
        Violence violence(7);
        double gap = 0;
        float stretch = 0;
        for (int frame = 0; frame < 30; ++frame) {
          ASSERT_EQ(test.hair.set_head(0, violence.next()), Status::kOk);
          ASSERT_EQ(test.hair.step(believing_all(dt)), Status::kOk);
          stretch = std::max(stretch, worst_stretch(rig, test.ends()));
          gap = std::min(gap, smallest_gap(rig, test.ends(), shape, hit_radius));
        }
        EXPECT_LT(stretch, 1e-5f);
        EXPECT_GT(gap, -kRounding);
      }
    }
  }
}

TEST(Constraints, EndsStayInsideOfShapesThatKeepThemIn) {
  for (const float hit_radius : {0.0f, 0.02f}) {
    TestRig in_sphere = ring(hit_radius), in_capsule = ring(hit_radius);
    in_sphere.add_sphere({}, 0.22f);
    in_capsule.add_capsule({-0.05f, 0, 0}, {0.05f, -0.05f, 0}, 0.2f);
    in_sphere.colliders[0].flags = in_capsule.colliders[0].flags = kColliderKeepsInside;
    for (const float dt : {1.0f / 240, 1.0f / 15}) {
      TestHair round(in_sphere), oval(in_capsule);
      Violence violence(3);
      for (int frame = 0; frame < 100; ++frame) {
        const HeadPose pose = violence.next();
        for (TestHair* test : {&round, &oval}) {
          ASSERT_EQ(test->hair.set_head(0, pose), Status::kOk);
          ASSERT_EQ(test->hair.step(believing_all(dt)), Status::kOk);
        }
        for (const Vec3& end : round.ends()) ASSERT_LT(distance(end, {}), 0.22 - hit_radius + kRounding);
        for (const Vec3& end : oval.ends()) {
          const double gap = gap_to_capsule({-0.05, 0, 0}, 0.2, {0.05, -0.05, 0}, 0.2, {end.x, end.y, end.z});
          ASSERT_LT(gap, -hit_radius + kRounding) << "frame " << frame;
        }
        ASSERT_LT(worst_stretch(in_sphere, round.ends()), 1e-5f);
      }
    }
  }
}

TEST(Constraints, AHeadACapsuleAndAPlaneTogetherLetNoPartInUnderAWanderingHead) {
  TestRig rig = ring(0.005f);
  rig.add_ellipsoid({0, 0.02f, 0}, {0.08f, 0.12f, 0.1f}, turned_about({0.6f, 0, 0.8f}, 0.7));
  rig.add_capsule({-0.3f, -0.25f, 0}, {0.3f, -0.25f, 0}, 0.07f);  // shoulders
  rig.add_plane({0, -0.1f, -0.25f}, {0, 0, 1});
  const std::vector<Shape> all = shapes();
  for (const double fps : {20.0, 60.0, 240.0}) {
    double head = 0, shoulders = 0, back = 0;
    for (const std::vector<Vec3>& ends : play(rig, wander, even_frames(fps, 4)).ends) {
      head = std::min(head, smallest_gap(rig, ends, all[1], 0.005));
      const auto to_shoulders = [](const Point& p, double hit) {
        return gap_to_capsule({-0.3, -0.25, 0}, 0.07, {0.3, -0.25, 0}, 0.07, p) - hit;
      };
      shoulders = std::min(shoulders, smallest_gap(rig, ends, {"", {}, to_shoulders}, 0.005));
      back = std::min(
          back, smallest_gap(rig, ends, {"", {}, [](const Point& p, double hit) { return p.z + 0.25 - hit; }}, 0.005));
    }
    EXPECT_GT(head, -1e-4) << fps;
    EXPECT_GT(shoulders, -1e-4) << fps;
    EXPECT_GT(back, -1e-4) << fps;
  }
}

// Each of the two pushes hair back into the other; hits of 30 mm per step are left with a twentieth of that.
TEST(Constraints, ANarrowGrooveOfTwoPlanesHoldsHairWithinTwoMillimetres) {
  TestRig rig;
  rig.add({.rest_direction = {1, 0, 0}, .length = 0.3f, .stiffness = 10, .damping = 6});
  rig.add_plane({0, -0.05f, 0}, {0, 0.5f, 0.8660254f});
  rig.add_plane({0, -0.05f, 0}, {0, 0.5f, -0.8660254f});
  TestHair test(rig);
  StepSettings settings;
  double lowest = 0;
  for (int frame = 0; frame < 600; ++frame) {
    const double slope = 0.8 * std::sin(0.05 * frame);
    settings.environment.gravity = {0, float(-20 * std::cos(slope)), float(20 * std::sin(slope))};
    ASSERT_EQ(test.hair.step(settings), Status::kOk);
    const Vec3 end = test.ends()[0];
    ASSERT_GT(0.5f * (end.y + 0.05f) + 0.8660254f * end.z, -2e-3f) << frame;
    ASSERT_GT(0.5f * (end.y + 0.05f) - 0.8660254f * end.z, -2e-3f) << frame;
    lowest = std::min(lowest, double(end.y));
  }
  EXPECT_LT(lowest, -0.049) << "it was at the bottom";
}

/// One bone that lies across the top of what `add` puts at the origin, and that nothing but weight moves: without
/// damping, what it gathers while it is pressed would never go.
TestRig lying_bone(const std::function<void(TestRig&)>& add) {
  TestRig rig;
  rig.add({.joint = {0, 0.12f, 0.2f}, .rest_direction = {0, 0, -1}, .length = 0.18f, .stiffness = 0, .damping = 0});
  add(rig);
  return rig;
}

TEST(Constraints, PressedHairLeavesAtOnceWhenNothingPressesIt) {
  const TestRig rigs[] = {lying_bone([](TestRig& rig) { rig.add_sphere({}, 0.1f); }), lying_bone([](TestRig& rig) {
                            rig.add_ellipsoid({}, {0.12f, 0.1f, 0.09f});
                          }),
                          lying_bone([](TestRig& rig) {
                            rig.add_capsule({-0.2f, 0, 0}, {0.2f, 0, 0}, 0.1f);
                          }),
                          lying_bone([](TestRig& rig) {
                            rig.add_tapered_capsule({-0.2f, 0, 0}, 0.11f, {0.2f, 0, 0}, 0.09f);
                          }),
                          lying_bone([](TestRig& rig) {
                            rig.add_plane({0, 0.05f, 0}, {0, 1, 0});
                          })};
  for (const TestRig& rig : rigs) {
    TestHair test(rig);
    StepSettings settings;
    settings.environment.gravity = {0, -10, 0};
    for (int i = 0; i < 30; ++i) ASSERT_EQ(test.hair.step(settings), Status::kOk);
    const Vec3 pressed = test.ends()[0];
    ASSERT_GT(pressed.y, 0) << "it lies there";
    settings.environment.gravity = {0, 10, 0};
    for (int i = 0; i < 6; ++i) ASSERT_EQ(test.hair.step(settings), Status::kOk);
    // Half of 10 m/s^2 times the square of 0.1 s is 0.05 m, straight up.
    EXPECT_GT(distance(test.ends()[0], pressed), 0.03f) << "shape " << int(rig.colliders[0].shape);
  }
}

}  // namespace coif::constraint_test
