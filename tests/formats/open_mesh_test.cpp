// Every number of a mesh is checked, and the first that is wrong is named.

#include "models/small_asset.h"

#include <array>
#include <cmath>
#include <functional>
#include <limits>

namespace coif::open_mesh_test {

using Change = std::function<void(AssetContents&)>;

LoadStatus opened_after(const Change& change) {
  AssetContents contents = small_asset();
  change(contents);
  return open_written(contents);
}

TEST(OpenMesh, CoordinatesAreFiniteAndWithinTheirLimit) {
  constexpr float kLimit = 1.0e5f, kInfinity = std::numeric_limits<float>::infinity();
  const auto with = [](int field, float value) {
    return opened_after([=](AssetContents& a) {
      VertexRecord& v = a.vertices[7];
      (field < 3 ? v.position[field] : v.uv[field - 3]) = value;
    });
  };
  for (int field = 0; field < 5; ++field) {
    for (const float good : {kLimit, -kLimit, 0.0f, -0.0f, 1.0e-42f}) EXPECT_TRUE(with(field, good)) << field;
    for (const float bad : {std::nextafter(kLimit, kInfinity), std::nextafter(-kLimit, -kInfinity), kInfinity,
                            -kInfinity, std::nanf(""), -std::nanf("")}) {
      const LoadStatus status = with(field, bad);
      EXPECT_EQ(status.code, LoadCode::kNotFinite) << "field " << field << " = " << bad;
      EXPECT_EQ(status.item, 7u);
    }
  }
}

TEST(OpenMesh, DirectionsAreUnitVectorsAndSharesNotNegative) {
  const auto with = [](auto change) { return opened_after([=](AssetContents& a) { change(a.vertices[8]); }).code; };
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[2] = 32767 * 95 / 100; }), LoadCode::kOk);
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[2] = 32767 * 94 / 100; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.tangent[1] = 0; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.tangent[1] = -32768; }), LoadCode::kOk);
  EXPECT_EQ(with([](VertexRecord& v) { v.tangent[0] = v.tangent[1] = v.tangent[2] = -32768; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.tangent[3] = -1; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[3] = 0; }), LoadCode::kOk);
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[3] = -1; }), LoadCode::kNotFinite);
  EXPECT_EQ(with([](VertexRecord& v) { v.normal[3] = -32768; }), LoadCode::kNotFinite);
}

TEST(OpenMesh, WeightsAndBonesOfEverySlotAreChecked) {
  for (int slot = 0; slot < 4; ++slot) {
    const LoadStatus bone = opened_after([=](AssetContents& a) { a.skin[4].bone[slot] = 5; });
    EXPECT_EQ(bone.code, LoadCode::kReference) << slot;
    EXPECT_EQ(bone.found, 5u);
    const LoadStatus weight = opened_after([=](AssetContents& a) { a.skin[4].weight[slot] ^= 1; });
    EXPECT_EQ(weight.code, LoadCode::kWeightSum) << slot;
    EXPECT_EQ(weight.item, 4u);
  }
  const LoadStatus wraps = opened_after([](AssetContents& a) {
    for (std::uint8_t& weight : a.skin[4].weight) weight = 255;
  });
  EXPECT_EQ(wraps.code, LoadCode::kWeightSum);
  EXPECT_EQ(wraps.found, 1020u);
}

