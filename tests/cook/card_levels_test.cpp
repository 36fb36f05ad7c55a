#include "cook/lods/make_lods.h"

#include "cook/built_models.h"
#include "cook/cook.h"
#include "cook/size/measured_model.h"
#include "models/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::cook::card_levels_test {

constexpr std::uint32_t kCards = 12;

/// Cards around the head, each with so many rows.
importer::SourceMesh wig_cards(std::uint32_t rows, std::uint32_t step) {
  importer::SourceMesh cards;
  for (std::uint32_t i = 0; i < kCards; i += step) {
    const float angle = 0.5f * float(i);
    const Eigen::Vector3f root(0.1f * std::sin(angle), 1.6f, 0.1f * std::cos(angle));
    append_card(make_card({.columns = 1, .rows = rows, .width = 0.03f * float(step), .root = root}), cards);
  }
  return cards;
}

importer::SourceLevel level_of(std::uint32_t rows, std::uint32_t step, std::uint32_t node) {
  importer::SourceLevel level;
  level.mesh = wig_cards(rows, step);
  level.mesh.node = node;
  level.mesh.material = 0;
  for (const Eigen::Vector3f& p : level.mesh.positions) {
    level.mesh.normals.emplace_back(0, 0, 1);
    level.along.emplace_back(0, -1, 0);
    level.place.push_back(std::clamp((1.6f - p.y()) / 0.3f, 0.0f, 1.0f));
  }
  for (std::uint32_t t = 0; t < level.mesh.triangles.size() / 3; ++t) level.strip_of.push_back(t / (2 * rows));
  return level;
}

/// The wig's bones, with cards on them whose halves follow two of them, and two coarser sets of cards.
importer::SourceModel make_card_wig() {
  importer::SourceModel model = make_wig();
  model.made_from_strands = true;
  model.materials.emplace_back();
  const std::uint32_t node = model.meshes.front().node;
  importer::SourceMesh cards = wig_cards(8, 1);
  cards.name = "hair";
  cards.node = node;
  cards.material = 0;
  for (std::uint32_t v = 0; v <= cards.positions.size(); ++v) cards.influence_begin.push_back(v);
  for (const Eigen::Vector3f& p : cards.positions) cards.influences.push_back({p.y() > 1.5f ? 3u : 4u, 1.0f});
  model.meshes = {cards};
  model.coarser = {level_of(4, 2, node), level_of(2, 4, node)};
  return model;
}

Recipe recipe_of_levels(std::uint32_t levels = 3) {
  Recipe recipe = default_recipe();
  recipe.lod_levels = levels;
  recipe.head_center = {0, 1.6, 0};
  recipe.head_radii = {0.08, 0.125, 0.1};
  return recipe;
}

CookResult cooked(const Recipe& recipe, const importer::SourceModel& model, unsigned threads) {
  auto result = cook(model, recipe, {.threads = threads, .recipe_directory = {}});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? std::move(*result) : CookResult{};
}

/// A cooked asset, open.
struct Opened {
  explicit Opened(const Recipe& recipe, const importer::SourceModel& model = make_card_wig(), unsigned threads = 2)
      : result(cooked(recipe, model, threads)), file(result.asset) {
    EXPECT_TRUE(bool(asset.open(file.bytes())));
    EXPECT_TRUE(bool(asset.verify_draw_data()));
  }

  CookResult result;
  AlignedBytes file;
  Asset asset;
};

TEST(CardLevels, TheModelKeepsThePromisesOfASource) {
  importer::SourceModel model = make_card_wig();
  EXPECT_EQ(importer::find_model_fault(model), "");
  model.coarser[1].strip_of.back() += 2;
  EXPECT_EQ(importer::find_model_fault(model), "level 2: strips not ascending");
  model.coarser[1].place.pop_back();
  EXPECT_EQ(importer::find_model_fault(model), "level 2: strands of another size than positions");
  model.coarser[0].along[0] *= 2;
  EXPECT_EQ(importer::find_model_fault(model), "level 1: strand not of unit length");
}

TEST(CardLevels, TurnAndGrowWithTheirModel) {
  importer::SourceModel model = make_card_wig();
  const Eigen::Vector3f before = model.coarser[0].mesh.positions[3];
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Eigen::Vector3d::UnitX()).toRotationMatrix();
  transform_model(model, 2, turn);
  EXPECT_LT((model.coarser[0].mesh.positions[3] - 2 * turn.cast<float>() * before).norm(), 1.0e-5f);
  EXPECT_LT((model.coarser[1].along[0] - turn.cast<float>() * Eigen::Vector3f(0, -1, 0)).norm(), 1.0e-5f);
  EXPECT_LT((model.coarser[1].mesh.normals[0] - turn.cast<float>() * Eigen::Vector3f(0, 0, 1)).norm(), 1.0e-5f);
  EXPECT_EQ(importer::find_model_fault(model), "");
}

