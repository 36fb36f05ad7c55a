#include "models/small_asset.h"
#include "payload_hash.h"
#include "write/asset_writer.h"

#include <coif/asset.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace coif::open_test {

TEST(Open, RefusesAFileOfNoChunks) {
  AlignedBytes file(write_chunks({}));
  EXPECT_EQ(file.bytes().size(), sizeof(FileHeader));
  Asset asset;
  EXPECT_EQ(asset.open(file.bytes()).code, LoadCode::kChunkMissing);
}

TEST(Open, BeforeItThereIsNothingAndNothingIsRead) {
  AlignedBytes damaged(std::vector<std::byte>(100));
  Asset never, refused;
  EXPECT_FALSE(refused.open(damaged.bytes()));
  for (const Asset* const asset : {&never, &refused}) {
    EXPECT_FALSE(asset->is_open());
    EXPECT_EQ(asset->skeleton().bone_count, 0u);
    EXPECT_EQ(asset->skeleton().simulated_count, 0u);
    EXPECT_EQ(asset->minor(), 0u);
    EXPECT_EQ(asset->total_bytes(), 0u);
    EXPECT_TRUE(asset->bones().empty() && asset->chains().empty() && asset->stored_lods().empty());
    EXPECT_EQ(asset->lod_count(), 0u);
    EXPECT_TRUE(asset->lod_patches(0).empty());
    EXPECT_STREQ(asset->bone_name(0), "");
  }
}

TEST(Open, GivesBackWhatWasWritten) {
  const AssetContents contents = small_asset();
  AlignedBytes file(write_asset(contents));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  EXPECT_EQ(asset.total_bytes(), file.bytes().size());
  EXPECT_EQ(asset.skeleton().simulated_count, 3u);
  ASSERT_EQ(asset.bones().size(), contents.bones.size());
  EXPECT_STREQ(asset.bone_name(3), "hair_2");
  EXPECT_STREQ(asset.bone_name(999), "");
  EXPECT_FLOAT_EQ(asset.bones()[4].length, 0.1f);
  EXPECT_EQ(asset.indices().size(), 9u);
  EXPECT_EQ(asset.patches()[1].first_index, 3u);
  ASSERT_EQ(asset.stored_lods().size(), 2u);
  EXPECT_EQ(asset.lod_bones()[2], 2u);
  EXPECT_EQ(asset.lod_count(), 2u);
  EXPECT_EQ(asset.lod_patches(0).size(), 2u);
  EXPECT_EQ(asset.lod_indices(0).size(), 6u);
  EXPECT_EQ(asset.lod_indices(1).data(), asset.indices().data() + 6);
  EXPECT_TRUE(asset.lod_indices(2).empty());
  EXPECT_EQ(asset.bones()[2].colliders, 0b1111u);
  EXPECT_EQ(asset.colliders()[1].flags, kColliderKeepsInside);
  EXPECT_FLOAT_EQ(asset.colliders()[1].axis[1], -0.2f);
  EXPECT_FLOAT_EQ(asset.dynamics()[4].hit_radius, 0.005f);
  ASSERT_NE(asset.texture(TextureRole::kShiftMask), nullptr);
  const TextureRecord& base = *asset.texture(TextureRole::kBaseColor);
  EXPECT_EQ(asset.texels(base, 2).size(), 4u);
  EXPECT_EQ(asset.texels(base, 2)[0], contents.texels[40]);
  EXPECT_EQ(asset.provenance()->importer_version[1], 2);
}

TEST(Open, WritingTwiceGivesTheSameBytes) { EXPECT_EQ(write_asset(small_asset()), write_asset(small_asset())); }

