#include "cook/built_models.h"
#include "cook/lods/make_lods.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::cook::drop_patches_test {

constexpr double kReach = 0.01;

/// Cards of eight triangles, each a patch.
struct Cards {
  importer::SourceMesh source;
  PatchSet patches;

  void add(const Eigen::Vector3f& root, float width = 0.2f) {
    const importer::SourceMesh card =
        make_card({.columns = 2, .rows = 2, .width = width, .length = 0.2f, .root = root});
    append_card(card, source);
    patches.patch_of.insert(patches.patch_of.end(), card.triangles.size() / 3, patches.count++);
  }

  /// What is still drawn when `excess` triangles should go.
  [[nodiscard]] std::vector<bool> drop(std::size_t excess, const AlphaTest& alpha = {}) const {
    const HairStrips hair = strips_from(hair_from(source), patches);
    PatchDropper dropper(hair, alpha, kReach, 2);
    const std::vector<std::size_t> triangles(patches.count, 8);
    std::vector<bool> drawn(patches.count, true);
    const std::size_t gone = dropper.drop(excess, triangles, drawn);
    EXPECT_EQ(gone, 8 * std::size_t(std::ranges::count(drawn, false)));
    EXPECT_LE(dropper.bared(), 0.02);
    return drawn;
  }
};

TEST(DropPatches, OfCardsOnEachOtherTheHiddenOnesGo) {
  Cards cards;
  for (int i = 0; i < 5; ++i) cards.add({0, 1.6f, 0.002f * float(i)});
  const std::vector<bool> drawn = cards.drop(24);
  EXPECT_EQ(drawn, (std::vector<bool>{true, false, false, false, true})) << "both outer ones are seen";
}

TEST(DropPatches, SomethingOfAStackAlwaysStays) {
  Cards cards;
  for (int i = 0; i < 5; ++i) cards.add({0, 1.6f, 0.0002f * float(i)});
  EXPECT_EQ(std::ranges::count(cards.drop(1000000), true), 1);
}

TEST(DropPatches, NoMoreGoesThanAskedFor) {
  Cards cards;
  for (int i = 0; i < 8; ++i) cards.add({0, 1.6f, 0.001f * float(i)});
  EXPECT_EQ(std::ranges::count(cards.drop(9), false), 2);
}

TEST(DropPatches, CardsSideBySideLeaveNoHoles) {
  Cards cards;
  for (int i = 0; i < 6; ++i) cards.add({0.2f * float(i), 1.6f, 0});
  EXPECT_EQ(std::ranges::count(cards.drop(1000000), true), 6);
}

TEST(DropPatches, AWispThatIsSeenAloneStays) {
  Cards cards;
  for (int i = 0; i < 4; ++i) cards.add({0, 1.6f, 0.001f * float(i)});
  cards.add({0.105f, 1.6f, 0}, 0.002f);  // too narrow to count for the whole, and close enough to go
  EXPECT_TRUE(cards.drop(1000000)[4]);
}

/// A card inside a box is never seen; still it is far from what would be drawn in its place.
TEST(DropPatches, HairFarFromOtherHairStays) {
  for (const bool is_near : {true, false}) {
    const float half = float(kReach) * (is_near ? 0.9f : 3.0f);
    Cards cards;
    for (int i = 0; i < 8; ++i) {
      cards.source.positions.emplace_back(i % 2 ? half : -half, i / 2 % 2 ? half : -half, i / 4 ? half : -half);
      cards.source.uvs.emplace_back(0.0f, 0.0f);
    }
    cards.source.triangles = {0, 1, 2, 1, 2, 3, 4, 5, 6, 5, 6, 7, 0, 1, 4, 1, 4, 5,
                              2, 3, 6, 3, 6, 7, 0, 2, 4, 2, 4, 6, 1, 3, 5, 3, 5, 7};
    cards.patches = {std::vector<std::uint32_t>(12, 0), 1};
    append_card(make_card({.columns = 2, .rows = 2, .width = 0.01f, .length = 0.01f, .root = {0, 0.005f, 0}}),
                cards.source);
    cards.patches.patch_of.insert(cards.patches.patch_of.end(), 8, cards.patches.count++);
    EXPECT_EQ(cards.drop(8)[1], !is_near);
  }
}

