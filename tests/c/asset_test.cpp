// coif_asset_*: what C sees of an asset is what C++ sees, and nothing of one that is not open.

#include "models/skinned_asset.h"
#include "models/small_asset.h"

#include <coif.h>
#include <coif/hair.h>
#include <coif/lod.h>
#include <coif/skinning.h>

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace coif::c_asset_test {

class CAsset : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(same_.open(file_.bytes()));
    ASSERT_EQ(coif_asset_open(&asset_, file_.bytes().data(), file_.bytes().size(), nullptr, 0), COIF_OK);
  }

  AlignedBytes file_{write_asset(small_asset())};
  coif_asset asset_{};
  Asset same_;
};

/// The list is the same memory, and not empty.
template <typename InC, typename Record>
void expect_same(const InC* list, std::uint32_t count, std::span<const Record> records) {
  EXPECT_GT(count, 0u);
  EXPECT_EQ(count, records.size());
  EXPECT_EQ(static_cast<const void*>(list), static_cast<const void*>(records.data()));
}

TEST_F(CAsset, ListsAreTheAssetsOwnRecords) {
  const auto check = [&](auto function, auto records) {
    std::uint32_t count = 7;
    const auto* const list = function(&asset_, &count);
    expect_same(list, count, records);
    EXPECT_EQ(function(&asset_, nullptr), list);
  };
  check(coif_asset_bones, same_.bones());
  check(coif_asset_chains, same_.chains());
  check(coif_asset_colliders, same_.colliders());
  check(coif_asset_limits, same_.limits());
  check(coif_asset_links, same_.links());
  check(coif_asset_body_bones, same_.body_bones());
  check(coif_asset_body_colliders, same_.body_colliders());
  check(coif_asset_body_sets, same_.body_sets());
  check(coif_asset_vertices, same_.vertices());
  check(coif_asset_skin, same_.skin());
  check(coif_asset_indices, same_.indices());
  check(coif_asset_patches, same_.patches());
  check(coif_asset_stored_lods, same_.stored_lods());
  check(coif_asset_lod_bones, same_.lod_bones());
  check(coif_asset_orders, same_.orders());
  check(coif_asset_order_views, same_.order_views());
  check(coif_asset_textures, same_.textures());
  check(coif_asset_reliefs, same_.reliefs());
}

TEST_F(CAsset, MembersMeanWhatTheRecordsOnesDo) {
  const coif_skeleton* const skeleton = coif_asset_skeleton(&asset_);
  ASSERT_NE(skeleton, nullptr);
  EXPECT_EQ(skeleton->bone_count, same_.skeleton().bone_count);
  EXPECT_EQ(skeleton->head_joint[1], same_.skeleton().head_joint[1]);
  EXPECT_EQ(skeleton->head_rotation[3], same_.skeleton().head_rotation[3]);
  const coif_bone& bone = coif_asset_bones(&asset_, nullptr)[3];
  EXPECT_EQ(bone.parent, 2u);
  EXPECT_EQ(bone.kind, std::uint32_t(COIF_BONE_SIMULATED));
  EXPECT_EQ(bone.length, same_.bones()[3].length);
  EXPECT_EQ(bone.rest_direction[1], -1.0f);
  EXPECT_EQ(coif_asset_bones(&asset_, nullptr)[0].parent, COIF_NONE);
  const coif_collider& inside = coif_asset_colliders(&asset_, nullptr)[1];
  EXPECT_EQ(inside.shape, std::uint32_t(COIF_CAPSULE));
  EXPECT_EQ(inside.flags, COIF_KEEPS_INSIDE);
  EXPECT_EQ(inside.axis[1], same_.colliders()[1].axis[1]);
  EXPECT_EQ(coif_asset_vertices(&asset_, nullptr)[4].uv[0], same_.vertices()[4].uv[0]);
  EXPECT_EQ(coif_asset_skin(&asset_, nullptr)[4].weight[0], same_.skin()[4].weight[0]);
  EXPECT_EQ(coif_asset_material(&asset_)->secondary_exponent, same_.material()->secondary_exponent);
  EXPECT_STREQ(coif_asset_bone_name(&asset_, 4), "fringe");
  EXPECT_STREQ(coif_asset_bone_name(&asset_, 5), "");
  EXPECT_STREQ(coif_asset_body_bone_name(&asset_, 0), same_.body_bone_name(0));
  EXPECT_STREQ(coif_asset_body_bone_name(&asset_, 99), "");
  EXPECT_EQ(coif_asset_body_bones(&asset_, nullptr)[0].joint[1], same_.body_bones()[0].joint[1]);
  EXPECT_EQ(coif_asset_limits(&asset_, nullptr)[2].angles[0], same_.limits()[2].angles[0]);
  EXPECT_EQ(coif_asset_links(&asset_, nullptr)[0].longest, same_.links()[0].longest);
}