/// small_asset() with rigid bones of no use after its own; `count` in all.
AssetContents with_bones(std::uint32_t count) {
  AssetContents contents = small_asset();
  contents.lods.clear();
  contents.lod_bones.clear();
  const std::uint32_t added = count - std::uint32_t(contents.bones.size());
  contents.bones.insert(contents.bones.begin() + 2, added, contents.bones[1]);
  contents.bone_names.clear();
  for (std::uint32_t i = 2 + added; i < count; ++i) {
    if (contents.bones[i].parent > 1) contents.bones[i].parent += added;
  }
  for (ChainRecord& chain : contents.chains) chain.first_bone += added;
  contents.dynamics.resize(count, contents.dynamics.front());
  contents.asked.resize(count, contents.asked.front());
  contents.limits.clear();
  contents.links.clear();
  clear_group("body", contents);
  for (SkinRecord& skin : contents.skin) skin.bone[0] = std::uint16_t(count - 1);
  return contents;
}

TEST(Open, AcceptsAsManyBonesAsTheFormatAllowsAndNoMore) {
  EXPECT_EQ(open_written(with_bones(300)).code, LoadCode::kOk) << "more than a byte counts";
  EXPECT_EQ(open_written(with_bones(kMaxBones)).code, LoadCode::kOk);
  EXPECT_EQ(open_written(with_bones(kMaxBones + 1)).code, LoadCode::kChunkSize);
}

TEST(Open, RefusesSkinOnABoneThatDoesNotExist) {
  AssetContents contents = with_bones(300);
  contents.skin[0].bone[3] = 300;
  EXPECT_EQ(open_written(contents).code, LoadCode::kReference);
}

TEST(Open, AcceptsAMeshWithoutSkin) {
  AssetContents contents = small_asset();
  contents.skin.clear();
  EXPECT_EQ(open_written(contents).code, LoadCode::kOk);
}

TEST(Open, AcceptsASkeletonAlone) {
  AssetContents contents = small_asset();
  for (const char* group : {"mesh", "colliders", "provenance", "tuning", "names"}) {
    EXPECT_GT(clear_group(group, contents), 0u) << group;
  }
  for (BoneRecord& bone : contents.bones) bone.colliders = 0;
  EXPECT_TRUE(open_written(contents));
}

TEST(Open, AcceptsAnyMinorVersionAndSkipsUnknownOptionalChunks) {
  std::vector<std::byte> bytes = write_asset(small_asset());
  bytes[10] = std::byte{7};             // minor version
  bytes[32 + 2 * 32] = std::byte{'Z'};  // the NAME chunk becomes unknown
  AlignedBytes file(bytes);
  Asset asset;
  const LoadStatus status = asset.open(file.bytes(), {.verify_hash = false});
  // Bones still point into NAME, so the reader must notice that they have nothing to point to.
  EXPECT_EQ(status.code, LoadCode::kReference);
  AssetContents nameless = small_asset();
  nameless.bone_names.clear();
  nameless.provenance.clear();
  AlignedBytes other(write_asset(nameless));
  other.bytes()[10] = std::byte{7};
  EXPECT_TRUE(asset.open(other.bytes(), {.verify_hash = false}));
  EXPECT_EQ(asset.minor(), 7);
}

TEST(Open, RefusesAnotherMajorVersion) {
  for (const int major : {0, 2, 255}) {
    AlignedBytes file(write_asset(small_asset()));
    file.bytes()[8] = std::byte(major);
    const LoadStatus status = Asset{}.open(file.bytes(), {.verify_hash = false});
    EXPECT_EQ(status.code, LoadCode::kMajorVersion);
    EXPECT_EQ(status.expected, kAssetMajor);
    EXPECT_EQ(status.found, std::uint64_t(major));
  }
}

TEST(Open, RefusesUnknownRequiredChunks) {
  AlignedBytes file(write_asset(small_asset()));
  file.bytes()[32 + 3 * 32] = std::byte{'Z'};    // CHAN
  file.bytes()[32 + 3 * 32 + 4] = std::byte{1};  // required
  Asset asset;
  EXPECT_EQ(asset.open(file.bytes(), {.verify_hash = false}).code, LoadCode::kChunkUnknown);
}

TEST(Open, RefusesFlagsOfAChunkThatMeanNothing) {
  AlignedBytes file(write_asset(small_asset()));
  file.bytes()[32 + 4] |= std::byte{2};
  EXPECT_EQ(Asset{}.open(file.bytes(), {.verify_hash = false}).code, LoadCode::kReserved);
}

