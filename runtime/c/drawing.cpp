// The parts of drawing that any renderer needs, in C.
#include "drawing_types.h"

#include <algorithm>

namespace {

using coif::c::code;
using coif::c::copied;
using coif::c::hair_of;
using coif::c::matrices_of;
using coif::c::pose_of;
using coif::c::vector_of;
using coif::c::view_of;

static_assert(COIF_VIEW_CELLS == coif::kViewCells && COIF_MAX_LIGHTS == coif::kMaxLights);
static_assert(COIF_SKY_HARMONICS == int(coif::SkyLight::kHarmonics));
static_assert(COIF_FOUR_BONES == int(coif::Skinning::kFourBones) && COIF_SPOT == int(coif::Light::Kind::kSpot));
static_assert(COIF_STRAND_DIRECTION == int(coif::Component::kDirection));

COIF_SAME(coif_material, base_color, coif::MaterialRecord, base_color);
COIF_SAME(coif_material, ambient, coif::MaterialRecord, ambient);
COIF_SAME(coif_material, opaque_threshold, coif::MaterialRecord, opaque_threshold);
COIF_SAME(coif_material, primary_color, coif::MaterialRecord, primary_color);
COIF_SAME(coif_material, primary_exponent, coif::MaterialRecord, primary_exponent);
COIF_SAME(coif_material, secondary_color, coif::MaterialRecord, secondary_color);
COIF_SAME(coif_material, secondary_exponent, coif::MaterialRecord, secondary_exponent);
COIF_SAME(coif_material, primary_shift, coif::MaterialRecord, primary_shift);
COIF_SAME(coif_material, secondary_shift, coif::MaterialRecord, secondary_shift);
COIF_SAME(coif_material, discard_threshold, coif::MaterialRecord, discard_threshold);
COIF_SAME(coif_material, flags, coif::MaterialRecord, flags);
COIF_SAME(coif_material, shading, coif::MaterialRecord, shading);
COIF_SAME(coif_material, tilt, coif::MaterialRecord, tilt);
COIF_SAME(coif_material, roughness, coif::MaterialRecord, roughness);
COIF_SAME(coif_material, scatter, coif::MaterialRecord, scatter);
COIF_SAME(coif_material, light_cut, coif::MaterialRecord, light_cut);
COIF_SAME(coif_material, glow, coif::MaterialRecord, glow);
COIF_SAME(coif_material, root_shade, coif::MaterialRecord, root_shade);
COIF_SAME(coif_material, variation, coif::MaterialRecord, variation);
static_assert(sizeof(coif_material) == sizeof(coif::MaterialRecord));
static_assert(COIF_DOUBLE_SIDED == coif::kMaterialDoubleSided && COIF_FACES_TOGETHER == coif::kMaterialFacesTogether &&
              COIF_VOLUME_NORMALS == coif::kMaterialVolumeNormals);

COIF_SAME(coif_draw_block, clip_from_view, coif::DrawBlock, clip_from_view);
COIF_SAME(coif_draw_block, base_color, coif::DrawBlock, base_color);
COIF_SAME(coif_draw_block, fiber, coif::DrawBlock, fiber);
COIF_SAME(coif_draw_block, strands, coif::DrawBlock, strands);
COIF_SAME(coif_draw_block, light_position, coif::DrawBlock, light_position);
COIF_SAME(coif_draw_block, sky, coif::DrawBlock, sky);
COIF_SAME(coif_draw_block, light_color, coif::DrawBlock, light_color);
COIF_SAME(coif_draw_block, light_spot, coif::DrawBlock, light_spot);
static_assert(offsetof(coif_draw_block, shadow_from_view) == offsetof(coif::DrawBlock, shadow));
static_assert(sizeof(coif_draw_block) == sizeof(coif::DrawBlock));

coif::Light light_of(const coif_light& from) {
  coif::Light light;
  // Kinds that do not fit into a byte become the last value, which is refused as unknown.
  light.kind = static_cast<coif::Light::Kind>(from.kind < 255 ? from.kind : 255);
  light.from = vector_of(from.from);
  light.color = vector_of(from.color);
  light.spot_axis = vector_of(from.spot_axis);
  light.inner_cosine = from.inner_cosine;
  light.outer_cosine = from.outer_cosine;
  return light;
}

coif_vec3 in_c(const coif::Vec3& from) { return {from.x, from.y, from.z}; }

}  // namespace

