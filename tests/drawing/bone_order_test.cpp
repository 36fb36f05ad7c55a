// Bones sorted in each frame, without OpenGL. A program of its own: it counts every allocation of the process.

#include "models/counted_allocations.h"
#include "models/drawn_card.h"
#include "models/skinned_asset.h"

#include <coif/triangle_order.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <limits>
#include <new>
#include <numeric>
#include <random>
#include <vector>

namespace coif::bone_order_test {

constexpr Vec3 kInFront{0, 0, 9};
using Triangles = std::vector<std::array<std::uint32_t, 3>>;

/// A card on each bone, the first the furthest from an eye in front, 0.1 m apart.
std::vector<DrawnCard> far_to_near(std::uint16_t bones) {
  std::vector<DrawnCard> cards(bones);
  for (std::uint16_t i = 0; i < bones; ++i) {
    cards[i].center = {0, 0, 0.1f * float(i)};
    cards[i].skin = {{i, 0, 0, 0}, {255, 0, 0, 0}};
  }
  return cards;
}

/// An open asset and a BoneOrder of it.
struct Ordered {
  explicit Ordered(const AssetContents& contents) : Ordered(write_asset(contents)) {}
  explicit Ordered(const std::vector<std::byte>& bytes)
      : asset(bytes), hair(drawn_hair_of(*asset)), memory(BoneOrder::memory_bytes(*asset) / 16 + 1) {
    EXPECT_EQ(order.create(*asset, std::as_writable_bytes(std::span(memory))), Status::kOk);
  }

  Triangles drawn(const HairInstance& head, const Vec3& eye = kInFront) {
    const std::size_t count = (*asset).lod_indices(head.lod).size();
    std::vector<std::byte> out(count * hair.index_bytes);
    order.write(head, eye, out.data());
    Triangles triangles(count / 3);
    for (std::size_t i = 0; i < count; ++i) {
      std::uint32_t index = 0;
      std::memcpy(&index, &out[i * hair.index_bytes], hair.index_bytes);
      triangles[i / 3][i % 3] = index;
    }
    return triangles;
  }
  [[nodiscard]] Triangles stored(std::uint32_t lod = 0) const {
    Triangles triangles;
    const auto indices = (*asset).lod_indices(lod);
    for (std::size_t i = 0; i < indices.size(); i += 3)
      triangles.push_back({indices[i], indices[i + 1], indices[i + 2]});
    return triangles;
  }

