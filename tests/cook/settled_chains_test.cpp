// Which locks are divided, which get no chain, and which chains are mirror images.

#include "cook/fitted_wig.h"
#include "cook/recipe/recipe.h"
#include "cook/rig/fit_chains.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace coif::cook::settled_chains_test {

using Eigen::Vector3d;

constexpr double kCell = 0.01;

/// Adds a cell of hair at a point; returns its number.
std::uint32_t add_cell(HangingHair& hair, const Vector3d& at, double depth) {
  const Vector3d index = (at - hair.cells.origin) / kCell;
  hair.cells.index.push_back({std::llround(index.x()), std::llround(index.y()), std::llround(index.z())});
  hair.cells.middle.push_back(at);
  hair.cells.area.push_back(1.0e-4);
  hair.depth.push_back(depth);
  hair.from.push_back(importer::kNoIndex);
  hair.cells.strand.push_back(-Vector3d::UnitY());
  hair.cells.link_begin.push_back(0);  // nothing is linked
  return std::uint32_t(hair.cells.count() - 1);
}

HangingHair no_hair() {
  HangingHair hair;
  hair.cells.size = kCell;
  hair.cells.origin = round_head().center;
  hair.cells.link_begin = {0};
  return hair;
}

/// One lock of hair that hangs for 0.1 m from `from` to `to` degrees around the head.
HairLock add_skirt(HangingHair& hair, double from, double to) {
  HairLock lock;
  for (double degrees = from; degrees < to; degrees += 5) {
    const double angle = degrees * std::numbers::pi / 180;
    for (int row = 1; row <= 10; ++row) {
      const Vector3d at(0.13 * std::sin(angle), 1.6 - 0.01 * row, 0.13 * std::cos(angle));
      lock.cells.push_back(add_cell(hair, at, 0.01 * row));
    }
  }
  lock.length = 0.1;
  lock.moves = true;
  return lock;
}

/// A tube of hair of this radius along a line, and its chain.
HairLock add_tube(HangingHair& hair, const Vector3d& start, const Vector3d& way, double radius, LockCurve& curve) {
  const Vector3d side = way.normalized().unitOrthogonal(), other = way.normalized().cross(side);
  HairLock lock;
  for (int row = 0; row <= 20; ++row) {
    for (int turn = 0; turn < 12; ++turn) {
      const double angle = 2 * std::numbers::pi * turn / 12;
      const Vector3d out = radius * (std::cos(angle) * side + std::sin(angle) * other);
      lock.cells.push_back(add_cell(hair, start + way * (row / 20.0) + out, way.norm() * row / 20.0));
    }
  }
  lock.length = way.norm();
  lock.moves = true;
  curve.joints = {start, start + 0.5 * way, start + way};
  curve.depth = {0, 0.5 * way.norm(), way.norm()};
  return lock;
}

std::vector<HairLock> divided(HangingHair& hair, const HairLock& lock, std::uint32_t most = 16) {
  Recipe recipe = default_recipe();
  recipe.chain_max_count = most;
  return divide_wide_locks(hair, {lock}, round_head(), recipe);
}

TEST(SettledChains, AShellAroundTheHeadIsDividedByAngle) {
  HangingHair hair = no_hair();
  const HairLock skirt = add_skirt(hair, 0, 360);
  const std::vector<HairLock> parts = divided(hair, skirt);
  ASSERT_EQ(parts.size(), 6u);
  std::set<std::uint32_t> all;
  for (const HairLock& part : parts) {
    EXPECT_TRUE(part.moves);
    EXPECT_EQ(part.cells.size(), skirt.cells.size() / 6);
    all.insert(part.cells.begin(), part.cells.end());
  }
  EXPECT_EQ(all.size(), skirt.cells.size()) << "each cell is in one part";
}

TEST(SettledChains, TheChainOfAPartHangsInItsMiddle) {
  HangingHair hair = no_hair();
  const HairLock skirt = add_skirt(hair, 90, 270);
  for (const std::uint32_t c : skirt.cells) {  // deeper towards one side, as where the other touches the scalp
    hair.depth[c] += 0.2 * std::max(0.0, hair.cells.middle[c].x());
  }
  for (const HairLock& part : divided(hair, skirt)) {
    const LockCurve curve = fit_lock_curve(hair, part, round_head(), default_recipe(), 8);
    ASSERT_GE(curve.joints.size(), 2u);
    const Vector3d way = curve.joints.back() - curve.joints.front();
    EXPECT_LT(std::hypot(way.x(), way.z()), 0.3 * -way.y()) << "it descends";
  }
}

