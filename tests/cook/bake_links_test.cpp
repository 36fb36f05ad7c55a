// Which chains are linked, and how: trees of pairs, from their middle on, depth by depth.

#include "cook/dynamics/bake_links.h"

#include "cook/recipe/recipe.h"
#include "cook/told.h"
#include "models/small_asset.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace coif::cook::bake_links_test {

using Pairs = std::vector<ChainPair>;
using BonesOfLinks = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

/// Chains that hang down from a head at places along X, in bones of 0.1 m.
class BakeLinks : public testing::Test {
 protected:
  BakeLinks() : recipe_(default_recipe()) {
    hair_.bones = rigid_bones(1);
    hair_.bone_names = {"head"};
    hair_.skeleton.head_rotation[3] = 1;
  }

  /// `parents` are those inside the chain; empty: `bones` one below the other. Bones are called "a.0", "a.1",
  /// "b.0", ...
  void hang(float x, std::uint32_t bones, std::vector<std::uint32_t> parents = {}) {
    const auto chain = std::uint32_t(hair_.chains.size()), first = std::uint32_t(hair_.bones.size());
    for (std::uint32_t i = 0; i < bones; ++i) {
      const std::uint32_t above = i == 0 ? kNone : first + (parents.empty() ? i - 1 : parents[i]);
      BoneRecord bone{};
      bone.parent = above == kNone ? 0 : above;
      bone.kind = BoneKind::kSimulated;
      bone.chain = chain;
      bone.name = kNone;
      bone.length = 0.1f;
      bone.rest_direction[1] = -1;
      bone.joint[0] = x;
      if (above != kNone) bone.joint[1] = hair_.bones[above].joint[1] - 0.1f;
      hair_.bones.push_back(bone);
      hair_.bone_names.push_back(std::string(1, char('a' + chain)) + "." + std::to_string(i));
    }
    hair_.chains.push_back({first, bones, 0, {}});
  }

  /// As deep as the chains are, or at most `depths`.
  [[nodiscard]] LinkForest link(const Pairs& pairs, std::uint32_t depths = kNone) const {
    LinkedDepths linked;
    for (const ChainPair& pair : pairs) linked[pair] = depths;
    return link_chains(hair_, linked, {0.1, 0.5});
  }

  /// What an asset of this hair says to links.
  [[nodiscard]] LoadCode opened(std::vector<LinkRecord> links) const {
    AssetContents asset = hair_;
    asset.links = std::move(links);
    asset.dynamics.assign(asset.bones.size(), small_asset().dynamics[2]);
    return open_written(asset).code;
  }

  [[nodiscard]] auto bake(const std::string& links) {
    const auto recipe = parse_recipe(R"({"dynamics": {"links": )" + links + "}}", "r.json");
    EXPECT_TRUE(recipe) << (recipe ? "" : recipe.error().message);
    if (recipe) recipe_ = *recipe;
    return told([&](Findings& findings) { return bake_links("hair.glb", {}, {}, hair_, recipe_, findings); });
  }

  [[nodiscard]] std::string refusal_of(const std::string& links) {
    const auto baked = bake(links);
    return baked.made ? "" : baked.made.error().message;
  }

  AssetContents hair_;
  Recipe recipe_;
};

BonesOfLinks bones_of(const std::vector<LinkRecord>& links) {
  BonesOfLinks bones;
  for (const LinkRecord& link : links) bones.emplace_back(link.bone, link.to);
  return bones;
}

TEST_F(BakeLinks, GoDepthByDepthAndKeepTheDistanceAtRestWithRoomAroundIt) {
  hang(0, 2);      // bones 1, 2
  hang(0.04f, 2);  // bones 3, 4
  const LinkForest forest = link({{0, 1}});
  EXPECT_EQ(bones_of(forest.links), (BonesOfLinks{{3, 1}, {4, 2}}));
  for (const LinkRecord& record : forest.links) {
    EXPECT_FLOAT_EQ(record.shortest, 0.02f);
    EXPECT_FLOAT_EQ(record.longest, 0.044f);
  }
  EXPECT_EQ(forest.linked, (std::vector<ChainPair>{{0, 1}}));
  EXPECT_EQ(opened(forest.links), LoadCode::kOk);
}

