// How frames turn about their own bones: what makes cards flip where it is wrong.

#include "models/playback.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::twist_test {

constexpr double kQuarter = 1.57079632679489662;

/// Radians by which one rotation is turned against the other.
double turned_by(const Mat34& a, const Mat34& b) {
  double square = 0;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) square += std::pow(a.m[row][column] - b.m[row][column], 2);
  }
  return 2 * std::asin(std::min(1.0, std::sqrt(square / 8)));
}

/// A bone without a pull of its own below a stiff one: it points where gravity does.
TestRig loose_bone(float torsion) {
  TestRig rig;
  rig.add({.length = 0.1f, .stiffness = 1e8f, .damping = 2e4f});
  rig.add({.parent = 1,
           .length = 0.1f,
           .resistance = 0,
           .friction = 15,
           .stiffness = 0,
           .damping = 15,
           .torsion = torsion});
  return rig;
}

/// Steps at 240 fps while gravity goes from one direction to the other on the shorter arc; calls `look` after each.
void sweep(
    Hair& hair, const Vec3& from, const Vec3& to, double seconds, const std::function<void()>& look = [] {}) {
  const Vec3 axis{from.y * to.z - from.z * to.y, from.z * to.x - from.x * to.z, from.x * to.y - from.y * to.x};
  const float sine = distance(axis, {});
  const Vec3 unit{axis.x / sine, axis.y / sine, axis.z / sine};
  const double whole = std::atan2(sine, from.x * to.x + from.y * to.y + from.z * to.z);
  const int count = int(std::lround(240 * seconds));
  for (int i = 1; i <= count; ++i) {
    const Vec3 g = rotated(turned_about(unit, whole * i / count), from);
    StepSettings settings{.dt = 1.0f / 240};
    settings.environment.gravity = {40 * g.x, 40 * g.y, 40 * g.z};
    ASSERT_EQ(hair.step(settings), Status::kOk);
    look();
  }
}

const Vec3 kDown{0, -1, 0}, kForward{0, 0, 1}, kBack{0, 0, -1}, kRight{1, 0, 0};
const Vec3 kAlmostUp{0.02f, 0.9998f, 0};

/// The largest turn of the loose bone's frame in a step while it folds over its parent, a little to the side, and back.
double worst_turn_while_folding(const Solver* solver) {
  TestHair test(loose_bone(5), {.solver = solver});
  double worst = 0;
  Mat34 last = test.hair.palette(0)[2];
  const auto look = [&] {
    const Mat34& now = test.hair.palette(0)[2];
    worst = std::max(worst, turned_by(last, now));
    last = now;
  };
  const Vec3 stations[] = {kDown, kForward, kAlmostUp, kBack, kAlmostUp, kForward, kDown};
  for (int i = 0; i < 6; ++i) sweep(test.hair, stations[i], stations[i + 1], 1, look);
  return worst;
}

TEST(Twist, FoldingOverTheParentAndBackDoesNotFlip) {
  EXPECT_LT(worst_turn_while_folding(&kCoifSolver), 0.1) << "radians";
  EXPECT_GT(worst_turn_while_folding(&kThesisSolver), 0.5) << "its frames flip within a few steps";
}

/// How far the frame is turned after the bone went around an eighth of the sphere: down, forward, right, down.
double turn_after_an_octant(float torsion, double seconds_after) {
  TestHair test(loose_bone(torsion));
  sweep(test.hair, kDown, kForward, 1);
  sweep(test.hair, kForward, kRight, 1);
  sweep(test.hair, kRight, kDown, 1);
  sweep(test.hair, kDown, {0, -0.99995f, 0.01f}, seconds_after);
  return turned_by(test.hair.palette(0)[2], {});
}

TEST(Twist, WithoutTorsionABoneKeepsTheTwistThatItsWayGaveIt) {
  EXPECT_NEAR(turn_after_an_octant(0, 1), kQuarter, 0.03) << "the octant's area";
  EXPECT_NEAR(turn_after_an_octant(0, 20), kQuarter, 0.03);
}

TEST(Twist, TorsionTurnsItBack) {
  EXPECT_LT(turn_after_an_octant(5, 3), 0.03);
  EXPECT_LT(turn_after_an_octant(1e6f, 0.2), 0.3);
  EXPECT_LT(turn_after_an_octant(1e6f, 1), 0.03);
}

TEST(Twist, TorsionTurnsItBackAtTheSameRateAtEveryTimeStep) {
  const auto after = [](double fps) {
    TestHair test(loose_bone(2));
    sweep(test.hair, kDown, kForward, 1);
    sweep(test.hair, kForward, kRight, 1);
    sweep(test.hair, kRight, kDown, 1);
    for (int i = 0; i < int(std::lround(0.5 * fps)); ++i) (void)test.hair.step({.dt = float(1 / fps)});
    return turned_by(test.hair.palette(0)[2], {});
  };
  EXPECT_NEAR(after(12), after(240), 0.02);
  EXPECT_NEAR(after(60), after(240), 0.005);
}

TEST(Twist, RandomTurnsLeaveNoneBehind) {
  const TestRig rig = calm_strand(6, 0.3f);
  TestHair test(rig);
  StepSettings settings;
  settings.environment.gravity = {};
  Violence random(11);
  for (int i = 0; i < 2000; ++i) {
    ASSERT_EQ(test.hair.set_head(0, {{}, random.next().rotation}), Status::kOk);
    ASSERT_EQ(test.hair.step(settings), Status::kOk);
  }
  for (int i = 0; i < 600; ++i) ASSERT_EQ(test.hair.step(settings), Status::kOk);
  for (const Mat34& matrix : test.hair.palette(0)) EXPECT_LT(turned_by(matrix, {}), 1e-3);
}

TEST(Twist, FramesStayRotations) {
  TestHair test(calm_strand(6, 0.3f));
  Violence random(12);
  for (int i = 0; i < 5000; ++i) {
    ASSERT_EQ(test.hair.set_head(0, random.next()), Status::kOk);
    ASSERT_EQ(test.hair.step({}), Status::kOk);
  }
  for (const Mat34& matrix : test.hair.palette(0)) {
    for (const auto& row : matrix.m) EXPECT_NEAR(std::hypot(row[0], row[1], row[2]), 1, 1e-5);
  }
}

TEST(Twist, BonesPointAlongTheirFrames) {
  const TestRig rig = calm_strand(6, 0.3f);
  TestHair test(rig);
  for (int frame = 1; frame <= 200; ++frame) {
    ASSERT_EQ(test.hair.set_head(0, wander(frame / 60.0)), Status::kOk);
    ASSERT_EQ(test.hair.step({}), Status::kOk);
    const std::vector<Vec3> ends = test.ends(), rest = rig.rest_ends();
    for (std::size_t i = 0; i < ends.size(); ++i)
      ASSERT_LT(distance(transformed(test.hair.palette(0)[i + 1], rest[i]), ends[i]), 1e-5f) << frame << " " << i;
  }
}

}  // namespace coif::twist_test