  struct alignas(16) Unit {
    std::byte bytes[16];
  };
  DrawnAsset asset;
  DrawnHair hair;
  std::vector<Unit> memory;
  BoneOrder order;
};

std::vector<Mat34> scattered(std::size_t bones, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<Mat34> palette(bones);
  for (Mat34& matrix : palette) {
    for (auto& row : matrix.m) row[3] = float(random() % 1000) / 1000 - 0.5f;
  }
  return palette;
}

Triangles sorted(Triangles triangles) {
  std::ranges::sort(triangles);
  return triangles;
}

/// Which card each pair of triangles is of.
std::vector<std::uint32_t> cards_of(const Triangles& triangles) {
  std::vector<std::uint32_t> cards;
  for (std::size_t i = 0; i < triangles.size(); i += 2) cards.push_back(triangles[i][0] / 4);
  return cards;
}

TEST(BoneOrder, IsTheStoredOrderWhereThatIsFarToNearAndNothingMoved) {
  Ordered ordered(card_contents(far_to_near(5), 5));
  const std::vector<Mat34> rest(5);
  EXPECT_EQ(ordered.drawn({.head = {}, .palette = rest}), ordered.stored());
  EXPECT_EQ(ordered.order.bones_of(0), 5u);
}

TEST(BoneOrder, FromBehindItIsTheOtherWayRound) {
  Ordered ordered(card_contents(far_to_near(5), 5));
  const std::vector<Mat34> rest(5);
  EXPECT_EQ(cards_of(ordered.drawn({.head = {}, .palette = rest}, {0, 0, -9})),
            (std::vector<std::uint32_t>{4, 3, 2, 1, 0}));
}

TEST(BoneOrder, BonesThatMoveTakeTheirTrianglesAlong) {
  Ordered ordered(card_contents(far_to_near(7), 7));
  for (unsigned seed = 0; seed < 20; ++seed) {
    const std::vector<Mat34> palette = scattered(7, seed);
    std::vector<std::uint32_t> expected(7);
    std::iota(expected.begin(), expected.end(), 0u);
    std::ranges::sort(expected, std::greater{}, [&](std::uint32_t i) {
      const auto& m = palette[i].m;
      return std::hypot(double(m[0][3]), double(m[1][3]), 0.1 * i + double(m[2][3]) - 9);
    });
    EXPECT_EQ(cards_of(ordered.drawn({.head = {}, .palette = palette})), expected) << seed;
  }
}

TEST(BoneOrder, AHeadsScaleBringsItsHairNearerToTheEyeOrPastIt) {
  Ordered ordered(card_contents(far_to_near(5), 5));
  const std::vector<Mat34> rest(5);
  // In front of cards up to 0.4 m; of a head twice as large between the third and the fourth.
  const Vec3 between{0, 0, 0.47f};
  HairInstance head{.head = {}, .palette = rest};
  EXPECT_EQ(cards_of(ordered.drawn(head, between)), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
  head.head.scale = 2;
  EXPECT_EQ(cards_of(ordered.drawn(head, between)), (std::vector<std::uint32_t>{0, 4, 1, 3, 2}));
}

TEST(BoneOrder, EveryTriangleOfEveryLevelIsDrawnOnce) {
  const std::vector<std::byte> wig = made_up_wig({.strips = 12, .bones_per_chain = 3, .texture_size = 32});
  Ordered ordered(wig);
  const std::size_t bones = (*ordered.asset).bones().size();
  for (unsigned seed = 0; seed < 5; ++seed) {
    const std::vector<Mat34> palette = scattered(bones, seed);
    EXPECT_EQ(sorted(ordered.drawn({.head = {}, .palette = palette})), sorted(ordered.stored()));
  }
  AssetContents levels = card_contents(far_to_near(6), 6);
  levels.lods = {{0, 4, 0.5f, 0}, {4, 2, 0, 0.01f}};
  levels.lod_bones.assign(6, 0);
  Ordered two(levels);
  for (const std::uint32_t lod : {0u, 1u}) {
    const std::vector<Mat34> palette = scattered(6, lod);
    const Triangles drawn = two.drawn({.head = {}, .palette = palette, .lod = lod});
    EXPECT_EQ(drawn.size(), lod == 0 ? 8u : 4u);
    EXPECT_EQ(sorted(drawn), sorted(two.stored(lod)));
    EXPECT_EQ(two.order.bones_of(lod), lod == 0 ? 4u : 2u);
  }
}

TEST(BoneOrder, ATriangleBelongsToTheBoneThatMovesItMost) {
  std::vector<DrawnCard> cards = far_to_near(3);
  cards[0].skin = {{0, 2, 1, 0}, {100, 80, 75, 0}};
  AssetContents contents = card_contents(cards, 3);
  // One corner of both triangles of the middle card hangs elsewhere.
  contents.skin[4] = {{2, 0, 0, 0}, {255, 0, 0, 0}};
  Ordered ordered(contents);
  std::vector<Mat34> palette(3);
  palette[0].m[2][3] = 5;  // the first card comes to the front, the second and third stay
  EXPECT_EQ(cards_of(ordered.drawn({.head = {}, .palette = palette})), (std::vector<std::uint32_t>{1, 2, 0}));
}

TEST(BoneOrder, WithinABoneTheCookedOrderOfThatSideHolds) {
  std::vector<DrawnCard> cards = far_to_near(4);
  for (DrawnCard& card : cards) card.skin.bone[0] = 1;
  AssetContents contents = card_contents(cards, 2);
  contents.orders = {7, 6, 5, 4, 3, 2, 1, 0};
  contents.order_views.assign(kViewCells, 1);
  contents.order_views[view_cell({0, 0, 1})] = 0;
  Ordered ordered(contents);
  const std::vector<Mat34> rest(2);
  const Triangles stored = ordered.stored();
  EXPECT_EQ(ordered.drawn({.head = {}, .palette = rest}), stored);
  EXPECT_EQ(ordered.drawn({.head = {}, .palette = rest}, {0, 0, -9}), Triangles(stored.rbegin(), stored.rend()));
}

TEST(BoneOrder, HeadAndEyeThatMoveTogetherChangeNothing) {
  Ordered ordered(card_contents(far_to_near(7), 7));
  const std::vector<Mat34> palette = scattered(7, 3);
  const Triangles expected = ordered.drawn({.head = {}, .palette = palette}, {3, 0, 0});
  HairInstance head{.head = {}, .palette = palette};
  head.head.position[0] = 1e6;
  head.head.rotation = {0, std::sqrt(0.5f), 0, std::sqrt(0.5f)};  // +X to -Z
  EXPECT_EQ(ordered.drawn(head, {1e6f, 0, -3}), expected);
  EXPECT_NE(ordered.drawn(head, {1e6f, 0, 3}), expected);
}

TEST(BoneOrder, WideIndicesAreWrittenWide) {
  AssetContents contents = card_contents(far_to_near(3), 3);
  contents.vertices.resize(70'000, contents.vertices.back());
  contents.skin.resize(70'000, contents.skin.back());
  for (std::size_t i = 0; i < 6; ++i) contents.indices[i] += 69'990;
  Ordered ordered(contents);
  ASSERT_EQ(ordered.hair.index_bytes, 4u);
  const std::vector<Mat34> rest(3);
  EXPECT_EQ(sorted(ordered.drawn({.head = {}, .palette = rest})), sorted(ordered.stored()));
}

TEST(BoneOrder, NumbersThatAreNoneLoseNoTriangle) {
  Ordered ordered(card_contents(far_to_near(7), 7));
  std::vector<Mat34> palette = scattered(7, 1);
  palette[2].m[0][3] = std::numeric_limits<float>::quiet_NaN();
  palette[4].m[1][3] = std::numeric_limits<float>::infinity();
  palette[5].m[1][0] = -std::numeric_limits<float>::infinity();
  EXPECT_EQ(sorted(ordered.drawn({.head = {}, .palette = palette})), sorted(ordered.stored()));
}

TEST(BoneOrder, RefusesWhatItCannotSortAndKeepsWhatItHad) {
  Ordered ordered(card_contents(far_to_near(3), 3));
  AssetContents rigid = card_contents(far_to_near(3), 3);
  rigid.skin.clear();
  const DrawnAsset without_skin(rigid);
  EXPECT_EQ(BoneOrder::memory_bytes(*without_skin), 0u);
  const auto memory = std::as_writable_bytes(std::span(ordered.memory));
  EXPECT_EQ(ordered.order.create(*without_skin, memory), Status::kAssetLacksData);
  const std::size_t need = BoneOrder::memory_bytes(*ordered.asset);
  EXPECT_EQ(ordered.order.create(*ordered.asset, memory.first(need - 1)), Status::kMemoryTooSmall);
  EXPECT_EQ(ordered.order.create(*ordered.asset, memory.subspan(8)), Status::kMemoryTooSmall);
  EXPECT_TRUE(ordered.order.fits(ordered.hair));
  const std::vector<Mat34> rest(3);
  EXPECT_EQ(ordered.drawn({.head = {}, .palette = rest}), ordered.stored());
  EXPECT_FALSE(ordered.order.fits(drawn_hair_of(*DrawnAsset(card_contents(far_to_near(4), 4)))));
  EXPECT_FALSE(BoneOrder().fits(ordered.hair));
}

TEST(BoneOrder, NeverAllocates) {
  Ordered ordered(made_up_wig({.strips = 12, .bones_per_chain = 3, .texture_size = 32}));
  const auto memory = std::as_writable_bytes(std::span(ordered.memory));
  const std::vector<Mat34> palette = scattered((*ordered.asset).bones().size(), 2);
  std::vector<std::byte> out((*ordered.asset).indices().size() * 4);
  const std::size_t before = allocations;
  BoneOrder order;
  const bool ok = order.create(*ordered.asset, memory) == Status::kOk;
  for (int frame = 0; frame < 100; ++frame) {
    order.write({.head = {}, .palette = palette}, {float(frame - 50), 1, 2}, out.data());
  }
  EXPECT_EQ(allocations, before);
  EXPECT_TRUE(ok);
  const std::vector<int> block(100);
  EXPECT_EQ(allocations, before + 1) << "the counter counts " << block.size();
}

}  // namespace coif::bone_order_test
