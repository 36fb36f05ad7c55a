// A box around the hair of one head, from its matrices alone.

#include "models/drawn_card.h"
#include "models/skinned_asset.h"

#include <coif/bounds.h>
#include <coif/hair.h>
#include <coif/skinning.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace coif::bounds_test {

struct Bounded {
  explicit Bounded(const Asset& of) : asset(of), boxes(of.bones().size()) {
    EXPECT_EQ(find_bone_boxes(of, boxes), Status::kOk);
  }

  [[nodiscard]] HairBounds at(std::span<const Mat34> palette) const {
    HairBounds bounds;
    EXPECT_EQ(bound_hair(boxes, palette, bounds), Status::kOk);
    return bounds;
  }

  [[nodiscard]] std::vector<SkinnedVertex> skinned(std::span<const Mat34> palette) const {
    std::vector<SkinnedVertex> out(asset.vertices().size());
    EXPECT_EQ(skin_vertices(asset, palette, 0, out), Status::kOk);
    return out;
  }

  const Asset& asset;
  std::vector<BoneBox> boxes;
};

double diagonal(const HairBounds& box) {
  return std::hypot(double(box.highest.x - box.lowest.x), double(box.highest.y - box.lowest.y),
                    double(box.highest.z - box.lowest.z));
}

HairBounds true_box(std::span<const SkinnedVertex> vertices) {
  HairBounds box{{9, 9, 9}, {-9, -9, -9}};
  for (const SkinnedVertex& v : vertices) {
    const Vec3& p = v.position;
    box.lowest = {std::min(box.lowest.x, p.x), std::min(box.lowest.y, p.y), std::min(box.lowest.z, p.z)};
    box.highest = {std::max(box.highest.x, p.x), std::max(box.highest.y, p.y), std::max(box.highest.z, p.z)};
  }
  return box;
}

bool holds(const HairBounds& outer, const HairBounds& inner) {
  return outer.lowest.x <= inner.lowest.x && outer.lowest.y <= inner.lowest.y && outer.lowest.z <= inner.lowest.z &&
         outer.highest.x >= inner.highest.x && outer.highest.y >= inner.highest.y && outer.highest.z >= inner.highest.z;
}

TEST(Bounds, AtRestAreTheMeshsOwnBox) {
  const DrawnAsset wig(made_up_wig({.texture_size = 32}));
  const Bounded bounded(*wig);
  const std::vector<Mat34> rest((*wig).bones().size());
  const HairBounds found = bounded.at(rest), exact = true_box(bounded.skinned(rest));
  EXPECT_TRUE(holds(found, exact));
  EXPECT_LT(diagonal(found), 1.0001 * diagonal(exact));
}

TEST(Bounds, HoldEveryVertexOfAnyPaletteWithAnyWeights) {
  std::mt19937 random(7);
  constexpr std::uint32_t kBones = 9;
  std::vector<SkinRecord> skin;
  for (int i = 0; i < 200; ++i) {
    SkinRecord vertex{};
    int left = 255;
    for (int k = 0; k < 4; ++k) {
      vertex.bone[k] = std::uint16_t(random() % kBones);
      vertex.weight[k] = std::uint8_t(k == 3 ? left : int(random() % unsigned(left + 1)));
      left -= vertex.weight[k];
    }
    skin.push_back(vertex);
  }
  const DrawnAsset asset(skinned_contents(kBones, skin));
  const Bounded bounded(*asset);
  for (int i = 0; i < 50; ++i) {
    std::vector<Mat34> palette = bent_palette(kBones);
    for (Mat34& matrix : palette) {
      for (auto& row : matrix.m) {
        for (float& value : row) value += float(int(random() % 2001) - 1000) / 500;
      }
    }
    EXPECT_TRUE(holds(bounded.at(palette), true_box(bounded.skinned(palette)))) << i;
  }
}

/// Half a second of a head that is thrown about.
TEST(Bounds, HoldSimulatedHairInMotionAndStayTight) {
  const DrawnAsset wig(made_up_wig({.texture_size = 32}));
  const Bounded bounded(*wig);
  struct alignas(64) Block {
    std::byte bytes[64];
  };
  const HairDesc desc;
  std::vector<Block> memory(Hair::memory_need(*wig, desc).bytes / sizeof(Block) + 1);
  Hair hair;
  ASSERT_EQ(hair.create(*wig, desc, std::as_writable_bytes(std::span(memory))), Status::kOk);
  double widest = 0, moved = 0;
  const HairBounds rest = bounded.at(std::vector<Mat34>((*wig).bones().size()));
  for (int frame = 1; frame <= 60; ++frame) {
    const float angle = 1.3f * std::sin(0.35f * float(frame));
    HeadPose pose;
    pose.rotation = {std::sin(angle / 2), 0, 0, std::cos(angle / 2)};
    pose.position[0] = 0.6 * std::sin(0.2 * frame);
    ASSERT_EQ(hair.set_head(0, pose), Status::kOk);
    ASSERT_EQ(hair.step({}), Status::kOk);
    const HairBounds found = bounded.at(hair.palette(0)), exact = true_box(bounded.skinned(hair.palette(0)));
    EXPECT_TRUE(holds(found, exact)) << frame;
    widest = std::max(widest, diagonal(found) / diagonal(exact));
    moved = std::max(moved, double(std::fabs(exact.highest.z - rest.highest.z)));
  }
  EXPECT_LT(widest, 1.5) << "of the true box's diagonal";
  EXPECT_GT(moved, 0.02) << "the hair hardly moved: little was tested";
}

