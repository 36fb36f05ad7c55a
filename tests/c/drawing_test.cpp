// What any renderer computes, in C: the same numbers as in C++, and a status for what cannot be.

#include "models/skinned_asset.h"
#include "models/small_asset.h"

#include <coif.h>
#include <coif/drawing.h>
#include <coif/triangle_order.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

namespace coif::c_drawing_test {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class CDrawing : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(same_.open(file_.bytes()));
    ASSERT_EQ(coif_asset_open(&asset_, file_.bytes().data(), file_.bytes().size(), nullptr, 0), COIF_OK);
    ASSERT_EQ(coif_drawn_hair_of(&asset_, &hair_), COIF_OK);
    same_hair_ = drawn_hair_of(same_);
    coif_draw_view_init(&view_);
    for (int i = 0; i < 4; ++i) view_.clip_from_world[5 * i] = 1;  // orthographic, a metre each way
    view_.eye = {0.1f, 0.2f, 0.3f};
    coif_head_pose_init(&head_);
  }

  [[nodiscard]] DrawView same_view(std::span<const Light> lights) const {
    DrawView view;
    std::memcpy(view.clip_from_world, view_.clip_from_world, sizeof view.clip_from_world);
    view.eye = {view_.eye.x, view_.eye.y, view_.eye.z};
    view.lights = lights;
    return view;
  }

  AlignedBytes file_{write_asset(small_asset())};
  coif_asset asset_{};
  Asset same_;
  coif_drawn_hair hair_{};
  DrawnHair same_hair_;
  coif_draw_view view_{};
  coif_head_pose head_{};
};

TEST_F(CDrawing, KnowsTheSameOfAnAsset) {
  ASSERT_EQ(hair_.lod_count, same_hair_.lod_count);
  for (std::uint32_t lod = 0; lod < hair_.lod_count; ++lod) {
    EXPECT_EQ(hair_.lods[lod].first, same_hair_.lods[lod].first);
    EXPECT_EQ(hair_.lods[lod].count, same_hair_.lods[lod].count);
  }
  EXPECT_EQ(hair_.order_count, 3u);
  EXPECT_EQ(hair_.indices_of_order, same_hair_.indices_of_order);
  EXPECT_EQ(hair_.index_bytes, same_hair_.index_bytes);
  EXPECT_EQ(std::memcmp(hair_.order_of_view, same_hair_.order_of_view, sizeof hair_.order_of_view), 0);
  EXPECT_GT(hair_.reach.radius, 0);
  EXPECT_EQ(std::memcmp(&hair_.reach, &same_hair_.reach, sizeof hair_.reach), 0);
  EXPECT_EQ(std::memcmp(&hair_.alpha, &same_hair_.alpha, sizeof hair_.alpha), 0);
  EXPECT_EQ(hair_.bone_count, 5u);
  EXPECT_EQ(hair_.skinning, std::uint32_t(COIF_FOUR_BONES));
  EXPECT_EQ(std::memcmp(&hair_.material, &same_hair_.material, sizeof hair_.material), 0);
}

TEST_F(CDrawing, WithoutAMeshThereIsNothingToKnow) {
  AlignedBytes file(write_asset(without_mesh(small_asset())));
  coif_asset bare;
  ASSERT_EQ(coif_asset_open(&bare, file.bytes().data(), file.bytes().size(), nullptr, 0), COIF_OK);
  coif_drawn_hair hair = hair_;
  EXPECT_EQ(coif_drawn_hair_of(&bare, &hair), COIF_ASSET_LACKS_DATA);
  EXPECT_EQ(coif_drawn_hair_of(nullptr, &hair), COIF_ASSET_LACKS_DATA);
  EXPECT_EQ(hair.lod_count, hair_.lod_count) << "left as it was";
  EXPECT_EQ(coif_drawn_hair_of(&asset_, nullptr), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_write_draw_orders(&bare, &hair_, &hair, 1), COIF_BAD_ARGUMENT) << "another asset's";
}

TEST_F(CDrawing, WritesTheSameIndices) {
  const std::size_t bytes = std::size_t{hair_.order_count} * hair_.indices_of_order * hair_.index_bytes;
  std::vector<std::byte> indices(bytes), same(bytes);
  write_draw_orders(same_, same_hair_, same);
  ASSERT_EQ(coif_write_draw_orders(&asset_, &hair_, indices.data(), bytes), COIF_OK);
  EXPECT_EQ(indices, same);
  EXPECT_EQ(coif_write_draw_orders(&asset_, &hair_, indices.data(), bytes - 1), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_write_draw_orders(&asset_, &hair_, nullptr, bytes), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_write_draw_orders(&asset_, nullptr, indices.data(), bytes), COIF_BAD_ARGUMENT);
}