TEST_F(CAsset, LevelsAreTheSame) {
  ASSERT_EQ(coif_asset_lod_count(&asset_), 2u);
  for (std::uint32_t lod = 0; lod < 2; ++lod) {
    std::uint32_t count = 0;
    const coif_patch* const patches = coif_asset_lod_patches(&asset_, lod, &count);
    expect_same(patches, count, same_.lod_patches(lod));
    const std::uint32_t* const indices = coif_asset_lod_indices(&asset_, lod, &count);
    expect_same(indices, count, same_.lod_indices(lod));
  }
  std::uint32_t count = 7;
  EXPECT_EQ(coif_asset_lod_indices(&asset_, 2, &count), nullptr);
  EXPECT_EQ(count, 0u);
  EXPECT_EQ(coif_screen_share(0.25f, 3, 1), screen_share(0.25f, 3, 1));
  for (const float share : {0.9f, 0.31f, 0.29f, 0.1f, std::numeric_limits<float>::quiet_NaN()}) {
    for (const std::uint32_t current : {0u, 1u}) {
      for (const float hysteresis : {0.0f, 0.1f}) {
        EXPECT_EQ(coif_asset_choose_lod(&asset_, share, current, hysteresis),
                  choose_lod(same_.stored_lods(), share, current, hysteresis));
      }
    }
  }
  for (const float dt : {1.0f / 240, 1.0f / 60, 0.1f}) {
    EXPECT_EQ(coif_asset_tuned_substeps(&asset_, dt), tuned_substeps(same_, dt));
  }
}

TEST_F(CAsset, TexturesHaveTheirTexels) {
  for (std::uint32_t role = COIF_BASE_COLOR; role <= COIF_STRAND_MAP; ++role) {
    const coif_texture* const texture = coif_asset_texture(&asset_, role);
    const TextureRecord* const record = same_.texture(TextureRole(role));
    ASSERT_NE(texture, nullptr);
    EXPECT_EQ(texture->format, std::uint32_t(record->format));
    EXPECT_EQ(texture->width, record->width);
    for (std::uint32_t mip = 0; mip < record->mip_count; ++mip) {
      std::size_t bytes = 0;
      EXPECT_EQ(coif_asset_texels(&asset_, texture, mip, &bytes), same_.texels(*record, mip).data());
      EXPECT_EQ(bytes, same_.texels(*record, mip).size());
    }
    std::size_t bytes = 7;
    EXPECT_EQ(coif_asset_texels(&asset_, texture, record->mip_count, &bytes), nullptr);
    EXPECT_EQ(bytes, 0u);
    const coif_texture copy = *texture;  // could say anything
    EXPECT_EQ(coif_asset_texels(&asset_, &copy, 0, nullptr), nullptr);
  }
  EXPECT_EQ(coif_asset_texture(&asset_, 4), nullptr);
  EXPECT_EQ(coif_asset_texels(&asset_, nullptr, 0, nullptr), nullptr);
}

TEST_F(CAsset, CopiesAreAsGood) {
  const auto copy = std::make_unique<coif_asset>(asset_);
  std::memset(&asset_, 0, sizeof asset_);
  EXPECT_EQ(coif_asset_bones(copy.get(), nullptr)[2].length, same_.bones()[2].length);
  EXPECT_EQ(coif_asset_bones(&asset_, nullptr), nullptr);
}

TEST_F(CAsset, SaysWhatIsWrongWithAFile) {
  const auto bytes = file_.bytes();
  for (std::size_t size = 0; size < bytes.size(); size += 97) {
    char why[160] = "";
    coif_asset asset = asset_;
    EXPECT_EQ(coif_asset_open(&asset, bytes.data(), size, why, sizeof why), COIF_ASSET_LACKS_DATA) << size;
    EXPECT_GT(std::strlen(why), 10u) << size;
    EXPECT_EQ(coif_asset_bones(&asset, nullptr), nullptr) << "a refused asset must leave the view empty";
    EXPECT_EQ(coif_check_asset(bytes.data(), size, nullptr, 0), 0);
  }
  char why[8] = "";
  EXPECT_EQ(coif_check_asset(bytes.data(), 3, why, sizeof why), 0);
  EXPECT_EQ(std::strlen(why), sizeof why - 1) << "cut at the capacity";
  EXPECT_EQ(coif_check_asset(nullptr, 100, nullptr, 0), 0);
  EXPECT_EQ(coif_asset_open(nullptr, bytes.data(), bytes.size(), nullptr, 0), COIF_BAD_ARGUMENT);
}

