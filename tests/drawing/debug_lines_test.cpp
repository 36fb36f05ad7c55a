// Lines of bones, limits, colliders and contacts, handed to the host.

#include "models/drawn_card.h"
#include "models/skinned_asset.h"
#include "models/small_asset.h"

#include <coif/debug_lines.h>
#include <coif/hair.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>
#include <vector>

namespace coif::debug_lines_test {

using Kind = DebugLine::Kind;
using Point = std::array<double, 3>;

/// Keeps what it is handed.
struct Collected {
  std::vector<DebugLine> lines;

  static void add(const DebugLine& line, void* user) { static_cast<Collected*>(user)->lines.push_back(line); }
  DebugLines sink() { return {add, this}; }

  [[nodiscard]] std::vector<Point> points() const {
    std::vector<Point> all;
    for (const DebugLine& line : lines) {
      all.push_back(std::to_array(line.from));
      all.push_back(std::to_array(line.to));
    }
    return all;
  }
  [[nodiscard]] std::set<std::uint32_t> indices() const {
    std::set<std::uint32_t> all;
    for (const DebugLine& line : lines) all.insert(line.index);
    return all;
  }
};

double apart(const Point& a, const Point& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

struct Bone {
  Point from, to;
};

TEST(DebugLines, OfBonesEndWhereTheirParticlesAre) {
  const DrawnAsset wig(made_up_wig({.strips = 8, .texture_size = 32}));
  struct alignas(64) Block {
    std::byte bytes[64];
  };
  std::vector<Block> memory(Hair::memory_need(*wig, {}).bytes / sizeof(Block) + 1);
  Hair hair;
  ASSERT_EQ(hair.create(*wig, {}, std::as_writable_bytes(std::span(memory))), Status::kOk);
  for (int frame = 1; frame <= 10; ++frame) {
    HeadPose pose;
    pose.position[0] = 0.05 * frame;
    ASSERT_EQ(hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(hair.step({}), Status::kOk);
  }
  const std::span<const BoneRecord> bones = (*wig).bones();
  std::vector<Vec3> ends(bones.size());
  ASSERT_EQ(hair.bone_ends(0, ends), Status::kOk);
  HairInstance instance{.head = {}, .palette = hair.palette(0)};
  instance.head.position[1] = 100;
  instance.head.rotation = {0, 1, 0, 0};  // half a turn: x and z are reversed
  instance.head.scale = 2;
  Collected found;
  ASSERT_EQ(draw_bone_lines(*wig, instance, found.sink()), Status::kOk);
  ASSERT_EQ(found.lines.size(), bones.size() - 1);
  for (const DebugLine& line : found.lines) {
    const Vec3& end = ends[line.index];
    EXPECT_EQ(line.kind, bones[line.index].kind == BoneKind::kSimulated ? Kind::kBone : Kind::kRigidBone);
    EXPECT_LT(apart(std::to_array(line.to), {-2.0 * double(end.x), 100 + 2.0 * double(end.y), -2.0 * double(end.z)}),
              1e-6);
    if (line.kind == Kind::kBone) {
      EXPECT_NEAR(apart(std::to_array(line.from), std::to_array(line.to)), 2 * double(bones[line.index].length), 1e-5);
    }
  }
}

TEST(DebugLines, OfLimitsAreTheConeThatABoneMayReach) {
  constexpr float kLimit = 0.5f;
  AssetContents contents = small_asset();
  contents.limits.clear();
  contents.dynamics[3].angle_limit = kLimit;
  const DrawnAsset asset(contents);
  std::vector<Mat34> palette(contents.bones.size());
  // The parent points to -X instead of down, about its own start; the bone itself bends further.
  palette[2] = {{{0, 1, 0, -0.05f}, {-1, 0, 0, 0.05f}, {0, 0, 1, 0}}};
  palette[3] = palette[2];
  Collected found;
  ASSERT_EQ(draw_limit_lines(*asset, {.head = {}, .palette = palette}, found.sink()), Status::kOk);
  EXPECT_EQ(found.indices(), std::set<std::uint32_t>{3}) << "the others have none";
  const Point start{-0.1, 0.05, 0};  // the parent's end
  int at_start = 0;
  for (const Point& p : found.points()) {
    const double distance = apart(p, start);
    if (distance < 1e-6) {
      ++at_start;
      continue;
    }
    EXPECT_NEAR(distance, 0.1, 1e-6) << "the bone's length";
    EXPECT_NEAR(std::acos((start[0] - p[0]) / distance), double(kLimit), 1e-4);
  }
  EXPECT_EQ(at_start, 4);
}

/// Distance from the hull of two balls, by looking at many between them.
double from_hull(const Point& p, const Vec3& center, const Vec3& axis, double first, double last) {
  double least = 9;
  for (int i = 0; i <= 4000; ++i) {
    const double s = i / 4000.0;
    const Point c{double(center.x) + s * double(axis.x), double(center.y) + s * double(axis.y),
                  double(center.z) + s * double(axis.z)};
    least = std::min(least, apart(p, c) - (first + s * (last - first)));
  }
  return least;
}

TEST(DebugLines, OfCollidersLieOnTheirSurfaces) {
  const Vec3 center{0.1f, -0.2f, 0.3f}, axis{0.1f, 0.2f, -0.05f};
  const Quat turn{0.5f, 0.5f, 0.5f, 0.5f};  // x to y, y to z, z to x
  struct Case {
    const char* what;
    DebugCollider collider;
    double (*off)(const DebugCollider& c, const Point& p);
  };
  const auto ball = [](const DebugCollider& c, const Point& p) {
    return from_hull(p, c.center, {}, double(c.radii.x), double(c.radii.x));
  };
  const auto capsule = [](const DebugCollider& c, const Point& p) {
    const bool is_tapered = c.shape == ColliderShape::kTaperedCapsule;
    return from_hull(p, c.center, c.axis, double(c.radii.x), double(is_tapered ? c.radii.y : c.radii.x));
  };
  const auto ellipsoid = [](const DebugCollider& c, const Point& p) {
    const double x = p[1] - double(c.center.y), y = p[2] - double(c.center.z), z = p[0] - double(c.center.x);
    return std::hypot(x / double(c.radii.x), y / double(c.radii.y), z / double(c.radii.z)) - 1;
  };
  const auto box = [](const DebugCollider& c, const Point& p) {  // a corner
    const double x = p[1] - double(c.center.y), y = p[2] - double(c.center.z), z = p[0] - double(c.center.x);
    return std::fabs(std::fabs(x) - double(c.half_extents.x)) + std::fabs(std::fabs(y) - double(c.half_extents.y)) +
           std::fabs(std::fabs(z) - double(c.half_extents.z));
  };
  const Case cases[] = {
      {"sphere", {.center = center, .radii = {0.1f, 0.1f, 0.1f}}, ball},
      {"ellipsoid",
       {.shape = ColliderShape::kEllipsoid, .center = center, .radii = {0.1f, 0.2f, 0.3f}, .rotation = turn},
       ellipsoid},
      {"capsule",
       {.shape = ColliderShape::kCapsule, .center = center, .axis = axis, .radii = {0.1f, 0.1f, 0.1f}},
       capsule},
      {"tapered",
       {.shape = ColliderShape::kTaperedCapsule, .center = center, .axis = axis, .radii = {0.1f, 0.03f, 0}},
       capsule},
      {"tapered the other way",
       {.shape = ColliderShape::kTaperedCapsule, .center = center, .axis = axis, .radii = {0.02f, 0.12f, 0}},
       capsule},
      {"box",
       {.shape = ColliderShape::kBox, .center = center, .rotation = turn, .half_extents = {0.1f, 0.2f, 0.3f}},
       box}};
  for (const Case& one : cases) {
    Collected found;
    ASSERT_EQ(draw_collider_lines({&one.collider, 1}, {}, found.sink(), 7), Status::kOk);
    EXPECT_GE(found.lines.size(), 12u) << one.what;
    EXPECT_EQ(found.indices(), std::set<std::uint32_t>{7}) << one.what;
    for (const Point& p : found.points()) EXPECT_NEAR(one.off(one.collider, p), 0, 1e-5) << one.what;
  }
}

TEST(DebugLines, OfAnAssetsCollidersHaveTheirNumbers) {
  const DrawnAsset asset(small_asset());
  HeadPose head;
  head.position[2] = 5;
  head.scale = 3;
  Collected found;
  ASSERT_EQ(draw_collider_lines(*asset, head, found.sink()), Status::kOk);
  EXPECT_EQ(found.indices(), (std::set<std::uint32_t>{0, 1, 2, 3}));
  double highest = 0;
  for (const DebugLine& line : found.lines) {
    EXPECT_EQ(line.kind, Kind::kCollider);
    if (line.index == 0) highest = std::max(highest, line.from[1]);
  }
  EXPECT_NEAR(highest, 3 * 0.12, 1e-6) << "the ellipsoid's height times the scale";
}

class Contacts : public testing::Test {
 protected:
  /// One bone hangs from (0, 0, 0) to (0, -0.1, 0); nothing of the asset's is near.
  Contacts() : contents_(small_asset()) {
    contents_.colliders.clear();
    for (BoneRecord& bone : contents_.bones) bone.colliders = 0;
    asset_.emplace(contents_);
  }

  /// Where the bone `fringe` touches it.
  std::vector<DebugLine> with(const DebugCollider& collider, float tolerance = 1e-3f) {
    const std::vector<Mat34> palette(contents_.bones.size());
    Collected found;
    EXPECT_EQ(draw_contact_lines(**asset_, {.head = {}, .palette = palette}, found.sink(), {&collider, 1}, tolerance),
              Status::kOk);
    std::erase_if(found.lines, [](const DebugLine& line) { return line.index != 4; });
    return found.lines;
  }

  static constexpr float kHit = 0.005f;  // of small_asset()'s bones
  AssetContents contents_;
  std::optional<DrawnAsset> asset_;
};

TEST_F(Contacts, AreWhereABoneIsAsNearAsItsHitRadius) {
  for (const float gap : {0.0f, 0.9e-3f, 1.1e-3f}) {
    const auto beside = with({.center = {0.03f + kHit + gap, -0.06f, 0}, .radii = {0.03f, 0.03f, 0.03f}});
    EXPECT_EQ(beside.empty(), gap > 1e-3f) << gap;
    if (beside.empty()) continue;
    ASSERT_EQ(beside.size(), 3u) << "a cross and a normal";
    EXPECT_LT(apart(std::to_array(beside[2].from), {double(kHit + gap), -0.06, 0}), 1e-4) << "on the ball's surface";
    EXPECT_LT(beside[2].to[0], beside[2].from[0]) << "towards the bone";
  }
  EXPECT_FALSE(with({.center = {0.05f, -0.06f, 0}, .radii = {0.03f, 0.03f, 0.03f}}, 0.016f).empty());
}

TEST_F(Contacts, AreFoundAtEveryShape) {
  const float side = 0.03f + kHit;
  const Vec3 beside{side, -0.06f, 0};
  EXPECT_FALSE(with({.shape = ColliderShape::kEllipsoid, .center = beside, .radii = {0.03f, 0.1f, 0.02f}}).empty());
  EXPECT_TRUE(with({.shape = ColliderShape::kEllipsoid, .center = beside, .radii = {0.02f, 0.1f, 0.03f}}).empty());
  const Vec3 along{0, 0, 0.4f};
  EXPECT_FALSE(with({.shape = ColliderShape::kCapsule,
                     .center = {side, -0.06f, -0.2f},
                     .axis = along,
                     .radii = {0.03f, 0.03f, 0.03f}})
                   .empty());
  EXPECT_TRUE(with({.shape = ColliderShape::kCapsule,
                    .center = {side, -0.06f, 0.2f},
                    .axis = along,
                    .radii = {0.03f, 0.03f, 0.03f}})
                  .empty());
  EXPECT_FALSE(with({.shape = ColliderShape::kTaperedCapsule,
                     .center = {side, -0.06f, 0},
                     .axis = along,
                     .radii = {0.03f, 0.01f, 0}})
                   .empty());
  EXPECT_TRUE(with({.shape = ColliderShape::kTaperedCapsule,
                    .center = {side, -0.06f, -0.4f},
                    .axis = along,
                    .radii = {0.03f, 0.01f, 0}})
                  .empty());
  EXPECT_FALSE(with({.shape = ColliderShape::kPlane, .center = {0, -0.1f - kHit, 0}, .axis = {0, 1, 0}}).empty());
  EXPECT_TRUE(with({.shape = ColliderShape::kPlane, .center = {0, -0.12f, 0}, .axis = {0, 1, 0}}).empty());
  EXPECT_FALSE(with({.shape = ColliderShape::kBox, .center = beside, .half_extents = {0.03f, 0.01f, 0.01f}}).empty());
  EXPECT_TRUE(with({.shape = ColliderShape::kBox,
                    .center = beside,
                    .rotation = {0, 0, 0.70710678f, 0.70710678f},
                    .half_extents = {0.03f, 0.01f, 0.01f}})
                  .empty());
}

TEST_F(Contacts, OfHairThatIsKeptInsideAreAtItsEnd) {
  const DebugCollider room{.center = {0, 0.02f, 0}, .radii = {0.125f, 0.125f, 0.125f}, .keeps_inside = true};
  const auto lines = with(room);
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_NEAR(lines[2].from[1], -0.105, 1e-5);
  EXPECT_GT(lines[2].to[1], lines[2].from[1]) << "inwards";
  DebugCollider wider = room;
  wider.radii = {0.13f, 0.13f, 0.13f};
  EXPECT_TRUE(with(wider).empty());
}

TEST_F(Contacts, ARootInTheScalpIsNone) {
  EXPECT_TRUE(with({.center = {0, 0.01f, 0}, .radii = {0.05f, 0.05f, 0.05f}}).empty());
  EXPECT_FALSE(with({.center = {0, 0.01f, 0}, .radii = {0.12f, 0.12f, 0.12f}}).empty()) << "the end is inside, too";
}

TEST_F(Contacts, OnlyCollidersThatABoneMayTouchCount) {
  AssetContents contents = contents_;
  ColliderRecord ball{};
  ball.shape = ColliderShape::kSphere;
  ball.center[0] = 0.03f + kHit;
  ball.center[1] = -0.06f;
  ball.rotation[3] = 1;
  std::fill_n(ball.radii, 3, 0.03f);
  contents.colliders = {ball};
  const std::vector<Mat34> palette(contents.bones.size());
  for (const std::uint32_t set : {0u, 1u}) {
    contents.bones[4].colliders = set;
    Collected found;
    ASSERT_EQ(draw_contact_lines(*DrawnAsset(contents), {.head = {}, .palette = palette}, found.sink()), Status::kOk);
    EXPECT_EQ(found.indices(), set == 0 ? std::set<std::uint32_t>{} : std::set<std::uint32_t>{4});
  }
}

TEST(DebugLines, AreRefusedForWhatDoesNotFitAndNoneIsDrawn) {
  const DrawnAsset asset(small_asset());
  const std::vector<Mat34> palette((*asset).bones().size());
  const HairInstance good{.head = {}, .palette = palette};
  HairInstance short_palette = good, nowhere = good, vast = good;
  short_palette.palette = std::span(palette).first(2);
  nowhere.head.position[0] = std::numeric_limits<double>::quiet_NaN();
  vast.head.scale = 21;
  Collected found;
  for (const auto draw : {draw_bone_lines, draw_limit_lines}) {
    EXPECT_EQ(draw(Asset(), good, found.sink()), Status::kAssetLacksData);
    EXPECT_EQ(draw(*asset, good, {}), Status::kBadArgument);
    EXPECT_EQ(draw(*asset, short_palette, found.sink()), Status::kSizeMismatch);
    EXPECT_EQ(draw(*asset, nowhere, found.sink()), Status::kBadPose);
    EXPECT_EQ(draw(*asset, vast, found.sink()), Status::kBadScale);
  }
  const DebugCollider bad{.radii = {std::numeric_limits<float>::infinity(), 0, 0}};
  EXPECT_EQ(draw_contact_lines(*asset, vast, found.sink()), Status::kBadScale);
  EXPECT_EQ(draw_contact_lines(*asset, good, found.sink(), {}, -1), Status::kBadArgument);
  EXPECT_EQ(draw_contact_lines(*asset, good, found.sink(), {&bad, 1}), Status::kBadArgument);
  EXPECT_EQ(draw_collider_lines({&bad, 1}, {}, found.sink()), Status::kBadArgument);
  EXPECT_EQ(draw_collider_lines(std::span<const DebugCollider>(), vast.head, found.sink()), Status::kBadScale);
  EXPECT_EQ(draw_collider_lines(Asset(), {}, found.sink()), Status::kAssetLacksData);
  EXPECT_EQ(draw_collider_lines(*asset, {}, {}), Status::kBadArgument);
  EXPECT_TRUE(found.lines.empty());
}

}  // namespace coif::debug_lines_test
