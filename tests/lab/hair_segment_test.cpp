#include "lab/hair_segment.h"
#include "research/solver_trial.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace coif::lab::hair_segment_test {

using Eigen::Vector3d;

constexpr double kRadius = 0.1, kThickness = 0.01;

SolidShape ball() { return SolidShape(research::sphere(Vector3d::Zero(), kRadius)); }

SolidShape tapered_capsule() {
  ColliderRecord record = research::sphere(Vector3d(-0.05, 0, 0), 0.1);
  record.shape = ColliderShape::kTaperedCapsule;
  record.radii[1] = 0.04f, record.radii[2] = 0;
  record.axis[0] = 0.15f, record.axis[1] = 0.03f;
  return SolidShape(record);
}

SolidShape ellipsoid() {
  ColliderRecord record = research::sphere(Vector3d(0.01, 0, 0), 0.1);
  record.shape = ColliderShape::kEllipsoid;
  record.radii[1] = 0.05f, record.radii[2] = 0.08f;
  return SolidShape(record);
}

/// Segments near the origin that start outside of `solid`.
class Segments {
 public:
  explicit Segments(const SolidShape& solid) : solid_(solid) {}

  HairSegment next() {
    for (;;) {
      const HairSegment segment{vector() * 0.2, vector().normalized(), 0.15, kThickness};
      HairSegment start = segment;
      start.length = 0;
      if (nearest_contact(solid_, start).gap > 1e-3) return segment;
    }
  }

 private:
  Vector3d vector() { return {side_(random_), side_(random_), side_(random_)}; }

  const SolidShape& solid_;
  std::mt19937 random_{7};
  std::uniform_real_distribution<double> side_{-1, 1};
};

/// Least gap of many points of the segment.
double sampled_gap(const SolidShape& solid, const HairSegment& segment) {
  double least = 1;
  for (int i = 0; i <= 2000; ++i) {
    const Vector3d point = segment.start + segment.direction * (segment.length * i / 2000.0);
    least = std::min(least, nearest_contact(solid, {point, segment.direction, 0, segment.radius}).gap);
  }
  return least;
}

TEST(HairSegment, IsAsNearAsTheNearestOfItsPoints) {
  for (const SolidShape& solid : {ball(), tapered_capsule()}) {
    Segments segments(solid);
    for (int i = 0; i < 200; ++i) {
      const HairSegment segment = segments.next();
      const double sampled = sampled_gap(solid, segment);
      const double found = nearest_contact(solid, segment).gap;
      // Where it is clear it is enough to know that.
      EXPECT_EQ(found < 0, sampled < 0) << i;
      EXPECT_NEAR(std::min(found, 0.0), std::min(sampled, 0.0), 1e-5) << i;
    }
  }
}

TEST(HairSegment, TurnsClearOfEveryShapeAndNoFurther) {
  for (const SolidShape& solid : {ball(), tapered_capsule(), ellipsoid()}) {
    Segments segments(solid);
    int turned = 0;
    for (int i = 0; i < 1000; ++i) {
      HairSegment segment = segments.next();
      const HairSegment before = segment;
      SolidContact contact;
      if (!turn_clear(solid, segment, contact)) {
        EXPECT_EQ(segment.direction, before.direction);
        EXPECT_GT(sampled_gap(solid, segment), -1e-9);
        continue;
      }
      ++turned;
      EXPECT_NEAR(nearest_contact(solid, segment).gap, 0, 1e-8) << i;
      EXPECT_GT(sampled_gap(solid, segment), -1e-8) << i;
      EXPECT_NEAR(segment.direction.norm(), 1, 1e-12);
      EXPECT_GT(contact.along, 0);
    }
    EXPECT_GT(turned, 30);
  }
}

TEST(HairSegment, LeavesABallTheShortestWay) {
  const SolidShape solid = ball();
  Segments segments(solid);
  const double radius = double(0.1f) + kThickness;
  for (int i = 0; i < 300; ++i) {
    HairSegment segment = segments.next();
    const Vector3d before = segment.direction;
    SolidContact contact;
    if (!turn_clear(solid, segment, contact)) continue;
    // The directions that touch the ball are a cone; the nearest on it is as much nearer as the angles differ.
    const double distance = segment.start.norm(), length = segment.length;
    const double tangent = std::sqrt(distance * distance - radius * radius);
    const double cosine = length < tangent
                              ? (distance * distance + length * length - radius * radius) / (2 * distance * length)
                              : tangent / distance;
    const Vector3d inward = -segment.start / distance;
    const double needed = std::acos(cosine) - std::acos(before.dot(inward));
    EXPECT_NEAR(std::acos(std::min(1.0, before.dot(segment.direction))), needed, 1e-6) << i;
  }
}

TEST(HairSegment, ThatIsTooShortPointsStraightOut) {
  HairSegment segment{Vector3d(0.02, 0, 0), Vector3d(-0.3, 0.5, 0).normalized(), 0.03, 0};
  SolidContact contact;
  ASSERT_TRUE(turn_clear(ball(), segment, contact));
  EXPECT_NEAR(segment.direction.x(), 1, 1e-6);
}

TEST(HairSegment, StartingAtTheVeryCentreHasNowhereToTurn) {
  HairSegment segment{Vector3d::Zero(), Vector3d::UnitY(), 0.03, 0};
  SolidContact contact;
  (void)turn_clear(ball(), segment, contact);
  EXPECT_TRUE(segment.direction.allFinite());
  EXPECT_NEAR(segment.direction.norm(), 1, 1e-12);
}

TEST(HairSegment, DepthThatItsStartMakesUnavoidableIsForgiven) {
  const HairSegment out{Vector3d(0.02, 0, 0), Vector3d::UnitX(), 0.03, 0};
  EXPECT_NEAR(avoidable_depth(ball(), out, HairPart::kEnd), 0, 1e-9);
  HairSegment in = out;
  in.direction = -in.direction;
  EXPECT_NEAR(avoidable_depth(ball(), in, HairPart::kEnd), 0.04, 1e-7);  // 9 cm deep where 5 cm would do
}

TEST(HairSegment, MiddleCountsForWholeBonesOnly) {
  const HairSegment across{Vector3d(-0.2, 0.05, 0), Vector3d::UnitX(), 0.4, 0};
  EXPECT_EQ(avoidable_depth(ball(), across, HairPart::kEnd), 0);
  EXPECT_NEAR(avoidable_depth(ball(), across, HairPart::kWhole), 0.05, 1e-7);
}

}  // namespace coif::lab::hair_segment_test
