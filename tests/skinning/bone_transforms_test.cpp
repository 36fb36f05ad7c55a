// Bones relative to their parents: what an engine's own skeleton makes of them is the palette again.
#include <coif/bone_transforms.h>
#include <coif/hair.h>

#include "models/skinned_asset.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace coif::bone_transforms_test {

struct Opened {
  explicit Opened(std::span<const std::byte> file) : bytes(file) { EXPECT_TRUE(asset.open(bytes.bytes())); }

  AlignedBytes bytes;
  Asset asset;
};

/// The nodes of a host: each has its parent's transform times its own, in single precision as hosts have it.
std::vector<Mat34> composed(const Asset& asset, std::span<const BoneTransform> local) {
  std::vector<Mat34> nodes(local.size());
  for (std::size_t b = 0; b < local.size(); ++b) {
    const Quat& q = local[b].rotation;
    const Vec3& t = local[b].translation;
    const Mat34 own{{{1 - 2 * (q.y * q.y + q.z * q.z), 2 * (q.x * q.y - q.w * q.z), 2 * (q.x * q.z + q.w * q.y), t.x},
                     {2 * (q.x * q.y + q.w * q.z), 1 - 2 * (q.x * q.x + q.z * q.z), 2 * (q.y * q.z - q.w * q.x), t.y},
                     {2 * (q.x * q.z - q.w * q.y), 2 * (q.y * q.z + q.w * q.x), 1 - 2 * (q.x * q.x + q.y * q.y), t.z}}};
    const std::uint32_t parent = asset.bones()[b].parent;
    const Mat34 above = parent == kNone ? Mat34{} : nodes[parent];
    for (int i = 0; i < 3; ++i) {
      for (int k = 0; k < 4; ++k) {
        nodes[b].m[i][k] = k == 3 ? above.m[i][3] : 0;
        for (int j = 0; j < 3; ++j) nodes[b].m[i][k] += above.m[i][j] * own.m[j][k];
      }
    }
  }
  return nodes;
}

/// Largest difference of bone b's matrix in the palette from what its node makes of it by the inverse bind matrix that
/// the header names.
double difference(const Asset& asset, std::size_t b, const Mat34& node, const Mat34& matrix) {
  const float(&joint)[3] = asset.bones()[b].joint;
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    const float(&row)[4] = node.m[i];
    const double place = double(row[3]) - double(row[0]) * double(joint[0]) - double(row[1]) * double(joint[1]) -
                         double(row[2]) * double(joint[2]);
    most = std::max(most, std::fabs(place - double(matrix.m[i][3])));
    for (int k = 0; k < 3; ++k) most = std::max(most, std::fabs(double(row[k]) - double(matrix.m[i][k])));
  }
  return most;
}
double worst(const Asset& asset, std::span<const Mat34> nodes, std::span<const Mat34> palette) {
  double most = 0;
  for (std::size_t b = 0; b < nodes.size(); ++b) most = std::max(most, difference(asset, b, nodes[b], palette[b]));
  return most;
}

/// How far a bone's joint is from where the palette has it, metres.
double joint_off(const Asset& asset, std::size_t b, const Mat34& node, const Mat34& matrix) {
  const float(&joint)[3] = asset.bones()[b].joint;
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    const float(&row)[4] = matrix.m[i];
    const double place = double(row[3]) + double(row[0]) * double(joint[0]) + double(row[1]) * double(joint[1]) +
                         double(row[2]) * double(joint[2]);
    most = std::max(most, std::fabs(place - double(node.m[i][3])));
  }
  return most;
}

/// How far a matrix is from being a rotation: nothing made of rotations comes nearer to it.
double not_a_turn(const Mat34& matrix) {
  double most = 0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double product = i == j ? -1 : 0;
      for (int k = 0; k < 3; ++k) product += double(matrix.m[i][k]) * double(matrix.m[j][k]);
      most = std::max(most, std::fabs(product));
    }
  }
  return most;
}