TEST(OpenMesh, TheFirstOfSeveralFaultsIsNamed) {
  const LoadStatus vertex = opened_after([](AssetContents& a) { a.vertices[3].uv[1] = a.vertices[6].uv[0] = NAN; });
  EXPECT_EQ(vertex.item, 3u);
  const LoadStatus index = opened_after([](AssetContents& a) { a.indices[5] = a.indices[8] = kNone; });
  EXPECT_EQ(index.code, LoadCode::kReference);
  EXPECT_EQ(index.item, 5u);
  EXPECT_EQ(index.found, kNone);
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

/// A change of the small asset's material.
template <typename Change>
LoadCode material_refusal(Change change) {
  return refusal([&](AssetContents& contents) { change(contents.material[0]); });
}

TEST(OpenMaterial, KnowsFourShadingModels) {
  for (std::uint32_t model = 0; model <= 3; ++model) {
    EXPECT_EQ(material_refusal([&](auto& m) {
                m.shading = ShadingModel(model);
                m.roughness = 0.14f;
              }),
              LoadCode::kOk);
  }
  EXPECT_EQ(material_refusal([](auto& m) { m.shading = ShadingModel(4); }), LoadCode::kEnumerator);
}

TEST(OpenMaterial, KeepsEveryNumberInItsRange) {
  struct Range {
    float MaterialRecord::*field;
    float low, high;
  };
  for (const Range& range : {Range{&MaterialRecord::tilt, -kMostTilt, kMostTilt},
                             {&MaterialRecord::roughness, 0, kMostRoughness},
                             {&MaterialRecord::primary_exponent, 1e-3f, 1e5f},
                             {&MaterialRecord::secondary_exponent, 1e-3f, 1e5f},
                             {&MaterialRecord::primary_shift, -10, 10},
                             {&MaterialRecord::secondary_shift, -10, 10},
                             {&MaterialRecord::opaque_threshold, 0, 1},
                             {&MaterialRecord::discard_threshold, 0, 1},
                             {&MaterialRecord::scatter, 0, 1},
                             {&MaterialRecord::light_cut, 0, 1},
                             {&MaterialRecord::glow, 0, kMostGlow},
                             {&MaterialRecord::root_shade, 0, 1},
                             {&MaterialRecord::variation, 0, 1}}) {
    const auto with = [&](float value) { return material_refusal([&](auto& m) { m.*range.field = value; }); };
    for (const float good : {range.low, range.high}) EXPECT_EQ(with(good), LoadCode::kOk);
    for (const float bad : {std::nextafter(range.low, -2e5f), std::nextafter(range.high, 2e5f), kNan})
      EXPECT_EQ(with(bad), LoadCode::kNotFinite) << bad;
  }
}

TEST(OpenMaterial, AsksForAWidthOnlyWhereTheModelHasOne) {
  const auto with = [](ShadingModel model, float roughness) {
    return material_refusal([&](auto& m) {
      m.shading = model;
      m.roughness = roughness;
    });
  };
  EXPECT_EQ(with(ShadingModel::kKajiyaKay, 0), LoadCode::kOk);
  EXPECT_EQ(with(ShadingModel::kMarschner, 0), LoadCode::kNotFinite);
  EXPECT_EQ(with(ShadingModel::kMarschner, kLeastRoughness), LoadCode::kOk);
}

// What open() demands of levels of detail. small_asset() has two: level 0 draws patches 0 and 1 and simulates bones 2,
// 3 (on 2) and 4; level 1 draws patch 2 and simulates bone 2 alone.

/// As many levels as there are patches, all bones simulated in each.
void make_levels(AssetContents& asset, std::uint32_t count) {
  asset.lods.clear();
  asset.patches.clear();
  asset.indices.clear();
  clear_group("orders", asset);
  for (std::uint32_t i = 0; i < count; ++i) {
    asset.indices.insert(asset.indices.end(), {0, 1, 2});
    asset.patches.push_back({3 * i, 3, 0.1f, 2, i});
    asset.lods.push_back({i, 1, float(count - 1 - i), 0.001f * float(i)});
  }
  asset.lod_bones = {0, 0, std::uint8_t(count), std::uint8_t(count), std::uint8_t(count)};
}

TEST(OpenLods, AcceptsAnAssetWithoutLevels) {
  EXPECT_EQ(refusal([](AssetContents& a) { clear_group("lods", a); }), LoadCode::kOk);
}

TEST(OpenLods, WithoutLevelsAMeshIsOneLevel) {
  AssetContents contents = small_asset();
  clear_group("lods", contents);
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

TEST(OpenPatches, TellWhichBoneTheyNameAndHowManyThereAre) {
  AssetContents contents = small_asset();
  contents.patches[1].bone = 77;
  const LoadStatus status = open_written(contents);
  EXPECT_EQ(status.code, LoadCode::kReference);
  EXPECT_EQ(status.item, 1u);
  EXPECT_EQ(status.expected, contents.bones.size());
  EXPECT_EQ(status.found, 77u);
}

TEST(OpenLods, TellWhatWasExpectedAndWhatWasFound) {
  const auto evidence = [](const auto& change) {
    AssetContents contents = small_asset();
    change(contents);
    const LoadStatus status = open_written(contents);
    EXPECT_EQ(status.chunk, chunk::kLods);
    return std::array<std::uint64_t, 3>{status.item, status.expected, status.found};
  };
  using Evidence = std::array<std::uint64_t, 3>;
  EXPECT_EQ(evidence([](auto& a) { a.lods[1].first_patch = 1; }), (Evidence{1, 2, 1})) << "where it begins";
  EXPECT_EQ(evidence([](auto& a) { a.lods[1].patch_count = 7; }), (Evidence{1, 1, 7})) << "of how many are left";
  EXPECT_EQ(evidence([](auto& a) { make_levels(a, kMaxLods + 1); }), (Evidence{0, kMaxLods, kMaxLods + 1}));
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

}  // namespace coif::open_mesh_test