TEST_F(CDrawing, ChoosesTheOrderOfEachCell) {
  for (std::uint32_t cell = 0; cell < kViewCells; ++cell) {
    float direction[3] = {}, same[3];
    ASSERT_EQ(coif_view_cell_direction(cell, direction), COIF_OK);
    view_cell_direction(cell, same);
    EXPECT_EQ(std::memcmp(direction, same, sizeof same), 0);
    EXPECT_EQ(coif_view_cell(direction), cell);
    EXPECT_EQ(coif_choose_order(&hair_, direction), same_.order_views()[cell]);
  }
  float direction[3] = {1, 2, 3};
  EXPECT_EQ(coif_view_cell_direction(kViewCells, direction), COIF_BAD_INDEX);
  EXPECT_EQ(direction[1], 2);
  EXPECT_EQ(coif_choose_order(nullptr, direction), 0u);
  EXPECT_EQ(coif_choose_order(&hair_, nullptr), 0u);
}

TEST_F(CDrawing, FillsTheSameBlock) {
  coif_light lights[3];
  Light same[3];
  for (coif_light& light : lights) coif_light_init(&light);
  for (int kind = 0; kind < 3; ++kind) {
    lights[kind].kind = std::uint32_t(kind);
    lights[kind].from = {float(kind), 2, 3};
    lights[kind].color = {0.5f, 0.25f, float(kind)};
    same[kind].kind = Light::Kind(kind);
    same[kind].from = {float(kind), 2, 3};
    same[kind].color = {0.5f, 0.25f, float(kind)};
  }
  view_.lights = lights;
  view_.light_count = 3;
  coif_vec3 harmonics[COIF_SKY_HARMONICS];
  SkyLight sky;
  for (int i = 0; i < COIF_SKY_HARMONICS; ++i) {
    harmonics[i] = {0.1f * float(i), 0.2f, -0.3f};
    sky.harmonics[i] = {0.1f * float(i), 0.2f, -0.3f};
  }
  view_.sky = harmonics;
  DrawView same_of = same_view(same);
  same_of.sky = &sky;
  coif_draw_block block{};
  DrawBlock expected;
  ASSERT_EQ(fill_draw_block(same_of, same_hair_.material, 18, expected), Status::kOk);
  ASSERT_EQ(coif_fill_draw_block(&view_, &hair_.material, 18, &block), COIF_OK);
  EXPECT_EQ(std::memcmp(&block, &expected, sizeof block), 0);
}

TEST_F(CDrawing, RefusesABlockOfNonsense) {
  coif_draw_block block{}, untouched{};
  block.fiber[0] = untouched.fiber[0] = 7;
  const auto refused = [&](const coif_draw_view& view, const coif_material& material) {
    return coif_fill_draw_block(&view, &material, 3, &block) == COIF_BAD_ARGUMENT &&
           std::memcmp(&block, &untouched, sizeof block) == 0;
  };
  coif_light light;
  coif_light_init(&light);  // from nowhere
  coif_draw_view view = view_;
  view.eye.x = kNan;
  EXPECT_TRUE(refused(view, hair_.material));
  view = view_;
  view.component = 256;  // not 0, as the last byte alone would say
  EXPECT_TRUE(refused(view, hair_.material));
  view = view_;
  view.light_count = 1;
  EXPECT_TRUE(refused(view, hair_.material)) << "of no lights";
  view.lights = &light;
  EXPECT_TRUE(refused(view, hair_.material));
  light.from = {0, 1, 0};
  coif_vec3 harmonics[COIF_SKY_HARMONICS]{};
  harmonics[8].z = kNan;
  view.sky = harmonics;
  EXPECT_TRUE(refused(view, hair_.material));
  harmonics[8].z = 0;
  EXPECT_FALSE(refused(view, hair_.material));
  block.fiber[0] = 7;
  untouched = block;
  light.kind = 256;
  EXPECT_TRUE(refused(view, hair_.material));
  view.light_count = COIF_MAX_LIGHTS + 1;
  EXPECT_TRUE(refused(view, hair_.material));
  coif_material material = hair_.material;
  material.shading = 3;
  EXPECT_TRUE(refused(view_, material));
  EXPECT_EQ(coif_fill_draw_block(nullptr, &material, 3, &block), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_fill_draw_block(&view_, nullptr, 3, &block), COIF_BAD_ARGUMENT);
  EXPECT_EQ(coif_fill_draw_block(&view_, &hair_.material, 3, nullptr), COIF_BAD_ARGUMENT);
}