TEST(SettledChains, PartsLieBetweenTheEndsOfAShell) {
  HangingHair hair = no_hair();
  EXPECT_EQ(divided(hair, add_skirt(hair, 90, 270)).size(), 3u);
  HangingHair narrow = no_hair();
  EXPECT_EQ(divided(narrow, add_skirt(narrow, 150, 210)).size(), 1u);
}

TEST(SettledChains, DividingKeepsTheBudgetOfChains) {
  HangingHair hair = no_hair();
  const HairLock skirt = add_skirt(hair, 0, 360);
  EXPECT_EQ(divided(hair, skirt, 4).size(), 4u);
  EXPECT_EQ(divided(hair, skirt, 1).size(), 1u);
}

TEST(SettledChains, BunsAndHairDressedUpAreRigid) {
  const FittedHead head = round_head();
  const auto keeps = [&](const Vector3d& start, const Vector3d& way, double radius) {
    HangingHair hair = no_hair();
    std::vector<LockCurve> curves(1);
    const std::vector<HairLock> locks = {add_tube(hair, start, way, radius, curves[0])};
    settle_curves(hair, locks, head, curves);
    return !curves[0].joints.empty();
  };
  const Vector3d top(0, 1.7, 0), back(0, 1.62, -0.1);
  EXPECT_FALSE(keeps(top, {0, 0.08, -0.02}, 0.045)) << "a bun on top";
  EXPECT_FALSE(keeps(back, {0, 0, -0.07}, 0.04)) << "a bun at the back";
  EXPECT_TRUE(keeps(top, {0, 0.15, 0}, 0.008)) << "one thin lock that stands up";
  EXPECT_TRUE(keeps(back, {0, -0.2, -0.05}, 0.03)) << "a tail";
  EXPECT_TRUE(keeps({0.13, 1.6, 0}, {0, -0.07, 0}, 0.05)) << "hair that hangs, if wide";
}

TEST(SettledChains, NoChainRunsAlongAHem) {
  HangingHair hair = no_hair();
  std::vector<LockCurve> curves(1);
  const std::vector<HairLock> locks = {add_tube(hair, {-0.1, 1.5, -0.1}, {0.2, -0.02, 0}, 0.01, curves[0])};
  settle_curves(hair, locks, round_head(), curves);
  EXPECT_TRUE(curves[0].joints.empty());
}

TEST(SettledChains, MirrorImagesGetMirrorChains) {
  HangingHair hair = no_hair();
  std::vector<LockCurve> curves(2);
  const Vector3d right(-0.12, 1.55, 0.003), left(0.12, 1.55, -0.003);
  const std::vector<HairLock> locks = {add_tube(hair, left, {0.02, -0.15, 0}, 0.02, curves[0]),
                                       add_tube(hair, right, {-0.02, -0.15, 0}, 0.02, curves[1])};
  curves[1].joints.erase(curves[1].joints.begin() + 1);  // one bone where the other has two
  curves[1].depth.erase(curves[1].depth.begin() + 1);
  settle_curves(hair, locks, round_head(), curves);
  ASSERT_EQ(curves[0].joints.size(), 3u);
  ASSERT_EQ(curves[1].joints.size(), 3u);
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector3d image(-curves[0].joints[j].x(), curves[0].joints[j].y(), curves[0].joints[j].z());
    EXPECT_LT((curves[1].joints[j] - image).norm(), 1.0e-12) << j;
    EXPECT_NEAR(curves[0].depth[j], curves[1].depth[j], 1.0e-9) << j;
  }
}

TEST(SettledChains, ALockThatIsItsOwnImageHangsInTheMiddle) {
  HangingHair hair = no_hair();
  std::vector<LockCurve> curves(1);
  const std::vector<HairLock> locks = {add_tube(hair, {0, 1.55, -0.12}, {0, -0.2, 0}, 0.02, curves[0])};
  for (Vector3d& joint : curves[0].joints) joint.x() = 0.004;
  settle_curves(hair, locks, round_head(), curves);
  ASSERT_FALSE(curves[0].joints.empty());
  for (const Vector3d& joint : curves[0].joints) EXPECT_EQ(joint.x(), 0);
}

}  // namespace coif::cook::settled_chains_test
