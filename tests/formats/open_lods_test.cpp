// What open() demands of levels of detail. small_asset() has two: level 0 draws patches 0 and 1 and simulates bones 2, 3
// (on 2) and 4; level 1 draws patch 2 and simulates bone 2 alone.

#include "formats/refusal.h"

#include <cmath>

namespace coif {
namespace {

/// As many levels as there are patches, all bones simulated in each.
void make_levels(AssetContents& asset, std::uint32_t count) {
  asset.lods.clear();
  asset.patches.clear();
  asset.indices.clear();
  asset.orders.clear();
  asset.order_views.clear();
  for (std::uint32_t i = 0; i < count; ++i) {
    asset.indices.insert(asset.indices.end(), {0, 1, 2});
    asset.patches.push_back({3 * i, 3, 0.1f, 2, i});
    asset.lods.push_back({i, 1, float(count - 1 - i), 0.001f * float(i)});
  }
  asset.lod_bones = {0, 0, std::uint8_t(count), std::uint8_t(count), std::uint8_t(count)};
}

TEST(OpenLods, AcceptsAnAssetWithoutLevels) {
  const auto without_levels = [](AssetContents& a) {
    a.lods.clear();
    a.lod_bones.clear();
  };
  EXPECT_EQ(refusal(without_levels), LoadCode::kOk);
}

TEST(OpenLods, WithoutLevelsAMeshIsOneLevel) {
  AssetContents contents = small_asset();
  contents.lods.clear();
  contents.lod_bones.clear();
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.lod_count(), 1u);
  EXPECT_EQ(asset.lod_patches(0).size(), 3u);
  EXPECT_EQ(asset.lod_indices(0).size(), asset.indices().size());
  EXPECT_TRUE(asset.lod_patches(1).empty());
  EXPECT_EQ(Asset{}.lod_count(), 0u);
}

TEST(OpenLods, AcceptsAsManyLevelsAsTheFormatAllowsAndNoMore) {
  EXPECT_EQ(refusal([](auto& a) { make_levels(a, 1); }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { make_levels(a, kMaxLods); }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { make_levels(a, kMaxLods + 1); }), LoadCode::kChunkSize);
}

TEST(OpenLods, RefusesLevelsThatDoNotCoverThePatches) {
  EXPECT_EQ(refusal([](auto& a) { a.lods[0].first_patch = 1; }), LoadCode::kLodCover);
  EXPECT_EQ(refusal([](auto& a) { a.lods[0].patch_count = 1; }), LoadCode::kLodCover) << "a gap";
  EXPECT_EQ(refusal([](auto& a) { a.lods[1].first_patch = 1; }), LoadCode::kLodCover) << "an overlap";
  EXPECT_EQ(refusal([](auto& a) { a.lods[1].patch_count = 0; }), LoadCode::kLodCover);
  EXPECT_EQ(refusal([](auto& a) { a.lods[1].patch_count = 2; }), LoadCode::kLodCover);
  EXPECT_EQ(refusal([](auto& a) { a.lods[1].patch_count = ~0u; }), LoadCode::kLodCover);
  const auto too_few = [](AssetContents& a) {
    a.lods.pop_back();
    a.lods[0].screen_size = 0;
    a.lod_bones[2] = 1;
  };
  EXPECT_EQ(refusal(too_few), LoadCode::kLodCover) << "the last patch is in no level";
}

TEST(OpenLods, RefusesLevelsWithoutPatches) {
  const auto without_mesh = [](AssetContents& a) {
    a.vertices.clear();
    a.skin.clear();
    a.indices.clear();
    a.patches.clear();
  };
  EXPECT_EQ(refusal(without_mesh), LoadCode::kChunkMissing);
}

TEST(OpenLods, RefusesScreenSizesThatDoNotFallToZero) {
  EXPECT_EQ(refusal([](auto& a) { a.lods[0].screen_size = 0; }), LoadCode::kLodOrder);
  EXPECT_EQ(refusal([](auto& a) { a.lods[1].screen_size = 0.1f; }), LoadCode::kLodOrder) << "the last is not 0";
  EXPECT_EQ(refusal([](auto& a) { a.lods[0].screen_size = -0.3f; }), LoadCode::kLodOrder);
  EXPECT_EQ(refusal([](auto& a) { a.lods[0].screen_size = NAN; }), LoadCode::kLodOrder);
  const auto rising = [](AssetContents& a) {
    make_levels(a, 3);
    a.lods[1].screen_size = a.lods[0].screen_size;
  };
  EXPECT_EQ(refusal(rising), LoadCode::kLodOrder);
}

TEST(OpenLods, RefusesErrorsThatDoNotGrowFromZero) {
  EXPECT_EQ(refusal([](auto& a) { a.lods[0].error = 0.001f; }), LoadCode::kLodOrder) << "level 0 is the reference";
  EXPECT_EQ(refusal([](auto& a) { a.lods[1].error = -0.001f; }), LoadCode::kLodOrder);
  EXPECT_EQ(refusal([](auto& a) { a.lods[1].error = INFINITY; }), LoadCode::kLodOrder);
  const auto falling = [](AssetContents& a) {
    make_levels(a, 3);
    a.lods[1].error = 0.01f;
  };
  EXPECT_EQ(refusal(falling), LoadCode::kLodOrder);
}

TEST(OpenLods, RefusesLevelsOrTheirBonesAlone) {
  EXPECT_EQ(refusal([](auto& a) { a.lods.clear(); }), LoadCode::kChunkMissing);
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones.clear(); }), LoadCode::kChunkMissing);
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones.pop_back(); }), LoadCode::kChunkSize);
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones.push_back(0); }), LoadCode::kChunkSize) << "no such bone";
}

TEST(OpenLods, RefusesBonesThatCannotBeSimulated) {
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones[0] = 1; }), LoadCode::kLodBones) << "the head";
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones[1] = 1; }), LoadCode::kLodBones) << "the scalp";
}

TEST(OpenLods, RefusesBonesThatLevel0DoesNotSimulateOrThatOutlastTheLevels) {
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones[4] = 0; }), LoadCode::kLodBones);
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones[4] = 2; }), LoadCode::kOk);
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones[4] = 3; }), LoadCode::kLodBones) << "there are two levels";
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones[4] = 255; }), LoadCode::kLodBones);
}

TEST(OpenLods, RefusesAMovingBoneOnABoneThatStoodStill) {
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones = {0, 0, 2, 2, 1}; }), LoadCode::kOk) << "3 hangs from 2";
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones = {0, 0, 1, 2, 1}; }), LoadCode::kLodBones) << "3 hangs from 2";
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones = {0, 0, 1, 1, 2}; }), LoadCode::kOk) << "4 hangs from the head";
  EXPECT_EQ(refusal([](auto& a) { a.lod_bones = {0, 0, 1, 1, 1}; }), LoadCode::kOk);
}

}  // namespace
}  // namespace coif
