// Poses of heads from matrices of engines' bones: coif/head_bone.h has the formula.

#include <coif/head_bone.h>

#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <vector>

namespace coif::head_bone_test {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();

/// First `b`, then `a`.
BoneMatrix operator*(const BoneMatrix& a, const BoneMatrix& b) {
  BoneMatrix c;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) {
      c.m[i][k] = a.m[i][0] * b.m[0][k] + a.m[i][1] * b.m[1][k] + a.m[i][2] * b.m[2][k] + (k == 3 ? a.m[i][3] : 0);
    }
  }
  return c;
}

BoneMatrix scaled(double x, double y, double z) { return {{{x, 0, 0, 0}, {0, y, 0, 0}, {0, 0, z, 0}}}; }
BoneMatrix scaled(double all) { return scaled(all, all, all); }
BoneMatrix moved(double x, double y, double z) { return {{{1, 0, 0, x}, {0, 1, 0, y}, {0, 0, 1, z}}}; }

/// About an axis that need not be unit, by radians.
BoneMatrix turned(double x, double y, double z, double angle) {
  const double length = std::sqrt(x * x + y * y + z * z), c = std::cos(angle), s = std::sin(angle), d = 1 - c;
  x /= length, y /= length, z /= length;
  return {{{c + x * x * d, x * y * d - z * s, x * z * d + y * s, 0},
           {y * x * d + z * s, c + y * y * d, y * z * d - x * s, 0},
           {z * x * d - y * s, z * y * d + x * s, c + z * z * d, 0}}};
}

BoneMatrix matrix_of(const HeadPose& pose) {
  const double x = pose.rotation.x, y = pose.rotation.y, z = pose.rotation.z, w = pose.rotation.w, s = pose.scale;
  const double(&p)[3] = pose.position;
  return {{{s * (1 - 2 * (y * y + z * z)), s * 2 * (x * y - w * z), s * 2 * (x * z + w * y), p[0]},
           {s * 2 * (x * y + w * z), s * (1 - 2 * (x * x + z * z)), s * 2 * (y * z - w * x), p[1]},
           {s * 2 * (x * z - w * y), s * 2 * (y * z + w * x), s * (1 - 2 * (x * x + y * y)), p[2]}}};
}

double largest_difference(const BoneMatrix& a, const BoneMatrix& b) {
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 4; ++k) most = std::fmax(most, std::fabs(a.m[i][k] - b.m[i][k]));
  }
  return most;
}

HeadPose pose_of(const BoneMatrix& bone, const HeadBone& head_bone) {
  HeadPose pose;
  EXPECT_EQ(head_pose_of_bone(bone, head_bone, pose), Status::kOk);
  const Quat& q = pose.rotation;
  EXPECT_NEAR(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1, 1e-6);
  EXPECT_GE(q.w, 0);
  EXPECT_EQ(pose.reserved, 0);
  return pose;
}

/// A matrix as an engine's float arithmetic leaves it.
BoneMatrix in_floats(BoneMatrix matrix) {
  for (auto& row : matrix.m) {
    for (double& number : row) number = double(float(number));
  }
  return matrix;
}

/// Any rest pose of a bone 1.6 m above the floor, in a rig with the given scale.
BoneMatrix some_rest(std::mt19937& random, double rig_scale) {
  std::uniform_real_distribution<double> any(-1, 1);
  return scaled(rig_scale) * moved(0, 1.6 / rig_scale, 0.02 / rig_scale) *
         turned(any(random), any(random), any(random), 3 * any(random));
}

/// Where a character stands: any place and turn, at a scale.
BoneMatrix some_place(std::mt19937& random, double scale) {
  std::uniform_real_distribution<double> any(-1, 1);
  return moved(9 * any(random), any(random), 9 * any(random)) *
         turned(any(random), any(random), any(random), 3.1 * any(random)) * scaled(scale);
}