TEST(DropPatches, WhatIsTransparentHidesNothing) {
  Cards cards;
  for (int i = 0; i < 3; ++i) cards.add({0, 1.6f, 0.002f * float(i)});
  for (std::size_t v = 0; v < cards.source.uvs.size(); ++v) {
    const bool middle = v >= 9 && v < 18;
    cards.source.uvs[v] = Eigen::Vector2f(middle ? 0.75f : 0.25f, 0.5f);  // only the middle card is opaque
  }
  const Image image{2, 1, 4, {0, 0, 0, 10, 0, 0, 0, 255}};
  EXPECT_TRUE(cards.drop(1000000, {.image = &image, .factor = 1, .threshold = 0.5})[1]);
  EXPECT_FALSE(cards.drop(8)[1]) << "opaque, the others hide it";
}

TEST(PatchCoverage, CountsWhatIsCoveredAloneAndByOthers) {
  Cards cards;
  cards.add({0, 1.6f, 0});
  cards.add({0, 1.6f, 0.002f});
  PatchCoverage views(strips_from(hair_from(cards.source), cards.patches), {}, 1);
  EXPECT_GT(views.covered(), 0u);
  EXPECT_GT(views.seen(0), 0u);
  EXPECT_LT(double(views.alone(0)), 0.1 * double(views.pixels(0)));
  views.drop(1);
  EXPECT_EQ(views.alone(0), views.pixels(0));
}

/// Pixels, from all sides, of a sliver before a square of 191 m: seen from the front, pixels are 1 m wide. It goes from
/// pixel 20 to 120 one way, and at `place` the other.
std::size_t pixels_of_sliver(float place, bool level) {
  const auto rectangle = [](importer::SourceMesh& mesh, const Eigen::Vector2f& low, const Eigen::Vector2f& high) {
    const auto first = std::uint32_t(mesh.positions.size());
    for (const float y : {low.y(), high.y()}) {
      for (const float x : {low.x(), high.x()}) {
        mesh.positions.emplace_back(x, y, 0.0f);
        mesh.uvs.emplace_back(0.0f, 0.0f);
      }
    }
    for (const std::uint32_t corner : {0u, 1u, 3u, 0u, 3u, 2u}) mesh.triangles.push_back(first + corner);
  };
  importer::SourceMesh mesh;
  rectangle(mesh, {0, 0}, {191, 191});
  const Eigen::Vector2f low(20.25f, place - 0.02f), high(120.25f, place + 0.02f);
  rectangle(mesh, level ? low : Eigen::Vector2f(low.y(), low.x()), level ? high : Eigen::Vector2f(high.y(), high.x()));
  const PatchCoverage views(strips_from(hair_from(mesh), {{0, 0, 1, 1}, 2}), {}, 1);
  return views.pixels(1);
}

TEST(PatchCoverage, APixelIsCoveredWhereItsMiddleIs) {
  for (const bool level : {false, true}) {
    for (const float beside : {-0.05f, 0.05f}) {
      EXPECT_GE(pixels_of_sliver(70.5f, level), pixels_of_sliver(70.5f + beside, level) + 90) << level << beside;
    }
    EXPECT_GE(pixels_of_sliver(190.5f, level), pixels_of_sliver(190.4f, level) + 90) << "the last row counts too";
  }
}

TEST(AlphaTest, TheTextureRepeats) {
  const Image image{2, 1, 4, {0, 0, 0, 0, 0, 0, 0, 255}};
  const AlphaTest test{.image = &image, .factor = 1, .threshold = 0.5};
  EXPECT_TRUE(test.passes({0.75f, 0.5f}));
  EXPECT_TRUE(test.passes({-0.25f, 7.5f}));
  EXPECT_FALSE(test.passes({3.25f, -2.0f}));
}

TEST(TriangleGrid, FindsTheNearestWithinItsReach) {
  const HairMesh mesh = hair_from(make_card({.columns = 3, .rows = 40, .bend_radius = 0.1f}));
  const std::vector<std::uint32_t> group(mesh.triangle_count(), 0);
  const TriangleGrid grid(mesh.positions, mesh.triangles, group, kReach);
  for (int i = 0; i < 300; ++i) {
    const Eigen::Vector3f at = mesh.positions[std::size_t(i) % mesh.positions.size()] +
                               Eigen::Vector3f(0.001f * float(i % 13), 0, 0.0007f * float(i % 23));
    const double nearest = std::min(distance_from(mesh, mesh.triangles, at), kReach);
    EXPECT_NEAR(grid.distance(at, {true}, 0), nearest, 1.0e-9);
    EXPECT_EQ(grid.distance(at, {false}, 0), kReach);
    EXPECT_EQ(grid.distance(at, {true}, kReach) < kReach, nearest < kReach);
  }
}

}  // namespace coif::cook::drop_patches_test
