#include "cook/lods/make_lods.h"
#include "cook/built_models.h"
#include "cook/cook.h"
#include "models/small_asset.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace coif::cook::make_lods_test {

/// The wig with bent cards around it, each a patch.
importer::SourceModel make_bent_wig() {
  importer::SourceModel model = make_wig();
  for (int i = 0; i < 12; ++i) {
    importer::SourceMesh card =
        make_card({.bend_radius = 0.1f + 0.02f * float(i), .root = {0.07f * float(i - 6), 1.6f, -0.1f}});
    for (std::uint32_t v = 0; v <= card.positions.size(); ++v) card.influence_begin.push_back(v);
    for (const Eigen::Vector3f& p : card.positions) card.influences.push_back({p.y() > 1.5f ? 3u : 4u, 1.0f});
    model.meshes.push_back(card);
  }
  return model;
}

Recipe recipe_with(std::uint32_t levels, double ratio = 0.5) {
  Recipe recipe = default_recipe();
  recipe.lod_levels = levels;
  recipe.lod_ratio = ratio;
  recipe.texture_max_size = 64;
  recipe.head_center = {0, 1.6, 0};
  recipe.head_radii = {0.08, 0.125, 0.1};
  return recipe;
}

std::vector<std::byte> cooked(const Recipe& recipe, unsigned threads = 1) {
  auto result = cook(make_bent_wig(), recipe, {.threads = threads, .recipe_directory = {}});
  EXPECT_TRUE(result) << (result ? "" : result.error().message);
  return result ? result->asset : std::vector<std::byte>();
}

/// A cooked asset, open.
struct Opened {
  explicit Opened(const Recipe& recipe) : file(cooked(recipe)) { ok = bool(asset.open(file.bytes())); }

  AlignedBytes file;
  Asset asset;
  bool ok = false;
};

TEST(Lods, EachLevelHasItsShareOfTheTriangles) {
  const Opened opened(recipe_with(4));
  ASSERT_TRUE(opened.ok);
  ASSERT_EQ(opened.asset.lod_count(), 4u);
  const auto finest = double(opened.asset.lod_indices(0).size());
  for (std::uint32_t k = 1; k < 4; ++k) {
    EXPECT_NEAR(double(opened.asset.lod_indices(k).size()) / finest, std::pow(0.5, k), 0.03) << k;
  }
}

TEST(Lods, ThePatchesOfAllLevelsAreThoseOfTheFinest) {
  const Opened opened(recipe_with(3));
  ASSERT_TRUE(opened.ok);
  for (std::uint32_t k = 1; k < opened.asset.lod_count(); ++k) {
    EXPECT_EQ(opened.asset.lod_patches(k).size(), opened.asset.lod_patches(0).size()) << "nothing to be dropped";
  }
}

TEST(Lods, OneLevelNeedsNoRecords) {
  const Opened one(recipe_with(1)), three(recipe_with(3));
  ASSERT_TRUE(one.ok && three.ok);
  EXPECT_TRUE(one.asset.stored_lods().empty());
  EXPECT_EQ(one.asset.vertices().size(), three.asset.vertices().size()) << "levels share vertices";
  EXPECT_TRUE(std::ranges::equal(one.asset.lod_indices(0), three.asset.lod_indices(0)));
}

TEST(Lods, ThreadsDoNotChangeTheBytes) {
  const auto one = cooked(recipe_with(3), 1);
  EXPECT_EQ(one, cooked(recipe_with(3), 2));
  EXPECT_EQ(one, cooked(recipe_with(3), 5));
}

TEST(Lods, ALevelIsLeftWhereTheNextOnesErrorIsAPixel) {
  Recipe recipe = recipe_with(3, 0.15);
  recipe.lod_pixel_error = 2;
  const Opened opened(recipe);
  ASSERT_TRUE(opened.ok);
  const auto lods = opened.asset.stored_lods();
  ASSERT_GE(lods.size(), 2u);
  for (std::size_t k = 0; k + 1 < lods.size(); ++k) {
    const double head_pixels = lods[k].screen_size * kScreenLines;
    EXPECT_NEAR(lods[k + 1].error / 0.25 * head_pixels, 2.0, 1.0e-3) << k;
  }
}

TEST(Lods, TheErrorStaysBelowTheLimit) {
  Recipe recipe = recipe_with(8, 0.7);
  recipe.lod_max_error = 0.002;
  const Opened opened(recipe);
  ASSERT_TRUE(opened.ok);
  ASSERT_GT(opened.asset.lod_count(), 1u);
  EXPECT_LT(opened.asset.lod_count(), 8u) << "a level that saves little is left out";
  EXPECT_LE(opened.asset.stored_lods().back().error, 0.002f);
}