double length(const Vec3& v) { return std::hypot(double(v.x), double(v.y), double(v.z)); }

class BoneTransforms : public testing::Test {
 protected:
  /// Simulates a head that nods by up to `most` radians, and calls look(palette) after each of 60 frames.
  template <typename Look>
  static void nod(const Asset& asset, float most, const Look& look) {
    AlignedBytes memory(std::vector<std::byte>(Hair::memory_need(asset, {}).bytes));
    Hair hair;
    ASSERT_EQ(hair.create(asset, {}, memory.bytes()), Status::kOk);
    for (int frame = 1; frame <= 60; ++frame) {
      const float angle = most * std::sin(0.15f * float(frame));
      HeadPose pose;
      pose.rotation = {std::sin(angle / 2), 0, 0, std::cos(angle / 2)};
      pose.position[1] = 0.1 * double(most) * std::sin(0.3 * frame);
      ASSERT_EQ(hair.set_head(0, pose), Status::kOk);
      ASSERT_EQ(hair.step({}), Status::kOk);
      look(hair.palette(0));
    }
  }
};

/// A random rotation that carries the joint to a place.
Mat34 turned_about(const float (&joint)[3], const double (&to)[3], std::mt19937& random) {
  const auto number = [&] { return double(random() % 2001) / 1000 - 1; };
  double q[4] = {number(), number(), number(), number()};
  const double size = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]) + 1e-9;
  for (double& part : q) part /= size;
  const auto [x, y, z, w] = q;
  const double m[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  Mat34 matrix;
  for (int i = 0; i < 3; ++i) {
    double place = to[i];
    for (int k = 0; k < 3; ++k) {
      matrix.m[i][k] = float(m[i][k]);
      place -= m[i][k] * double(joint[k]);
    }
    matrix.m[i][3] = float(place);
  }
  return matrix;
}

TEST_F(BoneTransforms, ComposedAlongParentsAreThePaletteAgain) {
  const Opened wig(made_up_wig({.strips = 12, .bones_per_chain = 4, .texture_size = 32}));
  const std::span<const BoneRecord> bones = wig.asset.bones();
  std::vector<BoneTransform> local(bones.size());
  std::mt19937 random(11);
  double most = 0;
  for (int i = 0; i < 100; ++i) {
    std::vector<Mat34> palette(bones.size());
    for (std::size_t b = 0; b < bones.size(); ++b) {
      const auto place = [&](int k) { return double(bones[b].joint[k]) + double(random() % 200) / 1000 - 0.1; };
      palette[b] = turned_about(bones[b].joint, {place(0), place(1), place(2)}, random);
    }
    ASSERT_EQ(bone_transforms(wig.asset, palette, local), Status::kOk);
    most = std::max(most, worst(wig.asset, composed(wig.asset, local), palette));
    for (const BoneTransform& bone : local) EXPECT_GE(bone.rotation.w, 0);
  }
  EXPECT_LT(most, 1e-6);
}

// Frames that the solvers carry along are rotations to five or six digits.
TEST_F(BoneTransforms, OfSimulatedHairAreThePaletteAsFarAsThatTurns) {
  const Opened wig(made_up_wig({.strips = 12, .bones_per_chain = 4, .texture_size = 32}));
  std::vector<BoneTransform> local(wig.asset.bones().size());
  double turned = 0;
  for (const float amplitude : {0.5f, 3.0f}) {
    nod(wig.asset, amplitude, [&](std::span<const Mat34> palette) {
      ASSERT_EQ(bone_transforms(wig.asset, palette, local), Status::kOk);
      const std::vector<Mat34> nodes = composed(wig.asset, local);
      for (std::size_t b = 0; b < nodes.size(); ++b) {
        EXPECT_LT(difference(wig.asset, b, nodes[b], palette[b]), 1e-6 + not_a_turn(palette[b])) << b;
        EXPECT_LT(joint_off(wig.asset, b, nodes[b], palette[b]), 1e-6) << b;
        turned = std::max(turned, std::acos(std::min(1.0, double(local[b].rotation.w))));
      }
    });
  }
  EXPECT_GT(turned, 0.1) << "hardly a bone turned: little was tested";
}

