#include "cook/fitted_wig.h"
#include "cook/rig/fit_chains.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

namespace coif::fit_chains_test {

std::vector<SourceMesh> tails_around(int count, float length) {
  std::vector<SourceMesh> tails;
  for (int i = 0; i < count; ++i) tails.push_back(make_tail(360.0 * i / count, length));
  return tails;
}

/// Whether each joint of `a` has one of `b` within `reach`, and the other way round.
bool same_joints(const std::vector<Eigen::Vector3d>& a, const std::vector<Eigen::Vector3d>& b, double reach) {
  if (a.size() != b.size()) return false;
  for (std::size_t j = 0; j < a.size(); ++j) {
    if ((a[j] - b[j]).norm() > reach) return false;
  }
  return true;
}

TEST(FitChains, OneCardGetsOneChainOfItsFreeLengthDownwards) {
  const FittedWig wig = fit_wig({make_tail(180, 0.3f)});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  const auto joints = wig.joints(0);
  EXPECT_LT(joints.front().y(), 1.6);
  EXPECT_GT(joints.front().y(), 1.5) << "starts where the card leaves the head";
  EXPECT_NEAR(joints.back().y(), 1.3, 0.01);
  EXPECT_NEAR(wig.length(0), joints.front().y() - 1.3, 0.01) << "a straight card has a straight chain";
  for (const auto& joint : joints) {
    EXPECT_NEAR(joint.x(), 0, 0.002);
    EXPECT_NEAR(joint.z(), -0.105, 0.002);
  }
}

TEST(FitChains, BonesHaveTheLengthAskedFor) {
  Recipe recipe = default_recipe();
  recipe.chain_max_bones = 20;
  for (const double length : {0.03, 0.05, 0.1}) {
    recipe.chain_bone_length = length;
    const FittedWig wig = fit_wig({make_tail(180, 0.5f)}, recipe);
    ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
    for (const SkeletonBone& bone : wig.rig.skeleton.bones) {
      if (bone.kind != BoneKind::kSimulated) continue;
      EXPECT_NEAR(bone.length(), length, 0.25 * length);
    }
  }
}

TEST(FitChains, BonesFollowEachOtherFromTheHeadWithGrowingPlace) {
  const FittedWig wig = fit_wig({make_tail(90, 0.4f)});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  const auto& bones = wig.rig.skeleton.bones;
  EXPECT_EQ(bones[0].kind, BoneKind::kHead);
  for (std::uint32_t b = 1; b < bones.size(); ++b) {
    EXPECT_EQ(bones[b].parent, b - 1);
    EXPECT_EQ(bones[b].name, "left_1_" + std::to_string(b));
    EXPECT_GT(bones[b].place, bones[b - 1].place);
    if (b == 1) continue;
    EXPECT_EQ(bones[b].start, bones[b - 1].tail);
  }
  EXPECT_DOUBLE_EQ(bones.back().place, 1);
}

TEST(FitChains, TwoSeparateTailsGetTwoChainsNamedBySide) {
  const FittedWig wig = fit_wig({make_tail(100, 0.3f), make_tail(-100, 0.3f)});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 2u);
  EXPECT_EQ(wig.rig.skeleton.bones[wig.rig.skeleton.chains[0].first_bone].name, "left_1_1");
  EXPECT_EQ(wig.rig.skeleton.bones[wig.rig.skeleton.chains[1].first_bone].name, "right_1_1");
  EXPECT_GT(wig.joints(0).front().x(), 0.09);
  EXPECT_LT(wig.joints(1).front().x(), -0.09);
}

TEST(FitChains, NamesSayWhereOnTheHead) {
  const std::vector<std::pair<double, std::string>> sides = {
      {0, "front"},  {45, "front_left"},   {90, "left"},   {135, "back_left"},
      {180, "back"}, {-135, "back_right"}, {-90, "right"}, {-45, "front_right"}};
  for (const auto& [degrees, side] : sides) {
    const FittedWig wig = fit_wig({make_tail(degrees, 0.3f)});
    ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u) << degrees;
    EXPECT_EQ(wig.rig.skeleton.bones[1].name, side + "_1_1");
  }
}

TEST(FitChains, ManyCardsOfOnePonyTailAreOneChain) {
  std::vector<SourceMesh> cards;
  for (int i = 0; i < 12; ++i) {
    SourceMesh card = make_tail(180 + 2 * (i - 6), 0.3f);
    for (auto& p : card.positions) p.z() -= 0.002f * float(i % 4);
    cards.push_back(card);
  }
  EXPECT_EQ(fit_wig(cards).rig.skeleton.chains.size(), 1u);
}

