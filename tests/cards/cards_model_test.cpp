#include "cards/make_cards.h"

#include "cards/card_texture.h"
#include "cards/made_up_groom.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace coif::cards::cards_model_test {

std::vector<CardSize> some_sizes(std::size_t count) {
  std::mt19937 random(2);
  std::uniform_real_distribution<float> unit(0.01f, 1);
  std::vector<CardSize> sizes;
  for (std::size_t i = 0; i < count; ++i) sizes.push_back({0.05f * unit(random), 0.4f * unit(random)});
  return sizes;
}

TEST(CardAtlas, PlacesLieApartAndWithin) {
  for (const std::size_t texels : {std::size_t{1} << 14, std::size_t{1} << 18, std::size_t{3} << 20}) {
    const auto sizes = some_sizes(150);
    const AtlasPlan plan = plan_atlas(sizes, texels);
    ASSERT_EQ(plan.places.size(), sizes.size());
    EXPECT_LE(std::size_t(plan.width) * plan.height, texels);
    EXPECT_EQ(plan.width % 4 + plan.height % 4, 0u);
    std::vector<int> taken(std::size_t(plan.width) * plan.height, -1);
    for (std::size_t i = 0; i < plan.places.size(); ++i) {
      const AtlasPlace& place = plan.places[i];
      ASSERT_LE(place.x + place.width, plan.width);
      ASSERT_LE(place.y + place.height, plan.height);
      // With what has to stay free beside it.
      for (std::uint32_t y = place.y; y < std::min(place.y + place.height + kAtlasGap, plan.height); ++y) {
        for (std::uint32_t x = place.x; x < std::min(place.x + place.width + kAtlasGap, plan.width); ++x) {
          ASSERT_EQ(taken[std::size_t(y) * plan.width + x], -1) << i;
          taken[std::size_t(y) * plan.width + x] = int(i);
        }
      }
    }
  }
}

TEST(CardAtlas, UsesMostOfItsTexels) {
  const auto sizes = some_sizes(400);
  const AtlasPlan plan = plan_atlas(sizes, std::size_t{1} << 22);
  double used = 0;
  for (const AtlasPlace& place : plan.places) used += double(place.width) * place.height;
  EXPECT_GT(used, 0.75 * double(std::size_t{1} << 22));
  EXPECT_TRUE(plan_atlas(sizes, 1000).places.empty());
  EXPECT_TRUE(plan_atlas({}, 1 << 20).places.empty());
}

TEST(CardsModel, KeepsTheBudgetAndThePromisesOfASource) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(500));
  for (const std::size_t triangles : {2u, 1500u}) {
    const auto model = model_of_cards(groom, {triangles, std::size_t{1} << 18, 0, 0}, 2);
    ASSERT_TRUE(model) << model.error().message;
    EXPECT_EQ(importer::find_model_fault(*model), "");
    ASSERT_EQ(model->meshes.size(), 1u);
    EXPECT_LE(model->meshes[0].triangles.size() / 3, triangles);
    EXPECT_GT(model->meshes[0].triangles.size() / 3, triangles / 2);
    EXPECT_EQ(model->images.size(), 2u);
    EXPECT_TRUE(model->made_from_strands);
  }
}

/// Texels, none in two places.
std::size_t area_of(const std::vector<Cards>& levels) {
  const AtlasPlan& plan = levels.front().plan;
  std::vector<bool> taken(std::size_t(plan.width) * plan.height, false);
  std::size_t area = 0;
  for (const Cards& cards : levels) {
    EXPECT_EQ(cards.plan.places.size(), cards.wisps.size());
    for (const AtlasPlace& place : cards.plan.places) {
      for (std::uint32_t y = place.y; y < place.y + place.height; ++y) {
        for (std::uint32_t x = place.x; x < place.x + place.width; ++x, ++area) {
          EXPECT_FALSE(taken[std::size_t(y) * plan.width + x]);
          taken[std::size_t(y) * plan.width + x] = true;
        }
      }
    }
  }
  return area;
}

TEST(CardsModel, HasLevelsOfDetailThatShareTheTexels) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(500));
  const CardsBudget budget{
      .triangles = 1200, .texels = std::size_t{1} << 18, .rounds = 1, .levels = 3, .level_ratio = 0.5};
  const auto levels = make_card_levels(groom, shape_of(groom, 0), budget, 2);
  ASSERT_TRUE(levels) << levels.error().message;
  ASSERT_EQ(levels->size(), 3u);
  EXPECT_LE(area_of(*levels), budget.texels);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t triangles = surface_of((*levels)[k]).triangles.size() / 3, allowed = budget.triangles >> k;
    EXPECT_LE(triangles, allowed);
    EXPECT_GT(triangles, allowed / 2);
  }
  const auto model = model_of_cards(groom, budget, 2);
  ASSERT_TRUE(model) << model.error().message;
  EXPECT_EQ(importer::find_model_fault(*model), "");
  ASSERT_EQ(model->coarser.size(), 2u);
  EXPECT_LT(model->coarser[1].mesh.triangles.size(), model->coarser[0].mesh.triangles.size());
}