TEST_F(BoneTransforms, KeepTheBonesLengthsInAnyMotion) {
  const Opened wig(made_up_wig({.strips = 12, .bones_per_chain = 5, .texture_size = 32}));
  const std::span<const BoneRecord> bones = wig.asset.bones();
  std::vector<BoneTransform> local(bones.size());
  nod(wig.asset, 3, [&](std::span<const Mat34> palette) {
    ASSERT_EQ(bone_transforms(wig.asset, palette, local), Status::kOk);
    for (std::size_t b = 1; b < bones.size(); ++b) {
      const float *own = bones[b].joint, *above = bones[bones[b].parent].joint;
      EXPECT_NEAR(length(local[b].translation), length({own[0] - above[0], own[1] - above[1], own[2] - above[2]}),
                  1e-6);
    }
  });
}

TEST_F(BoneTransforms, OfARestingPaletteAreTheBindPose) {
  const Opened small(write_asset(small_asset()));
  const std::span<const BoneRecord> bones = small.asset.bones();
  std::vector<BoneTransform> local(bones.size());
  ASSERT_EQ(bone_transforms(small.asset, std::vector<Mat34>(bones.size()), local), Status::kOk);
  for (std::size_t b = 0; b < bones.size(); ++b) {
    EXPECT_EQ(local[b].rotation.w, 1);
    const float above = b == 0 ? 0 : bones[bones[b].parent].joint[1];
    EXPECT_FLOAT_EQ(local[b].translation.y, bones[b].joint[1] - above);
  }
}

TEST_F(BoneTransforms, FollowHalfATurnAboutAnyAxis) {
  const Opened asset(write_asset(skinned_contents(2, std::vector<SkinRecord>(30, {{1, 0, 0, 0}, {255, 0, 0, 0}}))));
  std::mt19937 random(5);
  std::vector<BoneTransform> local(2);
  for (int i = 0; i < 200; ++i) {
    const auto number = [&] { return double(random() % 2001) / 1000 - 1; };
    double axis[3] = {number(), number(), number()};
    const double size = std::hypot(axis[0], axis[1], axis[2]);
    if (size < 0.1) continue;
    Mat34 half_turn;  // 2 a a' - 1
    for (int r = 0; r < 3; ++r) {
      for (int c = 0; c < 3; ++c) half_turn.m[r][c] = float(2 * axis[r] * axis[c] / (size * size) - (r == c ? 1 : 0));
    }
    const std::vector<Mat34> palette{{}, half_turn};
    ASSERT_EQ(bone_transforms(asset.asset, palette, local), Status::kOk);
    EXPECT_LT(worst(asset.asset, composed(asset.asset, local), palette), 1e-6);
  }
}

TEST_F(BoneTransforms, RefuseWhatDoesNotFitAndChangeNothing) {
  const Opened small(write_asset(small_asset()));
  const std::size_t bones = small.asset.bones().size();
  std::vector<BoneTransform> local(bones, {{1, 2, 3}, {}});
  const std::vector<Mat34> palette(bones);
  EXPECT_EQ(bone_transforms(Asset(), palette, local), Status::kAssetLacksData);
  EXPECT_EQ(bone_transforms(small.asset, std::span(palette).first(bones - 1), local), Status::kSizeMismatch);
  EXPECT_EQ(bone_transforms(small.asset, palette, std::span(local).first(bones - 1)), Status::kSizeMismatch);
  EXPECT_EQ(local[0].translation.z, 3);
}

}  // namespace coif::bone_transforms_test
