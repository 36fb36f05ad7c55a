#include "cook/rig/fit_chains.h"
#include "cook/fitted_wig.h"
#include "cook/recipe/recipe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

namespace coif::cook::fit_chains_test {

std::vector<importer::SourceMesh> tails_around(int count, float length) {
  std::vector<importer::SourceMesh> tails;
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
  std::vector<importer::SourceMesh> cards;
  for (int i = 0; i < 12; ++i) {
    importer::SourceMesh card = make_tail(180 + 2 * (i - 6), 0.3f);
    for (auto& p : card.positions) p.z() -= 0.002f * float(i % 4);
    cards.push_back(card);
  }
  EXPECT_EQ(fit_wig(cards).rig.skeleton.chains.size(), 1u);
}

TEST(FitChains, CapThatHugsTheSkullGetsNone) {
  std::vector<importer::SourceMesh> cap;
  for (int i = 0; i < 30; ++i) cap.push_back(make_scalp_strip(12.0 * i));
  const FittedWig wig = fit_wig(cap);
  EXPECT_TRUE(wig.rig.skeleton.chains.empty());
  EXPECT_EQ(wig.rig.skeleton.bones.size(), 1u);
  ASSERT_EQ(wig.findings.notes.size(), 1u);
  EXPECT_NE(wig.findings.notes[0].find("no chain was fitted"), std::string::npos);
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

TEST(FitChains, AFewWispsAreCarriedOnByTheLastBone) {
  for (const auto& [share, end] : {std::pair{0.5f, 1.2}, {0.1f, 1.3}}) {
    importer::SourceMesh tail = make_tail(180, 0.4f, 400);
    for (auto& p : tail.positions) p.x() *= p.y() < 1.3f ? share : 1;
    const FittedWig wig = fit_wig({tail});
    ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
    EXPECT_NEAR(wig.joints(0).back().y(), end, 0.015) << share << " of the width from three quarters on";
  }
}

TEST(FitChains, CurvedTailGetsACurvedChain) {
  importer::SourceMesh tail = make_tail(180, 0.4f);
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
  std::vector<importer::SourceMesh> tails = tails_around(6, 0.3f);
  Recipe recipe = default_recipe();
  recipe.chain_max_count = 1;  // the middle of a ring of tails is in the head
  const FittedWig wig = fit_wig(tails, recipe);
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  for (const auto& joint : wig.joints(0)) EXPECT_GT(round_head().distance(joint), 0);
}

TEST(FitChains, EndOfATailBehindARibbonHangsFromTheTail) {
  importer::SourceMesh upper = make_tail(180, 0.3f), lower = upper;
  for (auto& p : lower.positions) p.y() -= 0.32f;
  const FittedWig wig = fit_wig({upper, lower});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  EXPECT_NEAR(wig.joints(0).back().y(), 1.6 - 0.62, 0.01);
}

TEST(FitChains, StrandsThatPartAndAreTiedAgainAreOneChainToTheEnd) {
  importer::SourceMesh straight = make_tail(180, 0.3f), bulging = straight, below = straight;
  for (auto& p : bulging.positions) p.z() -= 0.12f * std::sin((1.6f - p.y()) / 0.3f * std::numbers::pi_v<float>);
  for (auto& p : below.positions) p.y() -= 0.3f;
  const FittedWig wig = fit_wig({straight, bulging, below});
  ASSERT_EQ(wig.rig.skeleton.chains.size(), 1u);
  EXPECT_NEAR(wig.joints(0).back().y(), 1.0, 0.02);
}

TEST(FitChains, MirroredModelGetsMirroredChains) {
  const std::vector<importer::SourceMesh> tails = {make_tail(80, 0.3f), make_tail(150, 0.4f), make_tail(-120, 0.25f)};
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
  std::vector<importer::SourceMesh> tails = {make_tail(90, 0.3f), make_tail(-90, 0.3f)};
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
  importer::SourceMesh point = make_tail(180, 0.3f);
  for (auto& p : point.positions) p = {0, 1.5f, -0.2f};
  EXPECT_TRUE(fit_wig({point}).rig.skeleton.chains.empty());
}

/// Cards side by side around the back of the head, each 2 cm wide, finely cut.

}  // namespace coif::cook::fit_chains_test
