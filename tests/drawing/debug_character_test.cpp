// Lines of what a character brings along: limits of directions, colliders of the game and on the body.

#include "models/drawn_card.h"
#include "models/small_asset.h"

#include <coif/debug_lines.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace coif::debug_character_test {

using Point = std::array<double, 3>;

struct Lines {
  std::vector<DebugLine> lines;

  DebugLines sink() {
    return {[](const DebugLine& line, void* user) { static_cast<Lines*>(user)->lines.push_back(line); }, this};
  }
  [[nodiscard]] std::vector<Point> points() const {
    std::vector<Point> all;
    for (const DebugLine& line : lines) {
      all.push_back(std::to_array(line.from));
      all.push_back(std::to_array(line.to));
    }
    return all;
  }
};

constexpr float kHalfRoot = 0.70710678f;

/// Directions, in the limit's own axes, of all points but the bone's start. The bone `hair_2` starts at (0, -0.05, 0);
/// its limit's y points down and its z to -X.
std::vector<Point> directions(LimitKind kind, float first, float second) {
  AssetContents contents = small_asset();
  contents.limits.assign(contents.bones.size(), {LimitKind::kUnlimited, {}, 0, {0, 0, 0, 1}});
  contents.limits[3] = {kind, {first, second}, 0, {kHalfRoot, 0, kHalfRoot, 0}};
  const DrawnAsset asset(contents);
  const std::vector<Mat34> palette(contents.bones.size());
  Lines found;
  EXPECT_EQ(draw_limit_lines(*asset, {.head = {}, .palette = palette}, found.sink()), Status::kOk);
  std::vector<Point> all;
  for (const DebugLine& line : found.lines) EXPECT_EQ(line.index, 3u);
  for (const Point& p : found.points()) {
    const double x = p[0], y = p[1] + 0.05, z = p[2], length = std::hypot(x, y, z);
    if (length < 1e-6) continue;
    EXPECT_NEAR(length, 0.1, 1e-6) << "as long as the bone";
    // The quaternion above turns x to z, y to -y and z to x.
    all.push_back({z / length, -y / length, x / length});
  }
  EXPECT_FALSE(all.empty());
  return all;
}

TEST(DebugLimits, OfACone) {
  for (const Point& d : directions(LimitKind::kCone, 0.7f, 0)) EXPECT_NEAR(d[1], std::cos(0.7), 1e-5);
}

TEST(DebugLimits, OfAHingeStayInItsPlane) {
  double widest = 0;
  for (const Point& d : directions(LimitKind::kHinge, 0.7f, 0)) {
    EXPECT_NEAR(d[0], 0, 1e-5);
    EXPECT_GE(d[1], std::cos(0.7) - 1e-5);
    widest = std::max(widest, std::acos(d[1]));
  }
  EXPECT_NEAR(widest, 0.7, 1e-4);
}

TEST(DebugLimits, OfASphericalLimitAreTheBorderOfPitchAndYaw) {
  bool is_pitch_reached = false, is_yaw_reached = false;
  for (const Point& d : directions(LimitKind::kSpherical, 0.7f, 0.3f)) {
    const double yaw = std::fabs(std::asin(d[0])), pitch = std::fabs(std::atan2(d[2], d[1]));
    EXPECT_LE(yaw, 0.3 + 1e-5);
    EXPECT_LE(pitch, 0.7 + 1e-5);
    EXPECT_TRUE(std::fabs(yaw - 0.3) < 1e-4 || std::fabs(pitch - 0.7) < 1e-4) << yaw << " " << pitch;
    is_pitch_reached |= std::fabs(pitch - 0.7) < 1e-4 && yaw < 0.1;
    is_yaw_reached |= std::fabs(yaw - 0.3) < 1e-4 && pitch < 0.1;
  }
  EXPECT_TRUE(is_pitch_reached && is_yaw_reached);
}

HeadPose turned_head() {
  HeadPose head;
  head.position[0] = 1000;
  head.position[1] = 2;
  head.rotation = {0.5f, 0.5f, 0.5f, 0.5f};
  head.scale = 2;
  return head;
}