extern "C" {

coif_status coif_drawn_hair_of(const coif_asset* asset, coif_drawn_hair* out) {
  const coif::Asset& opened = view_of(asset);
  if (out == nullptr) return COIF_BAD_ARGUMENT;
  if (opened.vertices().empty() || opened.indices().empty()) return COIF_ASSET_LACKS_DATA;
  const coif::DrawnHair hair = coif::drawn_hair_of(opened);
  *out = {};
  for (uint32_t lod = 0; lod < hair.lod_count; ++lod) out->lods[lod] = {hair.lods[lod].first, hair.lods[lod].count};
  out->lod_count = hair.lod_count;
  out->order_count = hair.order_count;
  out->indices_of_order = hair.indices_of_order;
  out->index_bytes = hair.index_bytes;
  std::memcpy(out->order_of_view, hair.order_of_view, sizeof out->order_of_view);
  out->reach = copied<coif_reach>(hair.reach);
  out->alpha = copied<coif_alpha_range>(hair.alpha);
  out->bone_count = hair.bone_count;
  out->skinning = static_cast<uint32_t>(hair.skinning);
  out->material = copied<coif_material>(hair.material);
  return COIF_OK;
}

coif_status coif_write_draw_orders(const coif_asset* asset, const coif_drawn_hair* hair, void* out, size_t bytes) {
  const coif::Asset& opened = view_of(asset);
  if (hair == nullptr) return COIF_BAD_ARGUMENT;
  const uint32_t index_bytes = opened.vertices().size() <= 0xFFFF ? 2 : 4;
  const bool is_its_own = hair->indices_of_order == opened.indices().size() && hair->index_bytes == index_bytes &&
                          hair->order_count == opened.order_count();
  if (!is_its_own) return COIF_BAD_ARGUMENT;
  const size_t need = size_t{hair->order_count} * hair->indices_of_order * index_bytes;
  if (out == nullptr || bytes != need) return COIF_SIZE_MISMATCH;
  coif::write_draw_orders(opened, hair_of(*hair), {static_cast<std::byte*>(out), bytes});
  return COIF_OK;
}

uint32_t coif_choose_order(const coif_drawn_hair* hair, const float direction[3]) {
  return hair == nullptr || direction == nullptr ? 0 : hair->order_of_view[coif_view_cell(direction)];
}

uint32_t coif_view_cell(const float direction[3]) {
  if (direction == nullptr) return 0;
  return coif::view_cell({direction[0], direction[1], direction[2]});
}

coif_status coif_view_cell_direction(uint32_t cell, float direction[3]) {
  if (cell >= coif::kViewCells) return COIF_BAD_INDEX;
  if (direction == nullptr) return COIF_BAD_ARGUMENT;
  float middle[3];
  coif::view_cell_direction(cell, middle);
  std::memcpy(direction, middle, sizeof middle);
  return COIF_OK;
}

int coif_is_in_view(const coif_drawn_hair* hair, const coif_head_pose* head, const coif_vec3* eye,
                    const float clip_from_view[16], uint32_t* order) {
  if (hair == nullptr || head == nullptr || eye == nullptr || clip_from_view == nullptr) return 0;
  coif::DrawnHair drawn = hair_of(*hair);
  drawn.skinning = coif::Skinning::kRigid;
  const coif::HairInstance instance{pose_of(*head), {}, 0};
  if (coif::check_instance(drawn, instance) != coif::Status::kOk) return 0;
  float clip[16];
  std::memcpy(clip, clip_from_view, sizeof clip);
  const coif::VisibleCrowd crowd(drawn, {&instance, 1}, vector_of(*eye), clip);
  const auto take_first = [order](const coif::VisibleCrowd::Group& group) {
    if (order != nullptr) *order = group.order;
    return false;
  };
  return crowd.for_each_group(take_first) ? 0 : 1;
}

void coif_light_init(coif_light* light) {
  const coif::Light usual;
  *light = {static_cast<uint32_t>(usual.kind),
            in_c(usual.from),
            in_c(usual.color),
            in_c(usual.spot_axis),
            usual.inner_cosine,
            usual.outer_cosine};
}

void coif_draw_view_init(coif_draw_view* view) { *view = {}; }

coif_status coif_fill_draw_block(const coif_draw_view* from, const coif_material* material, uint32_t rows_of_head,
                                 coif_draw_block* block) {
  if (from == nullptr || material == nullptr || block == nullptr) return COIF_BAD_ARGUMENT;
  if (from->light_count > COIF_MAX_LIGHTS || (from->light_count > 0 && from->lights == nullptr))
    return COIF_BAD_ARGUMENT;
  coif::Light lights[COIF_MAX_LIGHTS];
  for (uint32_t i = 0; i < from->light_count; ++i) lights[i] = light_of(from->lights[i]);
  coif::DrawView view;
  std::memcpy(view.clip_from_world, from->clip_from_world, sizeof view.clip_from_world);
  view.eye = vector_of(from->eye);
  view.lights = {lights, from->light_count};
  coif::SkyLight sky;
  if (from->sky != nullptr) {
    std::transform(from->sky, from->sky + COIF_SKY_HARMONICS, sky.harmonics, vector_of);
    view.sky = &sky;
  }
  view.component = static_cast<coif::Component>(from->component < 255 ? from->component : 255);
  view.framebuffer_is_srgb = from->framebuffer_is_srgb != 0;
  coif::DrawBlock filled;
  const coif::Status status =
      coif::fill_draw_block(view, copied<coif::MaterialRecord>(*material), rows_of_head, filled);
  if (status == coif::Status::kOk) *block = copied<coif_draw_block>(filled);
  return code(status);
}

coif_status coif_matrix_layout_of(const coif_drawn_hair* hair, uint32_t block_bytes, coif_matrix_layout* out) {
  constexpr uint32_t kLeastBlock = 16384;
  if (hair == nullptr || out == nullptr || block_bytes < kLeastBlock) return COIF_BAD_ARGUMENT;
  const coif::MatrixLayout layout = coif::matrix_layout_of(hair_of(*hair), block_bytes);
  *out = {layout.rows_of_head, layout.heads_of_batch, layout.bones_in_texture ? 1u : 0u};
  return COIF_OK;
}

coif_status coif_write_head(const coif_drawn_hair* hair, const coif_matrix_layout* layout, const coif_head_pose* head,
                            const coif_mat34* palette, uint32_t palette_count, const coif_vec3* eye, void* out,
                            size_t bytes) {
  if (hair == nullptr || layout == nullptr || eye == nullptr) return COIF_BAD_ARGUMENT;
  if (head == nullptr) return COIF_BAD_POSE;
  const std::span<const coif::Mat34> matrices = matrices_of(palette, palette_count);
  const coif::HairInstance instance{pose_of(*head), matrices, 0};
  const coif::Status status = coif::check_instance(hair_of(*hair), instance);
  if (status != coif::Status::kOk) return code(status);
  // The layout has either the head's own matrix alone, or also those of all its bones.
  const bool has_bones = layout->rows_of_head > coif::MatrixLayout::kMatrixRows;
  const size_t need = sizeof(coif::Mat34) * (has_bones ? 1 + matrices.size() : 1);
  const bool is_right = bytes == need && size_t{layout->rows_of_head} * coif::MatrixLayout::kRowBytes == need;
  if (out == nullptr || !is_right) return COIF_SIZE_MISMATCH;
  coif::MatrixLayout rows;
  rows.rows_of_head = layout->rows_of_head;
  rows.heads_of_batch = layout->heads_of_batch;
  rows.bones_in_texture = layout->bones_in_texture != 0;
  coif::write_head(rows, instance, vector_of(*eye), static_cast<std::byte*>(out));
  return COIF_OK;
}

}  // extern "C"