TEST_F(CDrawing, WritesTheSameRowsOfAHead) {
  const std::vector<Mat34> palette = bent_palette(5);
  const auto* const in_c = reinterpret_cast<const coif_mat34*>(palette.data());
  coif_matrix_layout layout;
  ASSERT_EQ(coif_matrix_layout_of(&hair_, 16384, &layout), COIF_OK);
  const MatrixLayout same_layout = matrix_layout_of(same_hair_, 16384);
  EXPECT_EQ(layout.rows_of_head, same_layout.rows_of_head);
  EXPECT_EQ(layout.heads_of_batch, same_layout.heads_of_batch);
  EXPECT_EQ(layout.bones_in_texture, 0u);
  EXPECT_EQ(coif_matrix_layout_of(&hair_, 16383, &layout), COIF_BAD_ARGUMENT);

  HeadPose pose;
  head_.position[0] = pose.position[0] = 100'000.25;
  head_.rotation[1] = pose.rotation.y = 0.6f;
  head_.rotation[3] = pose.rotation.w = 0.8f;
  const coif_vec3 eye{1, 2, 3};
  const std::size_t bytes = 16 * layout.rows_of_head;
  std::vector<std::byte> rows(bytes), same(bytes);
  write_head(same_layout, {pose, palette, 0}, {1, 2, 3}, same.data());
  ASSERT_EQ(coif_write_head(&hair_, &layout, &head_, in_c, 5, &eye, rows.data(), bytes), COIF_OK);
  EXPECT_EQ(rows, same);

  const auto status = [&](std::uint32_t count, std::size_t room) {
    return coif_write_head(&hair_, &layout, &head_, in_c, count, &eye, rows.data(), room);
  };
  EXPECT_EQ(status(4, bytes), COIF_SIZE_MISMATCH);
  EXPECT_EQ(status(5, bytes - 16), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_write_head(&hair_, &layout, &head_, nullptr, 5, &eye, rows.data(), bytes), COIF_SIZE_MISMATCH);
  EXPECT_EQ(coif_write_head(&hair_, &layout, nullptr, in_c, 5, &eye, rows.data(), bytes), COIF_BAD_POSE);
  layout.rows_of_head += 1;  // not this hair's
  EXPECT_EQ(status(5, bytes + 16), COIF_SIZE_MISMATCH);
  head_.rotation[1] = kNan;
  EXPECT_EQ(status(5, bytes), COIF_BAD_POSE);
  EXPECT_EQ(rows, same) << "left as it was";
}

TEST_F(CDrawing, SeesHeadsThatVisibleCrowdSees) {
  const std::vector<Mat34> palette = bent_palette(5);
  const coif_vec3 eye{0, 0, 0};
  int seen = 0;
  for (int i = -12; i <= 12; ++i) {
    HeadPose pose;
    head_.position[0] = pose.position[0] = 0.25 * i;
    head_.position[1] = pose.position[1] = 0.1 * (i % 4);
    const HairInstance instance{pose, palette, 0};
    const VisibleCrowd crowd(same_hair_, {&instance, 1}, {}, view_.clip_from_world);
    std::uint32_t order = 99, expected = 99;
    const bool is_seen = !crowd.for_each_group([&](const VisibleCrowd::Group& group) {
      expected = group.order;
      return false;
    });
    EXPECT_EQ(coif_is_in_view(&hair_, &head_, &eye, view_.clip_from_world, &order), is_seen ? 1 : 0) << i;
    EXPECT_EQ(order, expected) << i;
    seen += is_seen ? 1 : 0;
  }
  EXPECT_GT(seen, 3);
  EXPECT_LT(seen, 20);
  head_.position[0] = 0;
  EXPECT_EQ(coif_is_in_view(&hair_, &head_, &eye, view_.clip_from_world, nullptr), 1);
  EXPECT_EQ(coif_is_in_view(&hair_, &head_, nullptr, view_.clip_from_world, nullptr), 0);
  EXPECT_EQ(coif_is_in_view(nullptr, &head_, &eye, view_.clip_from_world, nullptr), 0);
  head_.position[0] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(coif_is_in_view(&hair_, &head_, &eye, view_.clip_from_world, nullptr), 0);
}