TEST(CardLevels, EachDrawsItsOwnCards) {
  const Opened opened(recipe_of_levels());
  const Asset& asset = opened.asset;
  ASSERT_EQ(asset.lod_count(), 3u);
  const std::size_t triangles[] = {kCards * 16, kCards / 2 * 8, kCards / 4 * 4}, patches[] = {12, 6, 3};
  std::vector<std::uint32_t> level_of(asset.vertices().size(), importer::kNoIndex);
  for (std::uint32_t lod = 0; lod < 3; ++lod) {
    EXPECT_EQ(asset.lod_indices(lod).size(), 3 * triangles[lod]);
    EXPECT_EQ(asset.lod_patches(lod).size(), patches[lod]);
    for (const std::uint32_t v : asset.lod_indices(lod)) {
      EXPECT_TRUE(level_of[v] == importer::kNoIndex || level_of[v] == lod) << "no level draws another's vertices";
      level_of[v] = lod;
    }
  }
  EXPECT_EQ(std::ranges::count(level_of, importer::kNoIndex), 0);
  EXPECT_EQ(asset.patches().size(), 12u + 6u + 3u);
}

TEST(CardLevels, MoveAsTheFinestCardsAroundThemDo) {
  const Opened opened(recipe_of_levels());
  const auto vertices = opened.asset.vertices();
  const auto skin = opened.asset.skin();
  // By height one bone or the other has most of every vertex, whatever its level.
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const SkinRecord& record = skin[v];
    EXPECT_EQ(record.weight[0] + record.weight[1] + record.weight[2] + record.weight[3], 255);
    for (std::size_t w = 0; w < vertices.size(); ++w) {
      if (std::abs(vertices[w].position[1] - vertices[v].position[1]) > 0.001f) continue;
      EXPECT_EQ(skin[w].bone[0], record.bone[0]) << v << ' ' << w;
    }
  }
}

TEST(CardLevels, ArePlacedInTheOrderOfWhatTheyStandFor) {
  const Opened opened(recipe_of_levels());
  const Asset& asset = opened.asset;
  const auto middle = [&](const PatchRecord& patch) {
    Eigen::Vector3f sum = Eigen::Vector3f::Zero();
    for (std::uint32_t i = 0; i < patch.index_count; ++i)
      sum += Eigen::Vector3f(asset.vertices()[asset.indices()[patch.first_index + i]].position);
    return Eigen::Vector3f(sum / float(patch.index_count));
  };
  for (std::uint32_t lod = 1; lod < 3; ++lod) {
    for (const PatchRecord& coarse : asset.lod_patches(lod)) {
      const auto fine = std::ranges::find(asset.lod_patches(0), coarse.file_place, &PatchRecord::file_place);
      ASSERT_NE(fine, asset.lod_patches(0).end());
      EXPECT_LT((middle(*fine) - middle(coarse)).head<1>().norm(), 0.06f) << "half the width of the coarsest";
    }
  }
}

TEST(CardLevels, ErrorsAreDistancesAndTheirMeansSayWhereALevelFits) {
  Recipe recipe = recipe_of_levels();
  recipe.lod_pixel_error = 2;
  importer::SourceModel model = make_card_wig();
  // The same cards once more, all moved outwards: each vertex is as far from them as from a plane beside it, or nearer.
  model.coarser = {level_of(8, 1, model.meshes[0].node)};
  for (Eigen::Vector3f& p : model.coarser[0].mesh.positions) p.z() += 0.004f;
  const Opened opened(recipe, model);
  const auto lods = opened.asset.stored_lods();
  ASSERT_EQ(lods.size(), 2u);
  EXPECT_NEAR(lods[1].error, 0.004f, 1.0e-4f);
  EXPECT_NEAR(double(lods[0].screen_size) * kScreenLines * 0.004 / 0.25, 2.0, 0.05);
}

TEST(CardLevels, AreLitByTheirOwnCards) {
  Recipe recipe = recipe_of_levels();
  recipe.occlusion_strength = 1;
  const Opened opened(recipe);
  for (std::uint32_t lod = 0; lod < 3; ++lod) {
    std::int16_t least = 32767;
    for (const std::uint32_t v : opened.asset.lod_indices(lod))
      least = std::min(least, opened.asset.vertices()[v].normal[3]);
    EXPECT_LT(least, 30000) << lod << ": the head takes light from every level";
  }
}

TEST(CardLevels, AreNotThereWhereTheyAreNotWantedOrDoNotStandForTheHair) {
  EXPECT_EQ(Opened(recipe_of_levels(1)).asset.lod_count(), 1u);
  EXPECT_EQ(Opened(recipe_of_levels(2)).asset.lod_count(), 2u);
  // A card is left out: coarser cards would show its strands again.
  Recipe recipe = recipe_of_levels();
  PatchOverride out;
  out.select.indices = {3};
  out.keep = false;
  recipe.patch_overrides = {out};
  const Opened part(recipe);
  EXPECT_EQ(part.asset.lod_patches(0).size(), kCards - 1);
  for (const PatchRecord& patch : part.asset.lod_patches(part.asset.lod_count() - 1)) {
    EXPECT_TRUE(std::ranges::count(part.asset.lod_patches(0), patch.file_place, &PatchRecord::file_place) == 1);
  }
  const auto says = [](const std::string& note) { return note.find("of its own") != note.npos; };
  EXPECT_TRUE(std::ranges::none_of(part.result.report.notes, says));
}

TEST(CardLevels, ThreadsDoNotChangeTheBytes) {
  const CookResult one = cooked(recipe_of_levels(), make_card_wig(), 1),
                   three = cooked(recipe_of_levels(), make_card_wig(), 3);
  EXPECT_TRUE(one.asset == three.asset);
}

}  // namespace coif::cook::card_levels_test
