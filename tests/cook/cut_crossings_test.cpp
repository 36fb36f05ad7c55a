// Triangles that cross, found in views and cut, on cards whose crossings are known.

#include "cook/cuts/cut_hair.h"
#include "cook/cuts/seen_crossings.h"
#include "cook/cuts/split_mesh.h"
#include "cook/order/choose_order.h"
#include "cook/recipe/recipe.h"
#include "lab/rig.h"
#include "models/card_asset.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

namespace coif::cook::cut_crossings_test {

/// Two cards that cross in the middle, at right angles, one dark and one light.
AssetContents crossing_cards() {
  const std::vector<Card> cards = {{.alpha = 150}, {.right = {0, 0, 0.1f}, .alpha = 140}};
  AssetContents contents = card_contents(cards);
  for (std::size_t k = 0; k < 3; ++k) contents.texels[4 * std::size_t{140} + k] = std::byte{20};
  return contents;
}

AssetContents cards_side_by_side() {
  const std::vector<Card> cards = {{.alpha = 150}, {.center = {0, 0, -0.05f}, .alpha = 140}};
  return card_contents(cards);
}

/// A card with weights on two bones and a seam along its diagonal: vertices 4 and 5 are where 0 and 2 are.
AssetContents card_with_a_seam() {
  const std::vector<Card> cards = {{.alpha = 150}};
  AssetContents contents = card_contents(cards);
  for (const std::uint32_t v : {0u, 2u}) {
    contents.vertices.push_back(VertexRecord(contents.vertices[v]));
    contents.vertices.back().uv[0] += 5;
  }
  contents.indices = {0, 1, 2, 4, 5, 3};
  for (std::size_t v = 0; v < contents.vertices.size(); ++v) {
    const bool is_low = v == 0 || v == 4;
    contents.skin.push_back({{0, 1, 2, 3}, {std::uint8_t(is_low ? 255 : 100), std::uint8_t(is_low ? 0 : 155), 0, 0}});
  }
  return contents;
}

double area_of(const SplitMesh& mesh) {
  double area = 0;
  for (const SplitMesh::Triangle& triangle : mesh.triangles()) {
    const Eigen::Vector3f a = mesh.position(triangle.vertex[0]);
    area += double((mesh.position(triangle.vertex[1]) - a).cross(mesh.position(triangle.vertex[2]) - a).norm()) / 2;
  }
  return area;
}

SeenCrossings seen(const AssetContents& contents, unsigned threads = 2) {
  const lab::OpenedAsset opened(contents);
  const visibility::HairSurface hair(opened.asset());
  visibility::UnitOrder order(hair.triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  visibility::SampleSettings settings;
  settings.lines = 400;
  settings.threads = threads;
  const visibility::HairPositions positions = visibility::posed_positions(opened.asset(), {});
  return CrossingSearch(hair, positions, {{order}, {}}, {0.95f, true, 0.02f}, settings).look(1);
}

TEST(SplitMesh, SplitsBothSidesOfASeam) {
  AssetContents contents = card_with_a_seam();
  SplitMesh mesh(contents);
  const double area = area_of(mesh);
  EXPECT_EQ(mesh.count_at(0, 2), 2u);
  EXPECT_EQ(mesh.count_at(0, 1), 1u);
  const auto halves = mesh.split_edge(0, 2, 0.25f);
  ASSERT_EQ(halves.size(), 2u);
  EXPECT_EQ(mesh.triangles().size(), 4u);
  EXPECT_NEAR(area_of(mesh), area, 1e-7);
  const std::uint32_t one = halves[0].middle, other = halves[1].middle;
  EXPECT_NE(one, other) << "the texture ends there";
  EXPECT_EQ(mesh.position(one), mesh.position(other));
  EXPECT_TRUE(mesh.position(one).isApprox(Eigen::Vector3f(-0.05f, -0.05f, 0)));
  mesh.write_to(contents);
  EXPECT_NEAR(contents.vertices[other].uv[0], contents.vertices[one].uv[0] + 5, 1e-5);
  for (const std::uint32_t v : {one, other}) {
    const SkinRecord& skin = contents.skin[v];
    EXPECT_EQ(skin.weight[0] + skin.weight[1] + skin.weight[2] + skin.weight[3], 255);
    EXPECT_EQ(skin.bone[0], 0);
    EXPECT_NEAR(skin.weight[0], 0.75 * 255 + 0.25 * 100, 1.01);
  }
}

TEST(SplitMesh, KeepsTheHeaviestFourBones) {
  AssetContents contents = card_with_a_seam();
  contents.skin[0] = {{1, 2, 3, 4}, {100, 80, 60, 15}};
  contents.skin[1] = {{5, 6, 7, 8}, {100, 80, 60, 15}};
  SplitMesh mesh(contents);
  const auto halves = mesh.split_edge(0, 1, 0.5f);
  mesh.write_to(contents);
  const SkinRecord& skin = contents.skin[halves.at(0).middle];
  EXPECT_EQ(std::set<int>(std::begin(skin.bone), std::end(skin.bone)), (std::set<int>{1, 2, 5, 6}));
  EXPECT_EQ(skin.weight[0] + skin.weight[1] + skin.weight[2] + skin.weight[3], 255);
}

TEST(SplitMesh, CoarserLevelsStayAndPiecesFollowEachOther) {
  AssetContents contents = crossing_cards();
  PatchRecord coarse = contents.patches[1];
  const std::vector<std::uint32_t> triangle(contents.indices.begin() + 6, contents.indices.begin() + 9);
  coarse.first_index = std::uint32_t(contents.indices.size());
  coarse.index_count = 3;
  contents.indices.insert(contents.indices.end(), triangle.begin(), triangle.end());
  contents.patches.push_back(coarse);
  contents.lods = {{0, 2, 0.1f, 0}, {2, 1, 0, 0.01f}};
  contents.lod_bones = {0};
  SplitMesh mesh(contents);
  EXPECT_EQ(mesh.triangles().size(), 4u);
  mesh.split_edge(0, 1, 0.5f);
  const auto origin = mesh.write_to(contents);
  EXPECT_EQ(origin, (std::vector<std::uint32_t>{0, 0, 1, 2, 3}));
  EXPECT_EQ(contents.patches[0].index_count, 9u);
  EXPECT_EQ(contents.patches[1].first_index, 9u);
  EXPECT_EQ(contents.patches[2].first_index, 15u);
  EXPECT_TRUE(std::equal(triangle.begin(), triangle.end(), contents.indices.begin() + 15));
  EXPECT_TRUE(lab::OpenedAsset(contents).asset().is_open());
}

TEST(SeenCrossings, CardsThatCrossAreFoundAndOthersAreNot) {
  const SeenCrossings crossings = seen(crossing_cards());
  EXPECT_EQ(crossings.pairs, 2u) << "the upper halves, and the lower ones";
  EXPECT_GT(crossings.unavoidable, 0);
  EXPECT_GE(crossings.lost, crossings.unavoidable);
  for (const CrossingSample& sample : crossings.samples) {
    EXPECT_NEAR(std::min(std::abs(sample.near_point.x()), std::abs(sample.near_point.z())), 0, 1e-4);
    EXPECT_NE(sample.near / 2, sample.far / 2) << "two triangles of a card do not cross";
  }
  const SeenCrossings apart = seen(cards_side_by_side());
  EXPECT_EQ(apart.pairs, 0u);
  EXPECT_EQ(apart.unavoidable, 0);
  EXPECT_GT(apart.lost, 0) << "one order is not right from both sides";
}

TEST(SeenCrossings, NoMatterHowManyThreads) {
  const SeenCrossings one = seen(crossing_cards(), 1), three = seen(crossing_cards(), 3);
  EXPECT_EQ(one.lost, three.lost);
  ASSERT_EQ(one.samples.size(), three.samples.size());
  for (std::size_t i = 0; i < one.samples.size(); ++i) EXPECT_EQ(one.samples[i].near, three.samples[i].near);
}

TEST(SeenCrossings, LookingFurtherIsLookingFromAllSides) {
  const lab::OpenedAsset opened(crossing_cards());
  const visibility::HairSurface hair(opened.asset());
  const visibility::HairPositions positions = visibility::posed_positions(opened.asset(), {});
  visibility::SampleSettings settings;
  settings.lines = 400;
  settings.views_per_cell = 3;
  const visibility::CellOrders orders{{{0, 1, 2, 3}}, {}};
  CrossingSearch at_once(hair, positions, orders, {0.95f, true, 0.02f}, settings);
  CrossingSearch by_steps(hair, positions, orders, {0.95f, true, 0.02f}, settings);
  const SeenCrossings glance = by_steps.look(1), further = by_steps.look(3), all = at_once.look(3);
  EXPECT_LT(glance.samples.size(), all.samples.size());
  EXPECT_EQ(further.lost, all.lost);
  EXPECT_EQ(further.pairs, all.pairs);
  ASSERT_EQ(further.samples.size(), all.samples.size());
  for (std::size_t i = 0; i < all.samples.size(); ++i) EXPECT_EQ(further.samples[i].view, all.samples[i].view);
}

TEST(SeenCrossings, OrdersAreRefinedTheSameFromWhatWasSeen) {
  const lab::OpenedAsset opened(crossing_cards());
  const visibility::SeenHair hair(opened.asset());
  const std::vector<visibility::HairPositions> poses = {visibility::posed_positions(opened.asset(), {})};
  visibility::OrderSearchSettings settings;
  settings.views_per_cell = 2;
  settings.lines_per_view = 400;
  settings.min_gain = 0;
  const visibility::JudgedHair judged = visibility::judged_hair(hair, poses, settings);
  const visibility::UnitOrder head = {0, 1};
  const visibility::FoundOrders quick = visibility::search_orders(hair.surface, judged, poses, head, settings);
  ASSERT_FALSE(quick.by_view.orders.empty());
  visibility::SampleSettings samples;
  samples.lines = settings.lines_per_view;
  samples.views_per_cell = settings.views_per_cell;
  CrossingSearch search(hair.surface, poses.front(), quick.by_view, quick.rule, samples);
  (void)search.look(2);
  const visibility::RestVotes votes = search.take_votes();
  ASSERT_NE(votes.find(quick.rule, 0, 0), nullptr);
  EXPECT_FALSE(votes.find(quick.rule, 0, 0)->empty());
  EXPECT_EQ(votes.find({0.5f, quick.rule.faces_together, 0}, 0, 0), nullptr) << "of another rule";
  const visibility::FoundOrders anew = visibility::refine_orders(hair.surface, judged, poses, head, quick, settings);
  const visibility::FoundOrders from_seen =
      visibility::refine_orders(hair.surface, judged, poses, head, quick, settings, votes);
  EXPECT_EQ(anew.by_view.orders, from_seen.by_view.orders);
  EXPECT_EQ(anew.by_view.order_of, from_seen.by_view.order_of);
}

TEST(CutCrossings, CutCardsHaveAnOrderFromEverySide) {
  AssetContents contents = crossing_cards();
  const SeenCrossings before = seen(contents);
  SplitMesh mesh(contents);
  const double area = area_of(mesh);
  const CutResult cut = cut_crossings(before, {.most_added = 40}, mesh);
  EXPECT_GT(cut.cuts, 0u);
  EXPECT_EQ(mesh.triangles().size(), 4 + cut.added);
  EXPECT_NEAR(area_of(mesh), area, 1e-6);
  mesh.write_to(contents);
  const SeenCrossings after = seen(contents);
  EXPECT_LT(after.unavoidable, 0.02 * before.unavoidable);
  EXPECT_NEAR(cut.gained, before.unavoidable, 0.1 * before.unavoidable);
}

TEST(CutCrossings, KeepsToItsBudgetAndStopsWhereItGainsTooLittle) {
  const AssetContents contents = crossing_cards();
  const SeenCrossings crossings = seen(contents);
  for (const std::size_t most : {0u, 1u, 2u, 5u}) {
    SplitMesh mesh(contents);
    EXPECT_LE(cut_crossings(crossings, {.most_added = most}, mesh).added, most);
    EXPECT_LE(mesh.triangles().size(), 4 + most);
  }
  SplitMesh mesh(contents);
  EXPECT_EQ(cut_crossings(crossings, {.most_added = 40, .least_gain = 10 * crossings.lost}, mesh).cuts, 0u);
}

/// What choose_order() makes of cards when it may add this share of triangles.
struct Chosen {
  explicit Chosen(AssetContents cards, double budget, unsigned threads = 2) : contents(std::move(cards)) {
    Recipe recipe = default_recipe();
    recipe.order_method = OrderMethod::kViews;
    recipe.order_cut_budget = budget;
    recipe.opaque_threshold = 0.95;
    const std::vector<Image> used = {{256, 1, 1, std::vector<std::uint8_t>(256, 255)}};
    const auto chosen = choose_order(recipe, used, threads, contents, findings);
    EXPECT_TRUE(chosen);
    if (chosen) figures = *chosen;
    EXPECT_TRUE(lab::OpenedAsset(contents).asset().is_open());
  }
  AssetContents contents;
  Findings findings;
  OrderFigures figures;
};

TEST(CutCrossings, ChosenOrdersAreNearerToTheExactPicture) {
  const Chosen whole(crossing_cards(), 0), cut(crossing_cards(), 1);
  EXPECT_EQ(whole.figures.cuts, 0u);
  EXPECT_EQ(whole.contents.indices.size(), 12u);
  EXPECT_GT(cut.figures.cuts, 0u);
  EXPECT_LE(cut.figures.added, 4u);
  EXPECT_EQ(cut.contents.indices.size(), 12u + 3 * cut.figures.added);
  EXPECT_GT(cut.figures.cut_gain, 0.1);
  EXPECT_GT(cut.figures.psnr, whole.figures.psnr);
  const std::string note = cut.findings.notes.at(0);
  EXPECT_NE(note.find("pairs of triangles change places within a picture"), std::string::npos) << note;
  EXPECT_NE(note.find("cuts add"), std::string::npos) << note;
}

TEST(CutCrossings, ChosenTheSameForAnyNumberOfThreads) {
  EXPECT_EQ(write_asset(Chosen(crossing_cards(), 1, 1).contents), write_asset(Chosen(crossing_cards(), 1, 3).contents));
}

TEST(CutCrossings, OrdersOfMoreTrianglesStayWithinTheirBytes) {
  Recipe recipe = default_recipe();
  recipe.order_cut_budget = 1;
  recipe.order_max_bytes = 4 * 5;  // one order of five triangles
  AssetContents contents = crossing_cards();
  const std::vector<Image> used = {{256, 1, 1, std::vector<std::uint8_t>(256, 255)}};
  Findings findings;
  ASSERT_TRUE(choose_order(recipe, used, 2, contents, findings));
  EXPECT_LE(4 * contents.orders.size(), recipe.order_max_bytes);
}

TEST(CutCrossings, SolidHairIsLeftAlone) {
  std::vector<Card> cards = {{.alpha = 255}, {.right = {0, 0, 0.1f}, .alpha = 255}};
  const Chosen solid(card_contents(cards), 1);
  EXPECT_EQ(solid.figures.cuts, 0u);
  EXPECT_EQ(solid.contents.indices.size(), 12u);
}

}  // namespace coif::cook::cut_crossings_test