TEST(FitChains, CapThatHugsTheSkullGetsNone) {
  std::vector<SourceMesh> cap;
  for (int i = 0; i < 30; ++i) cap.push_back(make_scalp_strip(12.0 * i));
  const FittedWig wig = fit_wig(cap);
  EXPECT_TRUE(wig.rig.skeleton.chains.empty());
  EXPECT_EQ(wig.rig.skeleton.bones.size(), 1u);
  ASSERT_EQ(wig.rig.notes.size(), 1u);
  EXPECT_NE(wig.rig.notes[0].find("no chain was fitted"), std::string::npos);
  for (std::uint32_t v = 0; v < wig.hair.positions.size(); ++v) EXPECT_DOUBLE_EQ(wig.weight(v, 0), 1);
}

TEST(FitChains, HairShorterThanTheLimitFollowsTheHead) {
  Recipe recipe = default_recipe();
  recipe.chain_shortest = 0.1;
  const FittedWig wig = fit_wig({make_tail(90, 0.3f), make_tail(-90, 0.12f)}, recipe);
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  const auto first = std::uint32_t(make_tail(90, 0.3f).positions.size());
  for (std::uint32_t v = first; v < wig.hair.positions.size(); ++v) EXPECT_DOUBLE_EQ(wig.weight(v, 0), 1);
}

TEST(FitChains, BudgetOfChainsAndBonesHolds) {
  Recipe recipe = default_recipe();
  recipe.chain_bone_length = 0.01;
  for (const std::uint32_t most : {1u, 3u, 5u}) {
    recipe.chain_max_count = most;
    recipe.chain_max_bones = most;
    const FittedWig wig = fit_wig(tails_around(8, 0.3f), recipe);
    EXPECT_EQ(wig.rig.skeleton.chains.size(), most);
    for (const ChainRecord& chain : wig.rig.skeleton.chains) EXPECT_LE(chain.bone_count, most);
  }
}

TEST(FitChains, NeverMakesMoreBonesThanAnAssetHolds) {
  Recipe recipe = default_recipe();
  recipe.chain_bone_length = 0.0005;
  recipe.chain_max_bones = 1000;
  const FittedWig wig = fit_wig(tails_around(16, 0.5f), recipe);
  EXPECT_GT(900 * wig.rig.skeleton.chains.size(), kMaxBones) << "so few chains could not pass the limit";
  EXPECT_LE(wig.rig.skeleton.bones.size(), kMaxBones);
}

TEST(FitChains, CurvedTailGetsACurvedChain) {
  SourceMesh tail = make_tail(180, 0.4f);
  const double radius = 0.4 / 3;  // 3 radians of a circle
  for (auto& p : tail.positions) {
    const double angle = double(1.6f - p.y()) / radius;
    p = {p.x(), float(1.6 - radius * std::sin(angle)), float(p.z() - radius * (1 - std::cos(angle)))};
  }
  const FittedWig wig = fit_wig({tail});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  const auto joints = wig.joints(0);
  EXPECT_GT(joints.back().y(), joints[joints.size() / 2].y()) << "the tip turns up again";
  const Eigen::Vector3d middle(0, 1.6, -0.105 - radius);
  for (const auto& joint : joints) EXPECT_NEAR((joint - middle).norm(), radius, 0.01);
}

TEST(FitChains, EveryParticleIsOutsideOfTheHead) {
  std::vector<SourceMesh> tails = tails_around(6, 0.3f);
  Recipe recipe = default_recipe();
  recipe.chain_max_count = 1;  // the middle of a ring of tails is in the head
  const FittedWig wig = fit_wig(tails, recipe);
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  for (const auto& joint : wig.joints(0)) EXPECT_GT(round_head().distance(joint), 0);
}

TEST(FitChains, EndOfATailBehindARibbonHangsFromTheTail) {
  SourceMesh upper = make_tail(180, 0.3f), lower = upper;
  for (auto& p : lower.positions) p.y() -= 0.32f;
  const FittedWig wig = fit_wig({upper, lower});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  EXPECT_NEAR(wig.joints(0).back().y(), 1.6 - 0.62, 0.01);
}