TEST(DebugMovingColliders, AreDrawnWhereTheyAreInTheWorldWhateverTheHeadsPose) {
  const HeadPose head = turned_head();
  const MovingCollider ball{.shape = ColliderShape::kSphere, .center = {1000.5, 2.25, -1}, .radius = 0.3f};
  const MovingCollider box{.shape = ColliderShape::kBox,
                           .center = {999, 2, 0},
                           .rotation = {0, 0, kHalfRoot, kHalfRoot},
                           .half_extents = {0.1f, 0.2f, 0.3f}};
  const MovingCollider capsule{.shape = ColliderShape::kCapsule,
                               .center = {1000, 3, 0},
                               .rotation = {0, 0, kHalfRoot, kHalfRoot},
                               .axis = {0, 0.5f, 0},
                               .radius = 0.1f};
  const auto drawn = [&](const MovingCollider& collider) {
    const DebugCollider own = debug_collider(collider, head);
    Lines found;
    EXPECT_EQ(draw_collider_lines({&own, 1}, head, found.sink()), Status::kOk);
    return found.points();
  };
  for (const Point& p : drawn(ball)) EXPECT_NEAR(std::hypot(p[0] - 1000.5, p[1] - 2.25, p[2] + 1), 0.3, 1e-5);
  for (const Point& p : drawn(box)) {  // a quarter turn about z: x and y change places
    EXPECT_NEAR(std::fabs(p[0] - 999), 0.2, 1e-5);
    EXPECT_NEAR(std::fabs(p[1] - 2), 0.1, 1e-5);
    EXPECT_NEAR(std::fabs(p[2]), 0.3, 1e-5);
  }
  double least = 2000, most = 0;
  for (const Point& p : drawn(capsule)) least = std::min(least, p[0]), most = std::max(most, p[0]);
  EXPECT_NEAR(most, 1000.1, 1e-3) << "but for the arc's corners";
  EXPECT_NEAR(least, 999.4, 1e-3) << "its y points to -X";
}

TEST(DebugMovingColliders, ARoundedBoxIsAsLargeAsItCollides) {
  const MovingCollider box{.shape = ColliderShape::kBox, .radius = 0.05f, .half_extents = {0.1f, 0.1f, 0.1f}};
  const DebugCollider own = debug_collider(box, {});
  Lines found;
  ASSERT_EQ(draw_collider_lines({&own, 1}, {}, found.sink()), Status::kOk);
  for (const Point& p : found.points()) EXPECT_NEAR(std::fabs(p[0]), 0.15, 1e-6);
}

TEST(DebugBodyColliders, FollowTheirBones) {
  AssetContents contents = small_asset();
  ASSERT_FALSE(contents.body_colliders.empty());
  const DrawnAsset asset(contents);
  const HeadPose head = turned_head();
  for (std::uint32_t i = 0; i < (*asset).body_colliders().size(); ++i) {
    const ColliderRecord& record = (*asset).body_colliders()[i];
    const BodyBoneRecord& rest = (*asset).body_bones()[record.bone];
    // At rest under a head at the identity: where the record has it.
    const Quat own{rest.rotation[0], rest.rotation[1], rest.rotation[2], rest.rotation[3]};
    BodyPose bone{{double(rest.joint[0]), double(rest.joint[1]), double(rest.joint[2])}, own};
    const DebugCollider resting = debug_body_collider(*asset, i, bone, {});
    EXPECT_NEAR(resting.center.x, record.center[0], 1e-6f);
    EXPECT_NEAR(resting.center.y, record.center[1], 1e-6f);
    EXPECT_NEAR(resting.axis.y, record.axis[1], 1e-6f);
    EXPECT_NEAR(std::fabs(resting.rotation.w), std::fabs(record.rotation[3]), 1e-6f);
    // The bone goes up by a metre: so does what is drawn, of whatever head.
    Lines before, after;
    ASSERT_EQ(draw_collider_lines(std::array{debug_body_collider(*asset, i, bone, head)}, head, before.sink()),
              Status::kOk);
    bone.position[1] += 1;
    ASSERT_EQ(draw_collider_lines(std::array{debug_body_collider(*asset, i, bone, head)}, head, after.sink()),
              Status::kOk);
    for (std::size_t k = 0; k < before.points().size(); ++k) {
      EXPECT_NEAR(after.points()[k][1], before.points()[k][1] + 1, 1e-4);
      EXPECT_NEAR(after.points()[k][0], before.points()[k][0], 1e-4);
    }
  }
}

}  // namespace coif::debug_character_test