TEST_F(CDrawing, SortsBonesAlike) {
  const std::vector<Mat34> palette = bent_palette(5);
  const auto* const in_c = reinterpret_cast<const coif_mat34*>(palette.data());
  std::vector<std::byte> room(BoneOrder::memory_bytes(same_) + 16);
  AlignedBytes same_memory(room);
  BoneOrder same;
  ASSERT_EQ(same.create(same_, same_memory.bytes()), Status::kOk);
  AlignedBytes memory(std::vector<std::byte>(coif_bone_order_memory_need(&asset_)));
  coif_bone_order* order = nullptr;
  ASSERT_EQ(coif_bone_order_create(&asset_, memory.bytes().data(), memory.bytes().size(), &order), COIF_OK);
  const coif_vec3 eye{0.3f, -0.5f, 2};
  for (std::uint32_t lod = 0; lod < 2; ++lod) {
    const std::size_t bytes = std::size_t{hair_.lods[lod].count} * hair_.index_bytes;
    std::vector<std::byte> indices(bytes), expected(bytes);
    same.write({HeadPose{}, palette, lod}, {0.3f, -0.5f, 2}, expected.data());
    ASSERT_EQ(coif_bone_order_write(order, &hair_, &head_, in_c, 5, lod, &eye, indices.data(), bytes), COIF_OK);
    EXPECT_EQ(indices, expected);
    EXPECT_EQ(coif_bone_order_write(order, &hair_, &head_, in_c, 5, lod, &eye, indices.data(), bytes + 2),
              COIF_SIZE_MISMATCH);
  }
}

TEST_F(CDrawing, RefusesToSortWhatCannotBe) {
  AlignedBytes bare_file(write_asset(without_mesh(small_asset())));
  coif_asset bare;
  ASSERT_EQ(coif_asset_open(&bare, bare_file.bytes().data(), bare_file.bytes().size(), nullptr, 0), COIF_OK);
  AlignedBytes memory(std::vector<std::byte>(coif_bone_order_memory_need(&asset_)));
  std::byte* const begin = memory.bytes().data();
  const std::size_t need = memory.bytes().size();
  coif_bone_order* order = nullptr;
  EXPECT_EQ(coif_bone_order_memory_need(&bare), 0u);
  EXPECT_EQ(coif_bone_order_create(&bare, begin, need, &order), COIF_ASSET_LACKS_DATA);
  EXPECT_EQ(coif_bone_order_create(nullptr, begin, need, &order), COIF_ASSET_LACKS_DATA);
  EXPECT_EQ(coif_bone_order_create(&asset_, begin, need - 1, &order), COIF_MEMORY_TOO_SMALL);
  EXPECT_EQ(coif_bone_order_create(&asset_, begin + 16, need, &order), COIF_MEMORY_TOO_SMALL);
  EXPECT_EQ(coif_bone_order_create(&asset_, nullptr, need, &order), COIF_MEMORY_TOO_SMALL);
  EXPECT_EQ(order, nullptr);
  EXPECT_EQ(coif_bone_order_create(&asset_, begin, need, nullptr), COIF_BAD_ARGUMENT);
  ASSERT_EQ(coif_bone_order_create(&asset_, begin, need, &order), COIF_OK);
  const std::vector<Mat34> palette = bent_palette(5);
  const coif_vec3 eye{0, 0, 2};
  std::byte out[64];
  const auto status = [&](coif_bone_order* by, const coif_head_pose* head, std::uint32_t bones, std::uint32_t lod) {
    const auto* const in_c = reinterpret_cast<const coif_mat34*>(palette.data());
    return coif_bone_order_write(by, &hair_, head, in_c, bones, lod, &eye, out, 12);
  };
  EXPECT_EQ(status(order, &head_, 5, 0), COIF_OK);
  EXPECT_EQ(status(nullptr, &head_, 5, 0), COIF_NOT_CREATED);
  EXPECT_EQ(status(order, nullptr, 5, 0), COIF_BAD_POSE);
  EXPECT_EQ(status(order, &head_, 4, 0), COIF_SIZE_MISMATCH);
  EXPECT_EQ(status(order, &head_, 5, 2), COIF_BAD_ARGUMENT);
  hair_.bone_count = 6;
  EXPECT_EQ(status(order, &head_, 5, 0), COIF_BAD_ARGUMENT) << "another asset's";
}

TEST_F(CDrawing, DefaultsAreThoseOfTheOtherInterface) {
  coif_light light;
  coif_light_init(&light);
  EXPECT_EQ(light.color.x, Light{}.color.x);
  EXPECT_EQ(light.spot_axis.y, Light{}.spot_axis.y);
  EXPECT_EQ(light.inner_cosine, Light{}.inner_cosine);
  EXPECT_EQ(light.outer_cosine, Light{}.outer_cosine);
  coif_draw_view_init(&view_);
  EXPECT_EQ(view_.light_count, 0u);
  EXPECT_EQ(view_.lights, nullptr);
  EXPECT_EQ(view_.framebuffer_is_srgb, 0u);
}

}  // namespace coif::c_drawing_test