TEST(Open, RefusesMemoryThatIsNotAligned) {
  const std::vector<std::byte> bytes = write_asset(small_asset());
  std::vector<std::byte> room(16, std::byte{});
  room.insert(room.end(), bytes.begin(), bytes.end());
  AlignedBytes block(room);
  Asset asset;
  EXPECT_EQ(asset.open(block.bytes().subspan(16)).code, LoadCode::kMisaligned) << "texels want 64";
  EXPECT_EQ(asset.open(block.bytes().subspan(8)).code, LoadCode::kMisaligned);
}

TEST(Open, RefusesForeignFilesByTheirFirstBytes) {
  AlignedBytes file(write_asset(small_asset()));
  file.bytes()[1] = std::byte{'X'};
  EXPECT_EQ(Asset{}.open(file.bytes()).code, LoadCode::kMagic);
  EXPECT_EQ(Asset{}.open({}).code, LoadCode::kTooSmall);
}

TEST(Open, RefusesBrokenSkeletons) {
  EXPECT_EQ(refusal([](auto& a) { a.bones[2].parent = 3; }), LoadCode::kBoneOrder);
  EXPECT_EQ(refusal([](auto& a) { a.bones[0].parent = 0; }), LoadCode::kBoneOrder);
  EXPECT_EQ(refusal([](auto& a) { std::swap(a.bones[1], a.bones[2]); }), LoadCode::kBoneOrder);
  EXPECT_EQ(refusal([](auto& a) { a.bones[2].length = 0; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.bones[2].length = std::nanf(""); }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.bones[3].rest_direction[0] = 0.5f; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.bones[3].kind = BoneKind(9); }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.bones[3].joint[0] = 0.01f; }), LoadCode::kBoneJoint);
  EXPECT_EQ(refusal([](auto& a) { a.bones.clear(); }), LoadCode::kChunkMissing);
  EXPECT_EQ(refusal([](auto& a) { a.chains[0].bone_count = 1; }), LoadCode::kChainCover);
  EXPECT_EQ(refusal([](auto& a) { a.chains[1].bone_count = 0xFFFFFFFFu; }), LoadCode::kChainCover);
  EXPECT_EQ(refusal([](auto& a) { a.chains[0].root = 2; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.chains.pop_back(); }), LoadCode::kChainCover);
  EXPECT_EQ(refusal([](auto& a) { a.skeleton.head_rotation[3] = 0; }), LoadCode::kNotFinite);
}

TEST(Open, RefusesBrokenMeshes) {
  EXPECT_EQ(refusal([](auto& a) { a.indices[4] = 9; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.indices.pop_back(); }), LoadCode::kChunkSize);
  EXPECT_EQ(refusal([](auto& a) { a.skin.pop_back(); }), LoadCode::kChunkSize);
  EXPECT_EQ(refusal([](auto& a) { a.vertices.clear(); }), LoadCode::kChunkMissing);
  EXPECT_EQ(refusal([](auto& a) { a.skin[0].bone[3] = 5; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.skin[5].weight[0] = 0; }), LoadCode::kWeightSum);
  EXPECT_EQ(refusal([](auto& a) { a.patches[1].first_index = 0; }), LoadCode::kPatchCover);
  EXPECT_EQ(refusal([](auto& a) { a.patches[1].index_count = 9; }), LoadCode::kPatchCover);
  EXPECT_EQ(refusal([](auto& a) { a.patches[2].index_count = 6; }), LoadCode::kPatchCover);
  EXPECT_EQ(refusal([](auto& a) { a.patches[1].head_distance = 0; }), LoadCode::kOk) << "any order may be stored";
  EXPECT_EQ(refusal([](auto& a) { a.patches[1].head_distance = -0.1f; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.patches[1].head_distance = std::nanf(""); }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.vertices[2].position[1] = std::numeric_limits<float>::infinity(); }),
            LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.vertices[2].normal[2] = 0; }), LoadCode::kNotFinite);
}