TEST(HeadPoseOfBone, HairFollowsTheHeadInEveryRigAsItWasModelled) {
  std::mt19937 random(1);
  for (const double rig_scale : {1.0, 0.01, 100.0, 0.001, 0.0254}) {
    for (const double scale : {1.0, 0.06, 0.5, 1.7, 19.0}) {
      for (int i = 0; i < 50; ++i) {
        const BoneMatrix rest = some_rest(random, rig_scale), place = some_place(random, scale);
        // The head turned about its joint, then the character was put somewhere.
        const BoneMatrix joint = moved(rest.m[0][3], rest.m[1][3], rest.m[2][3]);
        const BoneMatrix move = place * joint * turned(0.3, 1, -0.2, 0.1 * i);
        const BoneMatrix bone = move * moved(-rest.m[0][3], -rest.m[1][3], -rest.m[2][3]) * rest;
        const HeadPose pose = pose_of(in_floats(bone), {.rest = in_floats(rest)});
        EXPECT_LT(largest_difference(matrix_of(pose), move), 4e-6 * std::fmax(scale, 1)) << rig_scale << ' ' << scale;
        EXPECT_NEAR(pose.scale / scale, 1, 1e-6);
      }
    }
  }
}

TEST(HeadPoseOfBone, ABoneAtRestGivesAHeadThatIsNotTurned) {
  std::mt19937 random(2);
  const BoneMatrix rest = some_rest(random, 0.01);
  const HeadPose pose = pose_of(rest, {.rest = rest});
  EXPECT_LT(largest_difference(matrix_of(pose), moved(0, 1.6, 0.02)), 1e-7);
  EXPECT_EQ(pose.scale, 1.0f);
}

TEST(HeadPoseOfBone, EveryRotationIsFoundAlsoThoseByHalfATurn) {
  for (const double angle : {0.0, 1e-9, 1.0, 2.0, 3.14159265358979, -3.14159265358979, 3.1415926, 2.5}) {
    for (int axis = 0; axis < 27; ++axis) {
      if (axis == 13) continue;  // no axis
      const int x = axis / 9 - 1, y = axis / 3 % 3 - 1, z = axis % 3 - 1;
      const BoneMatrix turn = turned(x, y, z, angle);
      EXPECT_LT(largest_difference(matrix_of(pose_of(turn, {})), turn), 3e-7) << axis << ' ' << angle;
    }
  }
}

TEST(HeadPoseOfBone, WorldsOfOtherUnitsAreInMetresAfterwards) {
  std::mt19937 random(3);
  const BoneMatrix rest = some_rest(random, 1), move = some_place(random, 1.2);
  const HeadPose in_metres = pose_of(move * rest, {.rest = rest});
  // All lengths in centimetres: no scale anywhere, and translations are a hundred times as long.
  const BoneMatrix to_units = scaled(100), to_metres = scaled(0.01);
  const BoneMatrix bone = to_units * move * rest * to_metres, rest_in_units = to_units * rest * to_metres;
  const HeadPose pose = pose_of(bone, {.rest = rest_in_units, .metres_per_unit = 0.01});
  EXPECT_LT(largest_difference(matrix_of(pose), matrix_of(in_metres)), 1e-6);
}

TEST(HeadPoseOfBone, TheOriginOfHeadSpaceMayBeOffTheBone) {
  std::mt19937 random(4);
  const BoneMatrix rest = some_rest(random, 0.01), move = some_place(random, 1.3);
  const BoneMatrix joint = moved(0.01, 1.75, -0.03);  // of the asset
  const HeadBone head_bone{.rest = rest, .origin = {0.01, 0.15, -0.05}};
  const HeadPose pose = pose_of(move * rest, head_bone);
  EXPECT_LT(largest_difference(matrix_of(pose), move * joint), 1e-6);
  EXPECT_EQ(pose_of(rest, head_bone).position[1], 1.6 + 0.15);
}

TEST(HeadPoseOfBone, PositionsFarAwayKeepTheirDigits) {
  const double far_away[] = {1e7 + 0.125, -3e9 + 0.25, 0.1};
  const HeadPose pose = pose_of(moved(far_away[0], far_away[1], far_away[2]), {});
  for (int i = 0; i < 3; ++i) EXPECT_EQ(pose.position[i], far_away[i]);
}

