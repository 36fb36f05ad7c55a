#include "cards/scalp_cards.h"

#include "cards/made_up_groom.h"
#include "cards/make_cards.h"
#include "cards/scalp_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <random>

namespace coif::cards::scalp_cards_test {

constexpr float kWidth = 0.0008f, kHead = 0.1f;  // metres; test::strands_of_a_head() has that radius
using Eigen::Vector3f;

struct MadeScalp {
  explicit MadeScalp(const std::vector<std::vector<Vector3f>>& strands, std::size_t triangles = 240)
      : groom(test::groom_of(strands)),
        shape(shape_of(groom, kWidth)),
        cards(find_scalp_cards(groom, shape.is_reversed, shape.strands, triangles, 2)) {}
  groom::Groom groom;
  GroomShape shape;
  ScalpCards cards;
};

/// Strands that lie on a head of 0.1 m, from its middle line to both sides.
std::vector<std::vector<Vector3f>> parted_hair(std::size_t count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<std::vector<Vector3f>> strands;
  for (std::size_t i = 0; i < count; ++i) {
    const float side = i % 2 == 0 ? 1.0f : -1.0f, forwards = 1.4f * unit(random) - 0.7f;
    const float begin = 0.8f * unit(random);
    std::vector<Vector3f> strand;
    for (int k = 0; k < 10; ++k) {
      const float turn = begin + 0.08f * float(k);
      const Vector3f out(side * std::sin(turn), std::cos(turn), 0);
      strand.emplace_back((kHead + 0.0005f * float(k)) *
                          (out * std::cos(forwards) + Vector3f(0, 0, std::sin(forwards))));
    }
    strands.push_back(strand);
  }
  return strands;
}

/// How far the strips' flat quads are from the head's middle, least and most.
std::pair<float, float> distances_of(const ScalpCards& cards) {
  float least = 1, most = 0;
  for (std::size_t i = 0; i < cards.strips.size(); ++i) {
    const auto edges = edges_of(cards.wisps[i].ribbon, cards.strips[i]);
    for (std::size_t k = 0; k + 1 < edges.size(); ++k) {
      const auto &a = edges[k], &b = edges[k + 1];
      for (const float u : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
        for (const float v : {0.0f, 0.25f, 0.5f, 0.75f, 1.0f}) {
          const Vector3f at = (1 - v) * ((1 - u) * a[0] + u * a[1]) + v * ((1 - u) * b[0] + u * b[1]);
          least = std::min(least, at.norm());
          most = std::max(most, at.norm());
        }
      }
    }
  }
  return {least, most};
}

TEST(ScalpPatches, HoldEachStrandOnceAndLieInItsSkin) {
  const MadeScalp made(parted_hair(1500));
  const Scalp scalp = find_scalp(made.groom, made.shape.is_reversed, made.shape.strands, 40, 2);
  std::vector<int> seen(1500, 0);
  for (const ScalpPatch& patch : scalp.patches) {
    for (const std::uint32_t i : patch.members) ++seen[i];
    EXPECT_LT(patch.off_skin, 0.001f);
    EXPECT_NEAR(patch.on_skin(0, 0).norm(), kHead, 0.001f);
    EXPECT_GT(patch.normal(0, 0).dot(patch.middle.normalized()), 0.98f) << "outwards";
  }
  EXPECT_EQ(std::ranges::count(seen, 1), 1500);
  EXPECT_EQ(groom::find_groom_fault(scalp.strands), "");
  EXPECT_EQ(scalp.strands.strand_count(), 1500u);
  for (const Vector3f& point : scalp.strands.points) ASSERT_NEAR(point.norm(), kHead, 0.12f * kHead) << "laid down";
}

TEST(ScalpPatches, EndAtAParting) {
  const MadeScalp made(parted_hair(2000));
  for (const ScalpPatch& patch : find_scalp(made.groom, made.shape.is_reversed, made.shape.strands, 60, 2).patches) {
    const auto right = std::ranges::count_if(patch.members, [](std::uint32_t i) { return i % 2 == 0; });
    EXPECT_TRUE(right == 0 || right == std::ptrdiff_t(patch.members.size())) << right << " of " << patch.members.size();
  }
}

/// A head's roots end at a hairline; the side of it where they end is the rim, however dense they are, and the crown is
/// not.
TEST(RootsAtRim, AreThoseNearTheHairline) {
  constexpr float kReach = 0.25f * kHead;
  std::mt19937 random(11);
  std::uniform_real_distribution<float> unit(0, 1);
  std::vector<Vector3f> roots;
  while (roots.size() < 12000) {
    const float y = unit(random), around = 6.2831853f * unit(random), r = std::sqrt(1 - y * y);
    if (std::cos(around) > 0 && unit(random) < 0.6f) continue;  // Half of the head is less dense.
    roots.emplace_back(kHead * Vector3f(r * std::cos(around), y, r * std::sin(around)));
  }
  const std::vector<std::uint8_t> at_rim = roots_at_rim(roots, Vector3f::Zero(), kReach);
  int low = 0, low_at_rim = 0, high = 0, high_at_rim = 0;
  for (std::size_t i = 0; i < roots.size(); ++i) {
    const float above = kHead * std::asin(roots[i].y() / kHead);  // metres along the skin
    const bool is_where_density_changes = std::abs(roots[i].x()) < kReach;
    if (above < 0.2f * kReach) ++low, low_at_rim += at_rim[i];
    if (above > 1.1f * kReach && !is_where_density_changes) ++high, high_at_rim += at_rim[i];
  }
  EXPECT_GT(low_at_rim, 0.95 * low) << low;
  EXPECT_LT(high_at_rim, 0.1 * high) << high;
}

TEST(RootsAtRim, AreNoneWithoutReach) {
  const std::vector<Vector3f> roots(3, Vector3f::UnitX());
  EXPECT_EQ(roots_at_rim(roots, Vector3f::Zero(), 0), std::vector<std::uint8_t>(3, 0));
  EXPECT_TRUE(roots_at_rim({}, Vector3f::Zero(), 1).empty());
}

TEST(ScalpCards, LieOnTheSkinAndNotBelow) {
  const MadeScalp made(parted_hair(2000));
  ASSERT_GT(made.cards.wisps.size(), 30u);
  ASSERT_EQ(made.cards.strips.size(), made.cards.wisps.size());
  const auto [least, most] = distances_of(made.cards);
  EXPECT_GT(least, kHead - 0.0001f);
  EXPECT_LT(most, 1.06f * kHead);
  std::size_t triangles = 0;
  for (const CardStrip& strip : made.cards.strips) triangles += strip.triangles();
  EXPECT_LE(triangles, 240u);
}

TEST(ScalpCards, CoverInsideAndLeaveTheirEdgesClear) {
  const MadeScalp made(parted_hair(4000));
  double inside = 0;
  for (std::size_t i = 0; i < made.cards.wisps.size(); ++i) {
    const CardTexture texture = draw_scalp_card(made.cards, i, kWidth, 40, 40);
    inside += double(texture.opacity[20 * 40 + 20]) / double(made.cards.wisps.size());
    for (std::size_t k = 0; k < 40; ++k) {
      for (const std::size_t edge : {k, 39 * 40 + k, 40 * k, 40 * k + 39}) ASSERT_LT(texture.opacity[edge], 0.35f);
    }
  }
  EXPECT_GT(inside, 0.9);
}

TEST(ScalpCards, NeedAScalp) {
  std::vector<std::vector<Vector3f>> lock, beard, lashes, anywhere;
  std::mt19937 random(9);
  std::uniform_real_distribution<float> unit(-1, 1);
  for (int i = 0; i < 400; ++i) {
    lock.push_back(test::hanging({0.008f * unit(random), 0, 0.008f * unit(random)}, 0.3f));
    anywhere.push_back(test::hanging({0.1f * unit(random), 0.1f * unit(random), 0.1f * unit(random)}, 0.1f));
    const float x = 0.03f * unit(random);
    lashes.push_back({{x, 0, 0}, {x, 0.001f, 0.005f}, {x, 0.004f, 0.01f}});
  }
  for (int i = 0; i < 10; ++i) beard.push_back(test::hanging({0.03f * unit(random), 0, 0}, 0.05f));
  EXPECT_TRUE(MadeScalp(lock).cards.wisps.empty());
  EXPECT_TRUE(MadeScalp(beard).cards.wisps.empty());
  EXPECT_TRUE(MadeScalp(lashes).cards.wisps.empty());
  EXPECT_TRUE(MadeScalp(anywhere).cards.wisps.empty());
  EXPECT_TRUE(MadeScalp(parted_hair(1000), 3).cards.wisps.empty()) << "too few triangles";
}

TEST(ScalpCards, LieCloseOrAreNotThere) {
  for (const std::size_t triangles : {8u, 16u, 32u, 64u, 128u, 256u, 640u}) {
    const MadeScalp made(parted_hair(1500), triangles);
    EXPECT_LT(distances_of(made.cards).second, 1.1f * kHead) << triangles;
    if (triangles >= 256) {
      EXPECT_FALSE(made.cards.wisps.empty()) << triangles;
    }
  }
}

TEST(ScalpCards, RepeatWithAnyNumberOfThreads) {
  const MadeScalp one(parted_hair(1200));
  const ScalpCards three = find_scalp_cards(one.groom, one.shape.is_reversed, one.shape.strands, 240, 3);
  ASSERT_EQ(one.cards.wisps.size(), three.wisps.size());
  for (std::size_t i = 0; i < three.wisps.size(); ++i) {
    EXPECT_EQ(one.cards.wisps[i].members, three.wisps[i].members);
    EXPECT_EQ(std::memcmp(&one.cards.wisps[i].ribbon, &three.wisps[i].ribbon, sizeof(Ribbon)), 0);
  }
}

TEST(ScalpCards, AreAShareOfTheBudgetBehindAllOthers) {
  const MadeScalp made(parted_hair(2000));
  for (const float share : {0.0f, 0.06f, 0.3f}) {
    const auto cards = make_cards(made.groom, made.shape, {1200, std::size_t{1} << 18, 0, kWidth, share}, 2);
    ASSERT_TRUE(cards) << cards.error().message;
    const std::size_t on_scalp = MadeScalp(parted_hair(2000), std::size_t(share * 1200)).cards.wisps.size();
    std::size_t triangles = 0, triangles_on_scalp = 0, texels = 0, texels_on_scalp = 0;
    for (std::size_t i = 0; i < cards->wisps.size(); ++i) {
      const std::size_t covers = cards->textures[i].opacity.size();
      EXPECT_EQ(cards->strips[i].wisp, i);
      triangles += cards->strips[i].triangles();
      texels += covers;
      if (i + on_scalp < cards->wisps.size()) continue;
      triangles_on_scalp += cards->strips[i].triangles();
      texels_on_scalp += covers;
    }
    EXPECT_LE(triangles, 1200u);
    EXPECT_LE(float(triangles_on_scalp), share * 1200);
    EXPECT_LE(float(texels_on_scalp), 1.05f * share * float(texels));
    EXPECT_EQ(on_scalp > 0, share > 0);
  }
}

}  // namespace coif::cards::scalp_cards_test