TEST(Open, AcceptsACompressedShiftMaskAndNoOtherCompressedTexture) {
  const auto compress = [](std::size_t texture, std::uint32_t side, std::uint64_t bytes) {
    return [=](AssetContents& a) {
      a.texels.resize(128);
      a.textures[texture] = {TextureRole(texture), TexelFormat::kRg11Eac, side, side, 1, 0, 48, bytes};
    };
  };
  EXPECT_EQ(refusal(compress(1, 2, 16)), LoadCode::kOk) << "a part of a block is a whole one";
  EXPECT_EQ(refusal(compress(1, 5, 64)), LoadCode::kOk);
  EXPECT_EQ(refusal(compress(1, 5, 50)), LoadCode::kChunkSize);
  EXPECT_EQ(refusal(compress(0, 4, 16)), LoadCode::kEnumerator);
}

TEST(Open, FindsMapsOfTheSurfaceInTheirOwnChunks) {
  AlignedBytes file(write_asset(small_asset()));
  Asset asset;
  ASSERT_TRUE(asset.open(file.bytes()));
  ASSERT_EQ(asset.reliefs().size(), 2u);
  EXPECT_EQ(asset.texture(TextureRole::kNormal), &asset.reliefs()[0]);
  EXPECT_EQ(asset.texels(asset.reliefs()[0], 1).size(), 2u);
  EXPECT_EQ(asset.texels(asset.reliefs()[1], 0)[15], std::byte{7});
  EXPECT_EQ(two_sided(128.0f / 255), 0);
  EXPECT_EQ(two_sided(1), 1);
}

TEST(Open, RefusesBrokenMapsOfTheSurface) {
  EXPECT_EQ(refusal([](auto& a) { a.reliefs[0].role = TextureRole::kShiftMask; }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.reliefs[0].role = TextureRole(4); }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.textures[1].role = TextureRole::kNormal; }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.reliefs[0].format = TexelFormat::kSrgb8Alpha8; }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.reliefs[1] = a.reliefs[0]; }), LoadCode::kChunkDuplicate);
  EXPECT_EQ(refusal([](auto& a) { a.reliefs[1].offset = 32; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.reliefs[0].bytes = 8; }), LoadCode::kChunkSize);
  EXPECT_EQ(refusal([](auto& a) { a.relief_texels.clear(); }), LoadCode::kReference);
}

TEST(Open, RefusesBrokenAppearance) {
  EXPECT_EQ(refusal([](auto& a) { a.material[0].opaque_threshold = 2; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.material[0].flags = 8; }), LoadCode::kReserved);
  EXPECT_EQ(refusal([](auto& a) { a.textures[0].mip_count = 4; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.textures[0].width = 0; }), LoadCode::kNotFinite);
  EXPECT_EQ(refusal([](auto& a) { a.textures[1].offset = 64; }), LoadCode::kReference);
  EXPECT_EQ(refusal([](auto& a) { a.textures[1].bytes = 9; }), LoadCode::kChunkSize);
  EXPECT_EQ(refusal([](auto& a) { a.textures[1].role = TextureRole::kBaseColor; }), LoadCode::kEnumerator);
  EXPECT_EQ(refusal([](auto& a) { a.texels.clear(); }), LoadCode::kReference);
}

std::uint64_t hash_of(std::string_view text, std::uint64_t seed = 0) {
  return xxh64(std::as_bytes(std::span(text.data(), text.size())), seed);
}

// Published test vectors of XXH64, covering the empty input, the byte, word and stripe paths.
TEST(PayloadHash, AgreesWithPublishedVectors) {
  EXPECT_EQ(hash_of(""), 0xEF46DB3751D8E999ull);
  EXPECT_EQ(hash_of("a"), 0xD24EC4F1A98C6E5Bull);
  EXPECT_EQ(hash_of("abc"), 0x44BC2CF5AD770999ull);
  EXPECT_EQ(hash_of("Nobody inspects the spammish repetition"), 0xFBCEA83C8A378BF1ull);
}

TEST(PayloadHash, DependsOnTheSeed) { EXPECT_NE(hash_of("abc", 0), hash_of("abc", 1)); }

}  // namespace coif::open_test