TEST_F(BakeLinks, StartInTheMiddleOfARow) {
  for (int i = 0; i < 5; ++i) hang(0.0625f * float(i), 1);  // bones 1 to 5
  EXPECT_EQ(bones_of(link({{0, 1}, {1, 2}, {2, 3}, {3, 4}}).links), (BonesOfLinks{{2, 3}, {4, 3}, {1, 2}, {5, 4}}));
  hang(0.3125f, 1);
  EXPECT_EQ(link({{0, 1}, {1, 2}, {2, 3}, {3, 4}, {4, 5}}).links.size(), 5u) << "of two middles either will do";
}

TEST_F(BakeLinks, OfTwoMiddlesTheLongerChainCarriesTheOther) {
  hang(0, 1);      // bone 1
  hang(0.03f, 3);  // bones 2 to 4
  EXPECT_EQ(bones_of(link({{0, 1}}).links), (BonesOfLinks{{1, 2}}));
}

TEST_F(BakeLinks, LeaveTheWidestPairOfACircleOut) {
  hang(0, 2);
  hang(0.03f, 2);
  hang(0.07f, 2);
  const LinkForest forest = link({{0, 1}, {1, 2}, {0, 2}});
  EXPECT_EQ(forest.roundabout, (std::vector<ChainPair>{{0, 2}}));
  EXPECT_EQ(forest.linked, (std::vector<ChainPair>{{0, 1}, {1, 2}}));
  EXPECT_EQ(forest.links.size(), 4u);
  EXPECT_EQ(opened(forest.links), LoadCode::kOk);
}

TEST_F(BakeLinks, EndWhereTheShorterChainDoes) {
  hang(0, 3);      // bones 1 to 3
  hang(0.03f, 1);  // bone 4
  hang(0.06f, 3);  // bones 5 to 7
  const LinkForest forest = link({{0, 1}, {1, 2}});
  EXPECT_EQ(bones_of(forest.links), (BonesOfLinks{{1, 4}, {5, 4}})) << "nothing holds the outer ones together below";
  EXPECT_EQ(opened(forest.links), LoadCode::kOk);
}

TEST_F(BakeLinks, ReachAcrossAChainThatHasEndedWhereAPairIsThere) {
  hang(0, 3);      // bones 1 to 3
  hang(0.03f, 1);  // bone 4
  hang(0.06f, 3);  // bones 5 to 7
  const LinkForest forest = link({{0, 1}, {1, 2}, {0, 2}});
  EXPECT_EQ(bones_of(forest.links), (BonesOfLinks{{1, 4}, {5, 4}, {6, 2}, {7, 3}}));
  EXPECT_TRUE(forest.roundabout.empty());
  EXPECT_EQ(opened(forest.links), LoadCode::kOk);
}

TEST_F(BakeLinks, GoNoDeeperThanWhatIsBetweenTheChains) {
  hang(0, 3);      // bones 1 to 3
  hang(0.03f, 3);  // bones 4 to 6
  EXPECT_EQ(bones_of(link({{0, 1}}, 2).links), (BonesOfLinks{{4, 1}, {5, 2}}));
}

TEST_F(BakeLinks, OfAChainThatBranchesHoldEachBoneOnce) {
  hang(0, 3, {kNone, 0, 0});      // bones 1 > (2, 3)
  hang(0.03f, 3, {kNone, 0, 0});  // bones 4 > (5, 6)
  hair_.bones[3].joint[0] = -0.05f;
  hair_.bones[3].rest_direction[0] = -1, hair_.bones[3].rest_direction[1] = 0;
  const LinkForest forest = link({{0, 1}});
  // Bones 1 and 2 are those that hang straight down; of 5 and 6, which end at one place, both go to the nearest,
  // which is 2.
  EXPECT_EQ(bones_of(forest.links), (BonesOfLinks{{4, 1}, {5, 2}, {6, 2}}));
}