TEST(Lods, WhatCannotBeCoarserHasOneLevel) {
  auto result = cook(make_wig(),
                     [] {
                       Recipe recipe = recipe_with(3);
                       recipe.lod_max_error = 0;
                       return recipe;
                     }(),
                     {});
  ASSERT_TRUE(result);
  AlignedBytes file(result->asset);
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_TRUE(asset.stored_lods().empty());
  const auto says = [](const std::string& note) { return note.starts_with("no level 1: "); };
  EXPECT_TRUE(std::ranges::any_of(result->report.notes, says));
}

Skeleton forked_chain() {
  Skeleton skeleton;
  const auto add = [&](std::uint32_t parent, BoneKind kind, double length) {
    SkeletonBone bone;
    bone.parent = parent;
    bone.kind = kind;
    if (parent != kNone) bone.start = skeleton.bones[parent].tail;
    bone.tail = bone.start + Eigen::Vector3d(0, -length, 0);
    skeleton.bones.push_back(bone);
  };
  add(kNone, BoneKind::kHead, 0);
  add(0, BoneKind::kScalp, 0);
  for (std::uint32_t parent : {1u, 2u, 3u}) add(parent, BoneKind::kSimulated, 0.1);
  add(2, BoneKind::kSimulated, 0.02);  // a short branch of the chain
  add(0, BoneKind::kSimulated, 0.05);  // a short chain
  return skeleton;
}

using Bones = std::vector<bool>;

TEST(LodBones, ChainsLoseTheirTipsFirstAndShortOnesAllTheirBones) {
  const Skeleton skeleton = forked_chain();
  EXPECT_EQ(moving_bones(skeleton, 0), Bones({0, 0, 1, 1, 1, 1, 1}));
  EXPECT_FALSE(moving_bones(skeleton, skeleton.bones[6].length())[6]) << "as long as what stands still";
  EXPECT_EQ(moving_bones(skeleton, 0.03), Bones({0, 0, 1, 1, 1, 0, 1})) << "the branch is shorter";
  EXPECT_EQ(moving_bones(skeleton, 0.06), Bones({0, 0, 1, 1, 1, 0, 0})) << "so is the second chain";
  EXPECT_EQ(moving_bones(skeleton, 0.15), Bones({0, 0, 1, 1, 0, 0, 0})) << "the long chain's last bone";
  EXPECT_EQ(moving_bones(skeleton, 1), Bones(7, false));
}

TEST(LodBones, WhatMovesHasAParentThatMovesOrNeverDid) {
  const Skeleton skeleton = forked_chain();
  Bones finer = moving_bones(skeleton, 0);
  for (double still = 0; still < 0.4; still += 0.005) {
    const Bones moves = moving_bones(skeleton, still);
    for (std::uint32_t b = 0; b < skeleton.bones.size(); ++b) {
      if (!moves[b]) continue;
      EXPECT_TRUE(finer[b]) << "a coarser level moves nothing more: " << b;
      const std::uint32_t parent = skeleton.bones[b].parent;
      EXPECT_TRUE(skeleton.bones[parent].kind != BoneKind::kSimulated || moves[parent]) << b;
    }
    finer = moves;
  }
}

TEST(BentPoses, EveryBoneTurnsInOneOfThemAndLengthsStay) {
  HairMesh mesh = hair_from(make_card({.columns = 1, .rows = 2, .length = 0.2f, .root = {0, 0, 0}}));
  EXPECT_EQ(bent_poses(mesh, {forked_chain(), SkinWeights(6, {{1, 1.0}})}).size(), 3u);
  const auto poses = bent_poses(mesh, {forked_chain(), SkinWeights(6, {{3, 1.0}})});
  ASSERT_EQ(poses.size(), 3u);
  EXPECT_EQ(poses[0], mesh.positions);
  for (const std::size_t pose : {1, 2}) {
    EXPECT_GT((poses[pose][5] - mesh.positions[5]).norm(), 0.03f);
    EXPECT_NEAR((poses[pose][5] - poses[pose][0]).norm(), (mesh.positions[5] - mesh.positions[0]).norm(), 1.0e-5f);
  }
  Skeleton rigid = forked_chain();
  for (SkeletonBone& bone : rigid.bones) bone.kind = BoneKind::kScalp;
  EXPECT_EQ(bent_poses(mesh, {rigid, SkinWeights(6, {{1, 1.0}})}).size(), 1u);
}

}  // namespace coif::cook::make_lods_test