TEST(Bounds, HairWithoutSkinHangsOnTheHead) {
  DrawnCard card;
  card.center = {1, 2, 3};
  AssetContents contents = card_contents(std::span(&card, 1), 3);
  contents.skin.clear();
  const DrawnAsset asset(contents);
  const Bounded bounded(*asset);
  const HairBounds box = bounded.at(std::vector<Mat34>(3));
  EXPECT_NEAR(box.lowest.x, 0.5f, 1e-5f);
  EXPECT_NEAR(box.highest.y, 2.5f, 1e-5f);
  EXPECT_NEAR(box.highest.z, 3, 1e-5f);
  EXPECT_LT(bounded.boxes[1].half.x, 0) << "nothing hangs there";
}

TEST(Bounds, InTheWorldHoldWhatTheHeadsPoseMakesOfThem) {
  const HairBounds box{{-0.1f, -0.3f, -0.05f}, {0.2f, 0.1f, 0.15f}};
  std::mt19937 random(3);
  for (int i = 0; i < 50; ++i) {
    const auto number = [&] { return double(random() % 2001) / 1000 - 1; };
    HeadPose head;
    const double q[4] = {number(), number(), number(), number() + 1.1};
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    head.rotation = {float(q[0] / length), float(q[1] / length), float(q[2] / length), float(q[3] / length)};
    for (double& place : head.position) place = 1e5 * number();
    head.scale = float(2 + number());
    const WorldBounds world = bounds_in_world(box, head);
    double reached[3] = {};
    for (int corner = 0; corner < 8; ++corner) {
      const double v[3] = {double(corner & 1 ? box.highest.x : box.lowest.x),
                           double(corner & 2 ? box.highest.y : box.lowest.y),
                           double(corner & 4 ? box.highest.z : box.lowest.z)};
      const auto& r = head.rotation;
      const double u[3] = {r.x, r.y, r.z}, w = r.w;
      const double t[3] = {2 * (u[1] * v[2] - u[2] * v[1]), 2 * (u[2] * v[0] - u[0] * v[2]),
                           2 * (u[0] * v[1] - u[1] * v[0])};
      const double turned[3] = {v[0] + w * t[0] + u[1] * t[2] - u[2] * t[1],
                                v[1] + w * t[1] + u[2] * t[0] - u[0] * t[2],
                                v[2] + w * t[2] + u[0] * t[1] - u[1] * t[0]};
      double square = 0;
      for (int k = 0; k < 3; ++k) {
        const double off = head.position[k] + double(head.scale) * turned[k] - world.center[k];
        reached[k] = std::max(reached[k], std::fabs(off));
        square += off * off;
      }
      EXPECT_NEAR(std::sqrt(square), world.radius, 1e-5) << "each corner is on the ball";
    }
    const double half[3] = {world.half.x, world.half.y, world.half.z};
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(reached[k], half[k], 1e-5) << "the box touches the corners";
  }
}

TEST(Bounds, RefuseWhatDoesNotFitAndChangeNothing) {
  const DrawnAsset wig(made_up_wig({.strips = 6, .texture_size = 32}));
  const std::size_t bones = (*wig).bones().size();
  std::vector<BoneBox> boxes(bones + 1);
  EXPECT_EQ(find_bone_boxes(*wig, boxes), Status::kSizeMismatch);
  EXPECT_EQ(find_bone_boxes(Asset(), boxes), Status::kAssetLacksData);
  HairBounds bounds{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(bound_hair(boxes, std::vector<Mat34>(bones), bounds), Status::kSizeMismatch);
  EXPECT_EQ(bound_hair(boxes, std::vector<Mat34>(bones + 1), bounds), Status::kAssetLacksData) << "nothing hangs there";
  EXPECT_EQ(bound_hair({}, {}, bounds), Status::kAssetLacksData);
  EXPECT_EQ(bounds.highest.z, 6);
}

}  // namespace coif::bounds_test