TEST_F(BakeLinks, OfBonesThatEndAtOnePlaceAreLeftOut) {
  hang(0, 2);
  hang(0.05f, 2);
  hair_.bones[4].joint[0] = 0;  // the second chain's tip bends back to the first one's
  const LinkForest forest = link({{0, 1}});
  EXPECT_EQ(bones_of(forest.links), (BonesOfLinks{{3, 1}}));
  EXPECT_EQ(bones_of(forest.touching), (BonesOfLinks{{4, 2}}));
  const auto baked = bake(R"([["a.0", "b.0"]])");
  ASSERT_EQ(baked.notes.size(), 2u);
  EXPECT_EQ(baked.notes[0], "1 link of 2 chains, so that they stay beside each other: 'a.0' and 'b.0'");
  EXPECT_EQ(baked.notes[1], "1 link left out, since both bones end at one place: the first 'b.1' and 'a.1'");
}

/// Any forest of any chains is one that an asset may have.
TEST_F(BakeLinks, OfEveryPairAreWhatTheFormatAllows) {
  for (const std::uint32_t bones : {3u, 1u, 4u, 2u, 4u, 1u, 3u})
    hang(0.01f * float(hair_.chains.size() * bones % 11), bones);
  hang(0.2f, 7, {kNone, 0, 0, 1, 1, 2, 2});
  Pairs all;
  for (std::uint32_t one = 0; one < 8; ++one) {
    for (std::uint32_t other = one + 1; other < 8; ++other) all.emplace_back(one, other);
  }
  const LinkForest forest = link(all);
  EXPECT_GE(forest.linked.size(), 7u);
  EXPECT_EQ(opened(forest.links), LoadCode::kOk);
}

TEST_F(BakeLinks, AreWhatTheRecipeNames) {
  for (int i = 0; i < 4; ++i) hang(0.0625f * float(i), 2);
  EXPECT_TRUE(bake(R"("none")").made.value().empty());
  EXPECT_TRUE(bake(R"("none")").notes.empty());
  EXPECT_TRUE(bake("[]").made.value().empty());
  EXPECT_EQ(bake(R"([["A.1", "b.0"]])").made.value().size(), 2u) << "any bone stands for its chain";
  const auto row = bake(R"([["*", "*"]])");
  EXPECT_EQ(row.made.value().size(), 6u);
  EXPECT_EQ(
      row.notes[0],
      "6 links of 4 chains, so that they stay beside each other: 'a.0' and 'b.0', 'b.0' and 'c.0', 'c.0' and 'd.0'");
  EXPECT_EQ(row.notes[1].find("3 pairs of chains not linked, as other links hold them together: "), 0u) << row.notes[1];
}

TEST_F(BakeLinks, HaveTheRecipesRoom) {
  hang(0, 1);
  hang(0.05f, 1);
  recipe_ = parse_recipe(R"({"dynamics": {"links": [["a.0", "b.0"]], "link_stretch": 0, "link_shrink": 1}})", "r.json")
                .value();
  const auto links = bake_links("hair.glb", {}, {}, hair_, recipe_, unheard()).value();
  ASSERT_EQ(links.size(), 1u);
  EXPECT_EQ(links[0].shortest, 0);
  EXPECT_FLOAT_EQ(links[0].longest, 0.05f);
}

TEST_F(BakeLinks, OfWrongNamesAreErrorsThatSayWhichThereAre) {
  hang(0, 2);
  hang(0.05f, 2);
  EXPECT_EQ(refusal_of(R"([["a.0", "b.0"], ["a.0", "skirt*"]])"),
            "hair.glb: \"dynamics.links\" [1]: no bone that moves is called skirt*; chains begin with a.0, b.0");
  EXPECT_EQ(refusal_of(R"([["head", "b.0"]])"),
            "hair.glb: \"dynamics.links\" [0]: no bone that moves is called head; chains begin with a.0, b.0");
  EXPECT_EQ(refusal_of(R"([["b.0", "b.1"]])"),
            "hair.glb: \"dynamics.links\" [0]: b.0 and b.1 are of one chain, the one of 'b.0'; name a bone of another: "
            "chains begin"
            " with a.0, b.0");
}

TEST_F(BakeLinks, OfEverybodyWithEverybodyAreRefusedWhereNobodyMeansThem) {
  for (int i = 0; i < 400; ++i) hang(0.001f * float(i), 1);
  EXPECT_EQ(refusal_of(R"([["*", "*"]])"),
            "hair.glb: \"dynamics.links\" [0]: names too many pairs of chains; name neighbours");
}

}  // namespace coif::cook::bake_links_test
