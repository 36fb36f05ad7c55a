// Which strips hang on two chains, by what carries their vertices.

#include "cook/dynamics/bake_links.h"

#include "cook/built_models.h"
#include "cook/cook.h"
#include "models/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>

namespace coif::cook::shared_strips_test {

/// Share of a bone at a place of the card: across it from 0 left to 1 right, and down it from 0 at the root to 1
/// at the tip.
using Weigh = std::function<double(double across, double down)>;

/// A card, and a head (bone 0) with chains of one bone each; what no chain carries follows the head.
SharedStrips shared(const CardDesc& card, const std::vector<Weigh>& chains) {
  const HairStrips hair = strips_from(hair_from(make_card(card)));
  HairRig rig;
  rig.skeleton.bones.resize(1 + chains.size());
  for (std::uint32_t c = 0; c < chains.size(); ++c) rig.skeleton.bones[1 + c].chain = c;
  const auto box = hair.mesh.box();
  for (const Eigen::Vector3f& p : hair.mesh.positions) {
    const double across = (double(p.x()) - box.min().x()) / box.sizes().x();
    const double down = (box.max().y() - double(p.y())) / box.sizes().y();
    std::vector<BoneWeight>& weights = rig.weights.emplace_back();
    double left = 1;
    for (std::uint32_t c = 0; c < chains.size(); ++c) {
      const double weight = std::clamp(chains[c](across, down), 0.0, left);
      if (weight > 0) weights.push_back({1 + c, weight});
      left -= weight;
    }
    if (left > 0) weights.push_back({0, left});
  }
  return find_shared_strips(hair, rig);
}

/// The nearer a column is to the chain at `middle`, the more that chain carries of it; the next chains are
/// `spacing` away.
Weigh near_to(double middle, double spacing) {
  return [=](double across, double) { return 1 - std::abs(across - middle) / spacing; };
}

TEST(SharedStrips, HangOnTheChainsOfTheirTwoEdges) {
  for (const std::uint32_t columns : {1u, 4u, 12u}) {
    const SharedStrips found = shared({.columns = columns}, {near_to(0, 1), near_to(1, 1)});
    EXPECT_EQ(found.count, 1u) << columns;
    ASSERT_EQ(found.pairs.size(), 1u) << columns;
    EXPECT_EQ(found.pairs.begin()->first, (ChainPair{0, 1}));
    EXPECT_EQ(found.pairs.begin()->second.strips, 1u);
    EXPECT_EQ(found.pairs.begin()->second.depths, 1u);
  }
}

TEST(SharedStrips, MayChangeChainsFromOneColumnToTheNext) {
  const Weigh left = [](double across, double) { return across < 0.5 ? 1 : 0; };
  const Weigh right = [](double across, double) { return across < 0.5 ? 0 : 1; };
  EXPECT_EQ(shared({.columns = 6}, {left, right}).count, 1u);
}

TEST(SharedStrips, OfManyChainsHangOnThoseSideBySide) {
  std::vector<Weigh> chains;
  for (int c = 0; c <= 10; ++c) chains.push_back(near_to(c / 10.0, 0.1));
  const SharedStrips found = shared({.columns = 40}, chains);
  EXPECT_EQ(found.count, 1u) << "one sheet";
  EXPECT_EQ(found.pairs.size(), 10u);
  for (const auto& [pair, hair] : found.pairs) EXPECT_EQ(pair.second, pair.first + 1);
}

TEST(SharedStrips, AreNoneOfOneChain) {
  EXPECT_EQ(shared({}, {near_to(0.5, 10)}).count, 0u);
  EXPECT_EQ(shared({}, {}).count, 0u);
}

TEST(SharedStrips, AreNotThoseOfWhichAnotherChainHasTheRest) {
  const Weigh nearly_all = [](double, double) { return 0.96; };
  const Weigh rest = [](double, double) { return 0.04; };
  EXPECT_EQ(shared({}, {nearly_all, rest}).count, 0u) << "rounded, or smoothed away";
}

TEST(SharedStrips, AreNotThoseWhoseRootsBlendIntoTheNeighbour) {
  const Weigh own = [](double, double down) { return std::min(1.0, 0.5 + 3 * down); };
  const Weigh neighbours = [](double, double down) { return 0.5 - 3 * down; };
  EXPECT_EQ(shared({}, {own, neighbours}).count, 0u);
}

TEST(SharedStrips, AreNotTailsThatGrowOutOfOneCap) {
  const Weigh left = [](double across, double) { return across < 0.3 ? 1 : 0; };
  const Weigh right = [](double across, double) { return across > 0.7 ? 1 : 0; };
  EXPECT_EQ(shared({.columns = 12}, {left, right}).count, 0u) << "the head carries what is between them";
}

/// A strip between two chains, the left edge on one and the right edge on the other, 5 cm apart.
importer::SourceModel sheet_of_two_chains() {
  importer::SourceModel model;
  model.path = "sheet.glb";
  add_node(model, "root", importer::kNoIndex, {0, 0, 0});
  const std::uint32_t head = add_node(model, "Head", 0, {0, 1.6, 0});
  importer::SourceMesh mesh = make_strip({.root = {0, 1.65f, -0.1f}, .along = {0, -0.25f, 0}, .rows = 5});
  mesh.node = head;
  std::array<std::array<std::uint32_t, 3>, 2> nodes{};
  for (std::size_t side = 0; side < 2; ++side) {
    const double x = side == 0 ? -0.025 : 0.025;
    const std::string name = side == 0 ? "left" : "right";
    const auto& [scalp, first, second] =
        nodes[side] = {std::uint32_t(model.nodes.size()), std::uint32_t(model.nodes.size() + 1),
                       std::uint32_t(model.nodes.size() + 2)};
    add_node(model, name + "_scalp", head, {x, 1.65, -0.1});
    add_node(model, name + "_1", scalp, {x, 1.6, -0.1});
    add_node(model, name + "_2", first, {x, 1.5, -0.1});
    add_node(model, name + "_2_end", second, {x, 1.4, -0.1});
  }
  mesh.influence_begin.push_back(0);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const float y = mesh.positions[v].y();
    mesh.influences.push_back({nodes[v % 2][y > 1.599f ? 0 : y > 1.499f ? 1 : 2], 1.0f});
    mesh.influence_begin.push_back(std::uint32_t(mesh.influences.size()));
  }
  model.meshes.push_back(mesh);
  return model;
}