TEST(CardsModel, TexelsWithoutStrandsHaveTheNumberOfTheNearest) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(300));
  const CardsBudget budget{.triangles = 400, .texels = std::size_t{1} << 17, .rounds = 0, .caps = 0};
  const auto cards = make_cards(groom, shape_of(groom, 0), budget, 2);
  ASSERT_TRUE(cards) << cards.error().message;
  std::size_t free = 0;
  for (const CardTexture& texture : cards->textures) {
    for (std::size_t row = 0; row < texture.opacity.size(); row += texture.width) {
      const auto at = texture.strand.begin() + std::ptrdiff_t(row), end = at + texture.width;
      std::size_t nearest = texture.width;
      for (std::size_t x = 0; x < texture.width; ++x) nearest = texture.opacity[row + x] > 0 ? x : nearest;
      if (nearest == texture.width) continue;
      for (std::size_t x = nearest + 1; x < texture.width; ++x, ++free)
        EXPECT_EQ(*(at + std::ptrdiff_t(x)), *(at + std::ptrdiff_t(nearest)));
      EXPECT_TRUE(std::all_of(at, end, [](float number) { return number >= 0 && number <= 1; }));
    }
  }
  EXPECT_GT(free, 100u) << "or nothing was looked at";
}

TEST(CardsModel, LevelsEndWhereThereIsNothingLeftOfThem) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(100));
  const CardsBudget budget{
      .triangles = 6, .texels = std::size_t{1} << 16, .rounds = 0, .levels = 8, .level_ratio = 0.5};
  const auto levels = make_card_levels(groom, shape_of(groom, 0), budget, 2);
  ASSERT_TRUE(levels) << levels.error().message;
  EXPECT_EQ(levels->size(), 2u) << "6, 3 and then 1 triangle, which is no strip";
}

TEST(CardsModel, FacesOutwardsWithTheNormalsOfItsTriangles) {
  const auto model = model_of_cards(test::groom_of(test::strands_of_a_head(500)), {600, std::size_t{1} << 18, 0, 0}, 2);
  ASSERT_TRUE(model) << model.error().message;
  const importer::SourceMesh& mesh = model->meshes[0];
  std::size_t outwards = 0, count = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
    const Eigen::Vector3f& a = mesh.positions[mesh.triangles[i]];
    const Eigen::Vector3f normal =
        (mesh.positions[mesh.triangles[i + 1]] - a).cross(mesh.positions[mesh.triangles[i + 2]] - a);
    if (!(normal.norm() > 1e-12f)) continue;
    ++count;
    outwards += normal.dot(mesh.normals[mesh.triangles[i]]) > 0 ? 1 : 0;
  }
  EXPECT_GT(double(outwards), 0.98 * double(count)) << outwards << " of " << count;
}

TEST(CardsModel, RepeatsWithAnyNumberOfThreads) {
  const groom::Groom groom = test::groom_of(test::strands_of_a_head(300));
  const auto one = model_of_cards(groom, {400, std::size_t{1} << 17, 1, 0}, 1),
             three = model_of_cards(groom, {400, std::size_t{1} << 17, 1, 0}, 3);
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->meshes[0].positions, three->meshes[0].positions);
  EXPECT_EQ(one->meshes[0].triangles, three->meshes[0].triangles);
  EXPECT_EQ(one->images[0].bytes, three->images[0].bytes);
}

TEST(CardsModel, SaysHowWideItDrawsStrandsWithoutAWidth) {
  const CardsBudget budget{400, std::size_t{1} << 16, 0, 0};
  const auto few = model_of_cards(test::groom_of(test::strands_of_a_head(100)), budget, 2),
             many = model_of_cards(test::groom_of(test::strands_of_a_head(3000)), budget, 2);
  ASSERT_TRUE(few && many);
  ASSERT_EQ(few->warnings.size(), 1u);
  EXPECT_EQ(few->warnings[0].severity, Severity::kWarning);
  EXPECT_NE(few->warnings[0].message.find("they are too few to cover it"), std::string::npos);
  ASSERT_EQ(many->warnings.size(), 1u);
  EXPECT_EQ(many->warnings[0].severity, Severity::kInfo) << many->warnings[0].message;
  EXPECT_NE(many->warnings[0].message.find("13.9 times as wide as hairs"), std::string::npos)
      << many->warnings[0].message;
  CardsBudget given = budget;
  given.strand_width = 0.001f;
  const auto told = model_of_cards(test::groom_of(test::strands_of_a_head(100)), given, 2);
  ASSERT_TRUE(told);
  EXPECT_TRUE(told->warnings.empty());
}

TEST(CardsModel, SaysWhatIsTooLittle) {
  groom::Groom groom = test::groom_of(test::strands_of_a_head(300));
  groom.path = "a.hair";
  const auto none = model_of_cards(groom, {1, std::size_t{1} << 18, 1, 0}, 1);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().message, "a.hair: cards need 2 triangles and 4096 texels at least; allow them more");
  CardsBudget budget{2400, 4096, 1, 0, 0};
  budget.plan = CardsPlan{Construction::kBent, 1};
  const auto crowded = model_of_cards(groom, budget, 1);
  ASSERT_FALSE(crowded);
  EXPECT_EQ(crowded.error().message,
            "a.hair: 300 cards do not fit into 4096 texels; allow more texels, or fewer triangles");
}

}  // namespace coif::cards::cards_model_test
