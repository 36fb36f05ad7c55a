// How sure the cook is of roots, and what it says of them.

#include "cook/strands/strand_evidence.h"

#include "cook/built_models.h"
#include "cook/fitted_wig.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace coif::cook::root_doubts_test {

using Eigen::Vector3f;

/// Two strips that hang on both sides of a round head, one triangle each.
struct TwoSides {
  HairMesh mesh;
  std::vector<PatchView> views{{{0}, {0, 1, 2}}, {{3}, {3, 4, 5}}};
  PatchCompany company;
  std::vector<FoundRoot> found{{0.002f, 0.9f, 1}, {0.002f, 0.9f, 1}};

  TwoSides() {
    for (const float side : {-1.0f, 1.0f}) {
      for (const Vector3f& p : {Vector3f(0.11f, 1.6f, 0), Vector3f(0.11f, 1.5f, 0), Vector3f(0.11f, 1.5f, 0.02f)}) {
        mesh.positions.emplace_back(side * p.x(), p.y(), p.z());
      }
    }
    mesh.triangles = {0, 1, 2, 3, 4, 5};
    company.beside.resize(2);
    company.mirrored = {{{1, 1.0f}}, {{0, 1.0f}}};
  }

  [[nodiscard]] RootDoubts doubts(const Vector3f& way = {0, -1, 0}) const {
    const std::vector<Vector3f> tangents(6, way);
    return doubts_of(mesh, views, found, company, tangents, round_head());
  }
};

TEST(RootDoubts, HairThatHangsAlikeOnBothSidesIsSure) {
  const RootDoubts doubts = TwoSides().doubts();
  EXPECT_GT(doubts.probability(), 0.9);
  EXPECT_EQ(doubts.reason(), "nothing speaks against them");
}

TEST(RootDoubts, PatchesOfWhichNothingSpokeAreSaid) {
  TwoSides two;
  two.found[1].belief = 0.05f;
  EXPECT_DOUBLE_EQ(two.doubts().unsure, 0.5);
  EXPECT_NE(two.doubts().reason().find("nothing says where 50 % of the hair has its roots"), std::string::npos);
}

TEST(RootDoubts, HairThatRunsUpBelowTheHeadIsWarnedOf) {
  const RootDoubts doubts = TwoSides().doubts({0, 1, 0});
  EXPECT_DOUBLE_EQ(doubts.rises, 1);
  EXPECT_LT(doubts.probability(), kSureEnough);
  EXPECT_EQ(doubts.reason().find("100 % of the hair below the head's centre runs upwards"), 0u);
}

TEST(RootDoubts, MirrorImagesThatRunAgainstEachOtherAreWarnedOf) {
  TwoSides two;
  two.found[1].belief = -0.9f;
  EXPECT_GT(two.doubts().against_mirror, 0.8);
  EXPECT_LT(two.doubts().probability(), kSureEnough);
  TwoSides shell;
  for (FoundRoot& found : shell.found) found.mirrored = -1;
  EXPECT_DOUBLE_EQ(shell.doubts().against_mirror, 1) << "the two halves of one shell";
}

TEST(RootDoubts, WhatTheRecipeToldIsNotDoubted) {
  TwoSides two;
  two.found[1].belief = -0.9f;
  for (FoundRoot& found : two.found) found.is_told = true;
  EXPECT_DOUBLE_EQ(two.doubts().against_mirror, 0);
  EXPECT_EQ(decision_of({}, 1, 0, 3).chosen, "the ends that fit best, of 2 of 3 patches");
}

TEST(RootBeliefs, AMirrorImageSaysWhereTheRootIs) {
  const TwoSides two;
  const std::vector<RootVote> votes = {{-1, 2.0f, 1, 1}, {-1, 0.0f, 1, 1}};
  const std::vector<float> belief = settle_beliefs(two.mesh, two.views, votes, two.company, {}, {});
  EXPECT_GT(belief[0], 0.9f);
  EXPECT_GT(belief[1], 0.3f) << "nothing of its own";
  PatchCompany opposite = two.company;  // its low end is where the image has its high end
  for (auto& of_patch : opposite.mirrored) of_patch[0].agreement = -1;
  EXPECT_LT(settle_beliefs(two.mesh, two.views, votes, opposite, {}, {})[1], -0.3f);
}

TEST(RootBeliefs, TwinsBelieveTheSame) {
  TwoSides two;
  two.company.mirrored.assign(2, {});
  two.company.twins = {{1, -1.0f}, {0, -1.0f}};  // the low end of one is the high end of the other
  const std::vector<RootVote> votes = {{-1, 0.3f, 1, 1}, {-1, 0.9f, 1, 1}};
  const std::vector<float> belief = settle_beliefs(two.mesh, two.views, votes, two.company, {}, {});
  EXPECT_FLOAT_EQ(belief[0], -belief[1]);
  EXPECT_GT(belief[1], 0.2f) << "the one that is surer is believed";
}

TEST(RootEvidence, HeightCountsMoreOnAShell) {
  RootEvidence evidence;
  evidence.height = 1;
  const RootWeights weights;
  const float alone = evidence.sum(weights);
  evidence.of_shell = true;
  EXPECT_GT(evidence.sum(weights), alone);
}

}  // namespace coif::cook::root_doubts_test