/// Cooks the sheet; `links` is what the recipe says of them.
CookResult cooked_sheet(const std::string& links) {
  const auto recipe = parse_recipe(R"({"order": {"method": "head"}, "dynamics": {"links": )" + links + "}}", "r.json");
  EXPECT_TRUE(recipe) << (recipe ? "" : recipe.error().message);
  auto result = cook(sheet_of_two_chains(), recipe ? *recipe : default_recipe(), {.threads = 1});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? *std::move(result) : CookResult{};
}

bool notes(const CookResult& result, const std::string& text) {
  return std::ranges::any_of(result.report.notes,
                             [&](const std::string& note) { return note.find(text) != note.npos; });
}

TEST(SharedStrips, AreSaidToBeSoAndNothingElseWithoutAWordInTheRecipe) {
  const CookResult result = cooked_sheet(R"("none")");
  EXPECT_TRUE(notes(
      result,
      "1 strip hangs on two chains, and may be torn where these drift apart: \"dynamics.links\": \"shared_strips\""));
  AlignedBytes file(result.asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_TRUE(asset.links().empty());
}

TEST(SharedStrips, AreWhatChainsAreLinkedFor) {
  const CookResult result = cooked_sheet(R"("shared_strips")");
  EXPECT_TRUE(notes(result, "1 strip hangs on two chains, which are linked"));
  EXPECT_TRUE(notes(result, "2 links of 2 chains, so that they stay beside each other: 'left_1' and 'right_1'"));
  AlignedBytes file(result.asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  ASSERT_EQ(asset.links().size(), 2u);
  for (const LinkRecord& link : asset.links()) {
    EXPECT_NEAR(link.shortest, 0.025, 1.0e-6);
    EXPECT_NEAR(link.longest, 0.055, 1.0e-6);
  }
  EXPECT_EQ(cooked_sheet(R"([["right_2", "left_*"]])").asset.size(), result.asset.size());
}

}  // namespace coif::cook::shared_strips_test