TEST_F(CAsset, DrawDataIsComparedWhenAsked) {
  char why[160] = "";
  EXPECT_EQ(coif_check_asset(file_.bytes().data(), file_.bytes().size(), why, sizeof why), 1);
  EXPECT_EQ(coif_asset_verify_draw_data(&asset_, why, sizeof why), 1);
  EXPECT_STREQ(why, "");
  const auto* const texels = static_cast<const std::byte*>(
      coif_asset_texels(&asset_, coif_asset_texture(&asset_, COIF_BASE_COLOR), 0, nullptr));
  file_.bytes()[std::size_t(texels - file_.bytes().data())] ^= std::byte{1};
  EXPECT_EQ(coif_asset_open(&asset_, file_.bytes().data(), file_.bytes().size(), why, sizeof why), COIF_OK);
  EXPECT_EQ(coif_asset_verify_draw_data(&asset_, why, sizeof why), 0);
  EXPECT_NE(std::string(why).find("TEXD"), std::string::npos) << why;
  EXPECT_EQ(coif_check_asset(file_.bytes().data(), file_.bytes().size(), nullptr, 0), 0);
}

TEST_F(CAsset, OfAnAssetThatIsNotOpenThereIsNothing) {
  const coif_asset closed{};
  for (const coif_asset* const none : {static_cast<const coif_asset*>(nullptr), &closed}) {
    std::uint32_t count = 7;
    EXPECT_EQ(coif_asset_vertices(none, &count), nullptr);
    EXPECT_EQ(count, 0u);
    EXPECT_EQ(coif_asset_bones(none, nullptr), nullptr);
    EXPECT_EQ(coif_asset_skeleton(none), nullptr);
    EXPECT_EQ(coif_asset_material(none), nullptr);
    EXPECT_EQ(coif_asset_texture(none, COIF_BASE_COLOR), nullptr);
    EXPECT_EQ(coif_asset_lod_count(none), 0u);
    EXPECT_EQ(coif_asset_choose_lod(none, 0.5f, 3, 0.1f), 0u);
    EXPECT_EQ(coif_asset_tuned_substeps(none, 1.0f / 60), tuned_substeps(Asset(), 1.0f / 60));
    EXPECT_STREQ(coif_asset_bone_name(none, 0), "");
    EXPECT_EQ(coif_asset_verify_draw_data(none, nullptr, 0), 0);
    EXPECT_EQ(coif_skin_vertices(none, nullptr, 0, 0, nullptr, 0), COIF_ASSET_LACKS_DATA);
  }
}

TEST_F(CAsset, SkinsToTheSameBits) {
  const std::vector<Mat34> palette = bent_palette(std::uint32_t(same_.bones().size()));
  const auto* const in_c = reinterpret_cast<const coif_mat34*>(palette.data());
  const auto bones = std::uint32_t(palette.size());
  std::vector<SkinnedVertex> same(4);
  std::vector<coif_skinned_vertex> skinned(4);
  ASSERT_EQ(skin_vertices(same_, palette, 2, same), Status::kOk);
  ASSERT_EQ(coif_skin_vertices(&asset_, in_c, bones, 2, skinned.data(), 4), COIF_OK);
  EXPECT_EQ(std::memcmp(same.data(), skinned.data(), sizeof same[0] * same.size()), 0);
  EXPECT_EQ(coif_skin_vertices(&asset_, in_c, bones, 6, skinned.data(), 4), COIF_BAD_INDEX);
  EXPECT_EQ(coif_skin_vertices(&asset_, in_c, bones - 1, 2, skinned.data(), 4), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_skin_vertices(&asset_, nullptr, bones, 2, skinned.data(), 4), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_skin_vertices(&asset_, in_c, bones, 2, nullptr, 4), COIF_SIZE_MISMATCH);
}

}  // namespace coif::c_asset_test