TEST(HeadPoseOfBone, EnginesWithOtherAxesMultiplyBothMatrices) {
  std::mt19937 random(5);
  const BoneMatrix rest = some_rest(random, 1), move = some_place(random, 1);
  // Left-handed with Z up, in centimetres: asset's (x, y, z) is (-x, z, y) there; bones' own axes are mirrored as well.
  const BoneMatrix to_asset{{{-1, 0, 0, 0}, {0, 0, 1, 0}, {0, 1, 0, 0}}};
  BoneMatrix to_engine;
  ASSERT_EQ(invert(to_asset, to_engine), Status::kOk);
  const BoneMatrix own_axes = scaled(1, 1, -1);
  const BoneMatrix its_rest = to_engine * rest * own_axes, its_bone = to_engine * move * rest * own_axes;
  const HeadBone head_bone{.rest = to_asset * its_rest};
  EXPECT_FALSE(is_mirrored(to_asset * its_bone, head_bone));
  const HeadPose pose = pose_of(to_asset * its_bone, head_bone);
  EXPECT_LT(largest_difference(matrix_of(pose), matrix_of(pose_of(move * rest, {.rest = rest}))), 1e-6);

  // In the engine's own axes, where it is right-handed: Z up.
  const BoneMatrix up_to_asset{{{1, 0, 0, 0}, {0, 0, 1, 0}, {0, -1, 0, 0}}};
  BoneMatrix up;
  ASSERT_EQ(invert(up_to_asset, up), Status::kOk);
  const HeadPose in_engine = pose_of(up * move * rest, {.rest = up_to_asset * up * rest});
  EXPECT_LT(largest_difference(matrix_of(in_engine), up * matrix_of(pose_of(move * rest, {.rest = rest}))), 1e-6);
}

TEST(HeadPoseOfBone, AMirroredHeadKeepsItsTopAndItsFace) {
  std::mt19937 random(6);
  for (const BoneMatrix& mirror : {scaled(-1, 1, 1), scaled(1, -1, 1), scaled(1, 1, -1), scaled(-1)}) {
    const BoneMatrix rest = some_rest(random, 0.01), place = some_place(random, 1.25);
    const BoneMatrix bone = mirror * place * rest;
    EXPECT_TRUE(is_mirrored(bone, {.rest = rest}));
    EXPECT_FALSE(is_mirrored(place * rest, {.rest = rest}));
    const BoneMatrix head = mirror * place, found = matrix_of(pose_of(bone, {.rest = rest}));
    for (int i = 0; i < 3; ++i) {
      EXPECT_NEAR(found.m[i][0], -head.m[i][0], 1e-6);  // left and right
      EXPECT_NEAR(found.m[i][1], head.m[i][1], 1e-6);
      EXPECT_NEAR(found.m[i][2], head.m[i][2], 1e-6);
      EXPECT_NEAR(found.m[i][3], bone.m[i][3], 1e-6);
    }
    // The origin of head space is a place on the head, wherever left and right are.
    const HeadBone off{.rest = rest, .origin = {0.25, 0.5, -0.125}};
    const BoneMatrix there = head * moved(rest.m[0][3] + 0.25, rest.m[1][3] + 0.5, rest.m[2][3] - 0.125);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(pose_of(bone, off).position[i], there.m[i][3], 1e-6);
    // A rig whose own axes are mirrored, at rest and now, has no mirrored head.
    const HeadBone mirrored_rig{.rest = rest * mirror};
    EXPECT_FALSE(is_mirrored(place * rest * mirror, mirrored_rig));
    EXPECT_LT(largest_difference(matrix_of(pose_of(place * rest * mirror, mirrored_rig)),
                                 matrix_of(pose_of(place * rest, {.rest = rest}))),
              1e-6);
  }
}