TEST(FitChains, StrandsThatPartAndAreTiedAgainAreOneChainToTheEnd) {
  SourceMesh straight = make_tail(180, 0.3f), bulging = straight, below = straight;
  for (auto& p : bulging.positions) p.z() -= 0.12f * std::sin((1.6f - p.y()) / 0.3f * std::numbers::pi_v<float>);
  for (auto& p : below.positions) p.y() -= 0.3f;
  const FittedWig wig = fit_wig({straight, bulging, below});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  EXPECT_NEAR(wig.joints(0).back().y(), 1.0, 0.02);
}

TEST(FitChains, MirroredModelGetsMirroredChains) {
  const std::vector<SourceMesh> tails = {make_tail(80, 0.3f), make_tail(150, 0.4f), make_tail(-120, 0.25f)};
  const FittedWig wig = fit_wig(tails), other = fit_wig(mirrored(tails));
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 3u);
  ASSERT_EQ(other.rig.skeleton.chains.size(), 3u);
  for (std::uint32_t c = 0; c < 3; ++c) {
    auto joints = wig.joints(c);
    for (auto& joint : joints) joint.x() = -joint.x();
    bool found = false;
    for (std::uint32_t d = 0; d < 3; ++d) found = found || same_joints(joints, other.joints(d), 1.0e-4);
    EXPECT_TRUE(found) << "chain " << c;
  }
}

TEST(FitChains, TriangulationDoesNotMatter) {
  const FittedWig coarse = fit_wig({make_tail(180, 0.4f, 4)}), fine = fit_wig({make_tail(180, 0.4f, 400)});
  ASSERT_EQ(coarse.rig.skeleton.chains.size(), 1u);
  ASSERT_EQ(fine.rig.skeleton.chains.size(), 1u);
  EXPECT_TRUE(same_joints(coarse.joints(0), fine.joints(0), 0.005));
}

TEST(FitChains, OnlyAndExcludeChooseMeshesByName) {
  std::vector<SourceMesh> tails = {make_tail(90, 0.3f), make_tail(-90, 0.3f)};
  tails[0].name = "tail";
  tails[1].name = "ribbon";
  Recipe only = default_recipe(), exclude = default_recipe();
  only.chain_only = {"tail*"};
  exclude.chain_exclude = {"RIBBON"};
  const auto first_of_ribbon = std::uint32_t(tails[0].positions.size());
  for (const Recipe& recipe : {only, exclude}) {
    const FittedWig wig = fit_wig(tails, recipe);
    ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
    EXPECT_GT(wig.joints(0).front().x(), 0);
    for (std::uint32_t v = first_of_ribbon; v < wig.hair.positions.size(); ++v) {
      EXPECT_DOUBLE_EQ(wig.weight(v, 0), 1);
    }
  }
}

TEST(FitChains, HairWithoutTrianglesOrExtentIsRigid) {
  EXPECT_TRUE(fit_wig({}).rig.skeleton.chains.empty());
  SourceMesh point = make_tail(180, 0.3f);
  for (auto& p : point.positions) p = {0, 1.5f, -0.2f};
  EXPECT_TRUE(fit_wig({point}).rig.skeleton.chains.empty());
}

/// Cards side by side around the back of the head, each 2 cm wide, finely cut.
std::vector<SourceMesh> curtain() {
  std::vector<SourceMesh> cards;
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
  const std::vector<SourceMesh> cards = curtain();
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

TEST(FittedWeights, AreEqualAtOnePlace) {
  SourceMesh left = make_strip({.root = {-0.01f, 1.6f, -0.105f}, .across = {0.02f, 0, 0}, .rows = 40});
  SourceMesh right = make_strip({.root = {0.01f, 1.6f, -0.105f}, .across = {0.02f, 0, 0}, .rows = 40});
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
  SourceMesh upper = make_strip({.root = {0, 1.6f, -0.105f}, .along = {0, -0.2f, 0}, .rows = 40});
  SourceMesh lower = make_strip({.root = {0, 1.4f, -0.105f}, .along = {0, -0.3f, 0}, .rows = 40});
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
  const std::vector<SourceMesh> tails = {make_tail(90, 0.3f), make_tail(-90, 0.3f)};
  const FittedWig wig = fit_wig(tails);
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 2u);
  const ChainRecord& right = wig.rig.skeleton.chains[1];
  for (std::uint32_t v = 0; v < tails[0].positions.size(); ++v) {
    for (std::uint32_t b = 0; b < right.bone_count; ++b) EXPECT_EQ(wig.weight(v, right.first_bone + b), 0);
  }
}

}  // namespace coif::fit_chains_test
