// Functions of sim/vector_math.h against the machine's own.

#include "sim/vector_math.h"

#include "models/test_rig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace coif::plain_maths_test {

TEST(PlainMaths, ExponentialIsRightToTheLastDigits) {
  for (double x = -707.9; x < 708; x += 0.0371) {
    EXPECT_NEAR(plain::exp(x) / std::exp(x), 1, 3e-15) << x;
  }
  for (const double small : {0.0, 1e-300, 1e-12, 1e-3, -1e-3}) EXPECT_NEAR(plain::exp(small), std::exp(small), 2e-16);
}

/// Pose responses are finite for whatever an asset says.
TEST(PlainMaths, ExponentialEndsWhereNumbersEnd) {
  for (const double x : {-708.5, -1e9, -std::numeric_limits<double>::infinity()}) EXPECT_EQ(plain::exp(x), 0.0) << x;
  const double most = plain::exp(708);
  EXPECT_NEAR(most / std::exp(708.0), 1, 3e-15);
  for (const double x : {708.5, 720.0, 1e9, std::numeric_limits<double>::infinity()}) {
    EXPECT_EQ(plain::exp(x), most) << x;
  }
}

TEST(PlainMaths, ExponentialLessOneDoesNotCancel) {
  for (double size = 1e-300; size < 20; size *= 1.09) {
    for (const double x : {size, -size}) EXPECT_NEAR(plain::expm1(x) / std::expm1(x), 1, 2e-15) << x;
  }
  EXPECT_EQ(plain::expm1(0), 0.0);
}

TEST(PlainMaths, SineAndCosineAreRightForAMillionRadians) {
  for (double size = 1e-9; size < 1e6; size *= 1.013) {
    for (const double x : {size, -size}) {
      const plain::SineCosine at = plain::sine_cosine(x);
      EXPECT_NEAR(at.sine, std::sin(x), 2e-15 + 2e-16 * size * 1e-4) << x;
      EXPECT_NEAR(at.cosine, std::cos(x), 2e-15 + 2e-16 * size * 1e-4) << x;
    }
  }
}

TEST(PlainMaths, ARotationVectorTurnsByItsLength) {
  for (double angle = 1e-6; angle < 6; angle *= 1.21) {
    const Vec3 axis{0.48f, 0.6f, -0.64f};
    const Quat q = rotation_by({axis.x * float(angle), axis.y * float(angle), axis.z * float(angle)});
    EXPECT_NEAR(q.w, std::cos(0.5 * angle), 3e-7) << angle;
    EXPECT_NEAR(q.y / std::sin(0.5 * angle), axis.y, 2e-6) << angle;
    EXPECT_NEAR(std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w), 1, 3e-7) << angle;
  }
}

TEST(PlainMaths, APerpendicularIsAtARightAngleAndUnit) {
  Quat turn;
  for (int i = 0; i < 500; ++i) {
    turn = product(turned_about({0.36f, 0.48f, 0.8f}, 0.7), product(turned_about({1, 0, 0}, 0.41), turn));
    const Vec3 v = rotated(turn, {0, 0, 1}), other = any_perpendicular(v);
    EXPECT_NEAR(dot(v, other), 0, 1e-6);
    EXPECT_NEAR(length(other), 1, 1e-5);
  }
}

}  // namespace coif::plain_maths_test