TEST(HeadPoseOfBone, UnevenHeadsAreRefusedAboveTheTolerance) {
  const BoneMatrix shear{{{1, 1, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  const auto status_of = [](const BoneMatrix& bone, double tolerance) {
    HeadPose pose;
    return head_pose_of_bone(bone, {.largest_stretch = tolerance}, pose);
  };
  for (const double scale : {0.1, 1.0, 10.0}) {
    const auto stretched = [scale](double by) { return turned(1, 2, 3, 0.4) * scaled(scale, scale * (1 + by), scale); };
    EXPECT_EQ(status_of(stretched(0.014), 0.01), Status::kOk) << "0.0047 below and 0.0093 above the mean";
    EXPECT_EQ(status_of(stretched(0.016), 0.01), Status::kBadPose);
    EXPECT_EQ(status_of(stretched(-0.016), 0.01), Status::kBadPose);
    EXPECT_EQ(status_of(stretched(0.016), 0.02), Status::kOk);
    EXPECT_EQ(status_of(stretched(1e-3), 0), Status::kBadPose);
  }
  for (int i = 0; i < 3; ++i) {
    for (int k = 0; k < 3; ++k) {
      if (i == k) continue;
      BoneMatrix bone;
      bone.m[i][k] = 0.009;
      EXPECT_EQ(status_of(bone, 0.01), Status::kOk);
      bone.m[i][k] = -0.011;
      EXPECT_EQ(status_of(bone, 0.01), Status::kBadPose);
    }
  }
  EXPECT_EQ(status_of(shear, 0.7), Status::kBadPose);
  EXPECT_EQ(status_of(shear, kInfinity), Status::kOk);
}

TEST(HeadPoseOfBone, TheNearestRotationOfAnUnevenHeadIsTaken) {
  const BoneMatrix turn = turned(1, -2, 0.5, 2.2);
  const HeadBone any{.largest_stretch = kInfinity};
  for (const BoneMatrix& stretch : {scaled(1, 2, 0.5), scaled(1, 1, 0.001), scaled(3, 3, 0.1)}) {
    // turn * stretch has this polar factor, whatever axes the stretch has.
    const BoneMatrix axes = turned(0.2, 0.9, -0.4, 0.7), back = turned(0.2, 0.9, -0.4, -0.7);
    HeadPose pose = pose_of(turn * axes * stretch * back, any);
    double square = 0;
    for (int k = 0; k < 3; ++k) square += stretch.m[k][k] * stretch.m[k][k];
    EXPECT_NEAR(pose.scale, std::sqrt(square / 3), 1e-6);
    pose.scale = 1;
    EXPECT_LT(largest_difference(matrix_of(pose), turn), 1e-6);
  }
  HeadPose pose;
  EXPECT_EQ(head_pose_of_bone(scaled(1, 0, 1), any, pose), Status::kBadPose) << "flat";
  EXPECT_EQ(head_pose_of_bone(scaled(1, 1e-9, 1), any, pose), Status::kBadPose);
}

TEST(HeadPoseOfBone, ScalesOutOfRangeAreNamedAsSuch) {
  HeadPose pose;
  for (const double scale : {0.0, 0.01, 0.049, 20.1, 100.0, 1e20, 1e30, 1e-300}) {
    EXPECT_EQ(head_pose_of_bone(scaled(scale), {}, pose), Status::kBadScale) << scale;
  }
  EXPECT_EQ(head_pose_of_bone(scaled(0.05), {}, pose), Status::kOk);
  EXPECT_EQ(pose.scale, kSmallestScale);
  EXPECT_EQ(head_pose_of_bone(scaled(20), {}, pose), Status::kOk);
  EXPECT_EQ(pose.scale, kLargestScale);
  EXPECT_EQ(head_pose_of_bone(scaled(1), {.rest = scaled(0.01)}, pose), Status::kBadScale);
  EXPECT_EQ(head_pose_of_bone(scaled(0.01), {.rest = scaled(0.01)}, pose), Status::kOk);
}

/// A pose with bytes that nobody else writes.
HeadPose marked() {
  HeadPose pose{{3, 4, 5}, {0.5f, 0.5f, 0.5f, 0.5f}, 7, 8};
  return pose;
}

TEST(HeadPoseOfBone, BadNumbersGiveAStatusAndChangeNothing) {
  const auto refused = [](const BoneMatrix& bone, const HeadBone& head_bone) {
    HeadPose pose = marked();
    const HeadPose before = marked();
    const Status status = head_pose_of_bone(bone, head_bone, pose);
    EXPECT_EQ(std::memcmp(&pose, &before, sizeof pose), 0);
    return status;
  };
  for (const double bad : {kNan, kInfinity, -kInfinity}) {
    for (int i = 0; i < 12; ++i) {
      BoneMatrix matrix, inverse = scaled(3);
      matrix.m[i / 4][i % 4] = bad;
      EXPECT_EQ(refused(matrix, {}), Status::kBadPose) << i;
      EXPECT_EQ(refused({}, {.rest = matrix}), Status::kBadArgument) << i;
      EXPECT_FALSE(is_mirrored(matrix, {}));
      EXPECT_FALSE(is_mirrored({}, {.rest = matrix}));
      EXPECT_EQ(invert(matrix, inverse), Status::kBadArgument);
      EXPECT_EQ(inverse.m[0][0], 3);
    }
    for (int i = 0; i < 3; ++i) {
      HeadBone head_bone;
      head_bone.origin[i] = bad;
      EXPECT_EQ(refused({}, head_bone), Status::kBadArgument);
    }
    EXPECT_EQ(refused({}, {.metres_per_unit = bad}), Status::kBadArgument);
  }
  for (const double unit : {0.0, -1.0}) EXPECT_EQ(refused({}, {.metres_per_unit = unit}), Status::kBadArgument);
  for (const double stretch : {-0.01, kNan}) EXPECT_EQ(refused({}, {.largest_stretch = stretch}), Status::kBadArgument);
  for (const BoneMatrix& flat : {scaled(0), scaled(1, 1, 0), scaled(1e-31), scaled(1e31)}) {
    EXPECT_EQ(refused({}, {.rest = flat}), Status::kBadArgument);
    BoneMatrix inverse;
    EXPECT_EQ(invert(flat, inverse), Status::kBadArgument);
  }
  EXPECT_EQ(refused(scaled(0.01), {}), Status::kBadScale);
  EXPECT_EQ(refused(scaled(1, 2, 1), {}), Status::kBadPose);
  EXPECT_EQ(refused(moved(0, 1.1e30, 0), {}), Status::kBadPose);
  EXPECT_EQ(refused({}, {.metres_per_unit = 1e300}), Status::kBadArgument);
}

TEST(HeadPoseOfBone, MatricesAreReadInEitherOrder) {
  const float columns[16] = {1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0, 10, 11, 12, 1};
  const double rows[12] = {1, 4, 7, 10, 2, 5, 8, 11, 3, 6, 9, 12};
  EXPECT_EQ(largest_difference(bone_matrix_of_columns(columns), bone_matrix_of_rows(rows)), 0);
  EXPECT_EQ(bone_matrix_of_columns(columns).m[0][3], 10);
  EXPECT_EQ(bone_matrix_of_rows(rows).m[2][1], 6);
}

TEST(HeadPoseOfBone, InverseBindMatricesGiveTheRest) {
  std::mt19937 random(7);
  for (int i = 0; i < 20; ++i) {
    const BoneMatrix rest = some_rest(random, i % 2 == 0 ? 1 : 0.01);
    BoneMatrix inverse, again;
    ASSERT_EQ(invert(rest, inverse), Status::kOk);
    EXPECT_LT(largest_difference(inverse * rest, {}), 1e-12);
    ASSERT_EQ(invert(inverse, again), Status::kOk);
    EXPECT_LT(largest_difference(again, rest), 1e-12);
  }
}

TEST(HeadPoseOfBone, NothingTrapsWhereTheHostLetsExceptionsTrap) {
#if defined(__GLIBC__)
  if (feenableexcept(FE_INVALID) == -1) GTEST_SKIP() << "this processor does not trap";
  (void)feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
  std::vector<Status> statuses;
  for (const double number : {kNan, kInfinity, 0.0, 1e-300, 1e29, 1e100, 1e300, 1.0}) {
    HeadPose pose;
    statuses.push_back(head_pose_of_bone(scaled(number), {.largest_stretch = kInfinity}, pose));
    statuses.push_back(head_pose_of_bone({}, {.rest = scaled(number, number, 1)}, pose));
    statuses.push_back(head_pose_of_bone(scaled(1, 0, 1), {.largest_stretch = number}, pose));
    statuses.push_back(head_pose_of_bone(moved(number, 0, 0), {.metres_per_unit = number}, pose));
    BoneMatrix inverse;
    statuses.push_back(invert(scaled(number), inverse));
  }
  (void)fedisableexcept(FE_ALL_EXCEPT);
  EXPECT_EQ(statuses.back(), Status::kOk);
#else
  GTEST_SKIP() << "no way to let exceptions trap";
#endif
}

}  // namespace coif::head_bone_test
