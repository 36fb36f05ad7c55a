#include "cook/fitted_wig.h"
#include "cook/recipe/recipe.h"
#include "cook/rig/fit_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

namespace coif::cook::fitted_weights_test {

std::vector<importer::SourceMesh> curtain() {
  std::vector<importer::SourceMesh> cards;
  for (int i = 0; i < 22; ++i) cards.push_back(make_tail(90 + 180.0 * i / 21, 0.35f, 150));
  return cards;
}

TEST(FittedWeights, AddUpToOneOnAtMostFourBones) {
  const FittedWig wig = fit_wig(curtain());
  ASSERT_GT(wig.rig.skeleton.chains.size(), 1u);
  for (const auto& weights : wig.rig.weights) {
    double sum = 0;
    for (const BoneWeight& w : weights) {
      EXPECT_GT(w.weight, 0);
      EXPECT_LT(w.bone, wig.rig.skeleton.bones.size());
      sum += w.weight;
    }
    EXPECT_NEAR(sum, 1, 1.0e-9);
    EXPECT_LE(weights.size(), 4u);
  }
}

TEST(FittedWeights, ChangeLittleFromVertexToVertex) {
  const FittedWig wig = fit_wig(curtain());
  double steepest = 0;
  for (std::size_t i = 0; i < wig.hair.triangles.size(); ++i) {
    const std::uint32_t a = wig.hair.triangles[i], b = wig.hair.triangles[i % 3 == 2 ? i - 2 : i + 1];
    const double length = (wig.hair.positions[a] - wig.hair.positions[b]).norm();
    // Over one bone's length the weights may go from one bone to the next, over a third of a radius to the next lock.
    steepest = std::max(steepest, wig.weight_difference(a, b) / std::max(length, 0.002));
  }
  EXPECT_GT(steepest, 5) << "something changes at all";
  EXPECT_LT(steepest, 1 / 0.06 + 1 / 0.03 + 25);
}

TEST(FittedWeights, ChangeLittleBetweenNeighbouringCards) {
  const std::vector<importer::SourceMesh> cards = curtain();
  const FittedWig wig = fit_wig(cards);
  const auto per_card = std::uint32_t(cards[0].positions.size());
  std::size_t pairs = 0;
  for (std::uint32_t card = 0; card + 1 < cards.size(); ++card) {
    for (std::uint32_t row = 0; row <= 150; row += 10) {
      for (std::uint32_t side = 0; side < 4; ++side) {
        const std::uint32_t a = card * per_card + 2 * row + side % 2;
        const std::uint32_t b = (card + 1) * per_card + 2 * row + side / 2;
        if ((wig.hair.positions[a] - wig.hair.positions[b]).norm() > 0.006f) continue;
        EXPECT_LT(wig.weight_difference(a, b), 0.35) << "cards " << card << " and the next, row " << row;
        ++pairs;
      }
    }
  }
  EXPECT_GT(pairs, 100u) << "the cards are not neighbours";
}

TEST(FittedWeights, OneLocksWeightsBecomeTheNextsOverCentimetres) {
  const FittedWig wig = fit_wig(curtain());
  const std::vector<ChainRecord>& chains = wig.rig.skeleton.chains;
  ASSERT_GT(chains.size(), 1u);
  const auto of_chain = [&](std::uint32_t v, std::size_t c) {
    double sum = 0;
    for (std::uint32_t b = 0; b < chains[c].bone_count; ++b) sum += wig.weight(v, chains[c].first_bone + b);
    return sum;
  };
  const auto heaviest = [&](std::uint32_t v) {
    std::size_t best = 0;
    for (std::size_t c = 1; c < chains.size(); ++c) best = of_chain(v, c) > of_chain(v, best) ? c : best;
    return best;
  };
  // Level with the middle of the hair: whose vertex is how far from the next lock's.
  std::vector<std::uint32_t> level;
  for (std::uint32_t v = 0; v < wig.hair.positions.size(); ++v) {
    if (std::abs(wig.hair.positions[v].y() - 1.4f) < 0.001f) level.push_back(v);
  }
  std::size_t looked_at = 0;
  for (const std::uint32_t v : level) {
    const std::size_t own = heaviest(v);
    float nearest = 1;
    for (const std::uint32_t w : level) {
      if (heaviest(w) != own) nearest = std::min(nearest, (wig.hair.positions[v] - wig.hair.positions[w]).norm());
    }
    if (nearest < 0.011f || nearest > 0.017f) continue;
    ++looked_at;
    EXPECT_LT(of_chain(v, own), 0.95) << "a third of the head's radius, 3 cm, goes from one to the next";
  }
  EXPECT_GT(looked_at, 0u);
}

TEST(FittedWeights, AreEqualAtOnePlace) {
  importer::SourceMesh left = make_strip({.root = {-0.01f, 1.6f, -0.105f}, .across = {0.02f, 0, 0}, .rows = 40});
  importer::SourceMesh right = make_strip({.root = {0.01f, 1.6f, -0.105f}, .across = {0.02f, 0, 0}, .rows = 40});
  for (auto& p : right.positions) p.x() += 4.0e-6f;  // within the weld distance
  const FittedWig wig = fit_wig({left, right});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  const auto first = std::uint32_t(left.positions.size());
  for (std::uint32_t row = 0; row <= 40; ++row) {
    EXPECT_EQ(wig.weight_difference(2 * row + 1, first + 2 * row), 0) << row;
  }
}

TEST(FittedWeights, MoveFromHeadToTipAlongTheCard) {
  const FittedWig wig = fit_wig({make_tail(180, 0.3f, 100)});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  const auto tip = std::uint32_t(wig.rig.skeleton.bones.size() - 1);
  EXPECT_DOUBLE_EQ(wig.weight(0, 0), 1) << "the root is rigid";
  EXPECT_DOUBLE_EQ(wig.weight(200, tip), 1) << "the tip is the last bone's";
  double before = 0;
  for (std::uint32_t row = 0; row <= 100; ++row) {
    double mean = 0;
    for (std::uint32_t b = 0; b <= tip; ++b) mean += b * wig.weight(2 * row, b);
    EXPECT_GE(mean, before - 0.05) << row;
    before = mean;
  }
}

TEST(FittedWeights, SeamToExcludedHairIsRigid) {
  importer::SourceMesh upper = make_strip({.root = {0, 1.6f, -0.105f}, .along = {0, -0.2f, 0}, .rows = 40});
  importer::SourceMesh lower = make_strip({.root = {0, 1.4f, -0.105f}, .along = {0, -0.3f, 0}, .rows = 40});
  upper.name = "band";
  lower.name = "tail";
  Recipe recipe = default_recipe();
  recipe.chain_exclude = {"band"};
  const FittedWig wig = fit_wig({upper, lower}, recipe);
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  EXPECT_NEAR(wig.joints(0).front().y(), 1.4, 0.015) << "the chain starts at the seam";
  const auto first = std::uint32_t(upper.positions.size());
  EXPECT_DOUBLE_EQ(wig.weight(first, 0), 1);
  EXPECT_DOUBLE_EQ(wig.weight(first + 1, 0), 1);
  EXPECT_LT(wig.weight(first + 40, 0), 0.01);
}

TEST(FittedWeights, TwoTailsShareNoBones) {
  const std::vector<importer::SourceMesh> tails = {make_tail(90, 0.3f), make_tail(-90, 0.3f)};
  const FittedWig wig = fit_wig(tails);
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 2u);
  const ChainRecord& right = wig.rig.skeleton.chains[1];
  for (std::uint32_t v = 0; v < tails[0].positions.size(); ++v) {
    for (std::uint32_t b = 0; b < right.bone_count; ++b) EXPECT_EQ(wig.weight(v, right.first_bone + b), 0);
  }
}

}  // namespace coif::cook::fitted_weights_test
