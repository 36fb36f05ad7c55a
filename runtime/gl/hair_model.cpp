#include "gl/alpha_range.h"
#include "gl/draw_orders.h"
#include "gl/gl_functions.h"
#include "gl/palette_texture.h"
#include "gl/reach.h"
#include "gl/shader_variant.h"
#include "gl/texture_upload.h"
#include "gl/transparency_mode.h"

#include <coif/renderer.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>

namespace coif {
namespace {

// The thesis's Gallery 1, in a brown; for assets without a material of their own.
constexpr MaterialRecord kGalleryMaterial = {
    .base_color = {1.0f, 1.0f, 1.0f, 1.0f},
    .ambient = {0.1f, 0.1f, 0.1f},
    .opaque_threshold = 0.85f,
    .primary_color = {0.5f, 0.5f, 0.5f},
    .primary_exponent = 150.0f,
    .secondary_color = {0.5f, 0.4f, 0.3f},
    .secondary_exponent = 30.0f,
    .primary_shift = 0.7f,
    .secondary_shift = 0.5f,
    .discard_threshold = 0.02f,
    .flags = kMaterialDoubleSided,
    .shading = ShadingModel::kThesis,
    .tilt = 0.05f,
    .roughness = 0.14f,
    .scatter = 0.8f,
    .light_cut = 0.0f,
    .reserved = {},
};

// Attribute locations of shaders/hair.vert.
enum Attribute : GLuint { kPosition, kNormal, kTangent, kTexturePlace, kBones, kWeights };

const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void describe_vertices(const GlFunctions& gl) {
  constexpr GLsizei kStride = sizeof(VertexRecord);
  gl.VertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, kStride, byte_offset(offsetof(VertexRecord, position)));
  gl.VertexAttribPointer(kNormal, 4, GL_SHORT, GL_TRUE, kStride, byte_offset(offsetof(VertexRecord, normal)));
  gl.VertexAttribPointer(kTangent, 4, GL_SHORT, GL_TRUE, kStride, byte_offset(offsetof(VertexRecord, tangent)));
  gl.VertexAttribPointer(kTexturePlace, 2, GL_FLOAT, GL_FALSE, kStride, byte_offset(offsetof(VertexRecord, uv)));
  for (GLuint attribute : {kPosition, kNormal, kTangent, kTexturePlace}) gl.EnableVertexAttribArray(attribute);
}

void describe_skin(const GlFunctions& gl, std::size_t skin_begin) {
  gl.VertexAttribIPointer(kBones, 4, GL_UNSIGNED_SHORT, sizeof(SkinRecord),
                          byte_offset(skin_begin + offsetof(SkinRecord, bone)));
  gl.VertexAttribPointer(kWeights, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(SkinRecord),
                         byte_offset(skin_begin + offsetof(SkinRecord, weight)));
  for (GLuint attribute : {kBones, kWeights}) gl.EnableVertexAttribArray(attribute);
}

/// Every vertex has all its weight on its first bone.
bool needs_one_bone(std::span<const SkinRecord> skin) {
  for (const SkinRecord& vertex : skin) {
    if (vertex.weight[0] != 255) return false;
  }
  return true;
}

std::uint32_t skin_needs(const Asset& asset, std::uint32_t block_bytes) {
  if (asset.skin().empty()) return 0;
  const std::size_t matrices = (1 + asset.bones().size()) * sizeof(Mat34);
  const std::uint32_t place = matrices > block_bytes ? variant::kBonesInTexture : 0;
  return place | (needs_one_bone(asset.skin()) ? variant::kOneBone : variant::kFourBones);
}

std::uint32_t texture_needs(const Asset& asset) {
  return (asset.texture(TextureRole::kBaseColor) != nullptr ? variant::kBaseTexture : 0) |
         (asset.texture(TextureRole::kShiftMask) != nullptr ? variant::kShiftMask : 0);
}

}  // namespace

Status HairModel::upload(HairRenderer& renderer, const Asset& asset, const TransparencyMode& transparency) {
  if (!renderer.is_created()) return Status::kNotCreated;
  if (!asset.is_open() || asset.vertices().empty() || asset.indices().empty()) return Status::kAssetLacksData;
  if (asset.indices().size() > 0x7FFFFFFF) return Status::kDriver;

  const GlFunctions& gl = renderer.functions();
  HairModel fresh;
  fresh.learn(asset, renderer.block_bytes_);
  const PassList passes = transparency.plan_passes(fresh.material_, {fresh.lowest_alpha_, fresh.highest_alpha_});
  const Status built = renderer.build_missing(passes, fresh.needs_, fresh.material_, Component::kAll);
  if (built != Status::kOk) return built;
  clear_errors(gl);
  fresh.upload_mesh(gl, asset);
  const bool has_indices = fresh.upload_indices(gl, asset);
  reset_unpack_state(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  fresh.base_texture_ = upload_texture(gl, asset, TextureRole::kBaseColor);
  fresh.shift_mask_texture_ = upload_texture(gl, asset, TextureRole::kShiftMask);
  if ((fresh.needs_ & variant::kBonesInTexture) != 0) {
    fresh.palette_texture_ = make_palette_texture(gl, fresh.bone_count_);
  }
  gl.BindTexture(GL_TEXTURE_2D, 0);
  if (!has_indices || gl.GetError() != GL_NO_ERROR) {
    fresh.release(gl);
    std::snprintf(renderer.failure_, sizeof renderer.failure_, "out of memory, or a texture is too large");
    return Status::kDriver;
  }
  destroy();
  fresh.renderer_ = &renderer;
  *this = static_cast<HairModel&&>(fresh);
  return Status::kOk;
}

void HairModel::learn(const Asset& asset, std::uint32_t block_bytes) {
  material_ = asset.material() != nullptr ? *asset.material() : kGalleryMaterial;
  bone_count_ = static_cast<std::uint32_t>(asset.bones().size());
  needs_ = skin_needs(asset, block_bytes) | texture_needs(asset);
  const AlphaRange alpha = alpha_range_of(asset);
  lowest_alpha_ = alpha.lowest;
  highest_alpha_ = alpha.highest;
  lod_count_ = asset.lod_count();
  for (std::uint32_t lod = 0; lod < lod_count_; ++lod) {
    const auto count = static_cast<std::uint32_t>(asset.lod_indices(lod).size());
    lods_[lod] = {asset.lod_patches(lod).front().first_index, count};
  }
  const bool is_small = asset.vertices().size() <= 0xFFFF;  // 0xFFFF itself may restart a host's strips
  index_type_ = is_small ? GL_UNSIGNED_SHORT : GL_UNSIGNED_INT;
  index_bytes_ = is_small ? sizeof(std::uint16_t) : sizeof(std::uint32_t);
  order_count_ = asset.order_count();
  indices_of_order_ = static_cast<std::uint32_t>(asset.indices().size());
  std::copy(asset.order_views().begin(), asset.order_views().end(), order_of_view_);
  const Reach reach = reach_of(asset);
  std::copy_n(reach.center, 3, reach_center_);
  reach_ = reach.radius;
}

void HairModel::upload_mesh(const GlFunctions& gl, const Asset& asset) {
  const auto vertices = asset.vertices();

  gl.GenVertexArrays(1, &vertex_array_);
  gl.GenBuffers(1, &vertex_buffer_);
  gl.GenBuffers(1, &index_buffer_);
  gl.BindVertexArray(vertex_array_);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer_);
  gl.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(vertices.size_bytes() + asset.skin().size_bytes()), nullptr,
                GL_STATIC_DRAW);
  gl.BufferSubData(GL_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(vertices.size_bytes()), vertices.data());
  gl.BufferSubData(GL_ARRAY_BUFFER, static_cast<GLintptr>(vertices.size_bytes()),
                   static_cast<GLsizeiptr>(asset.skin().size_bytes()), asset.skin().data());
  describe_vertices(gl);
  if (!asset.skin().empty()) describe_skin(gl, vertices.size_bytes());
  gl.BindVertexArray(0);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

/// One draw order after the other, in 16 bits each where that is enough: with some orders, indices are most of a mesh.
bool HairModel::upload_indices(const GlFunctions& gl, const Asset& asset) {
  const std::uint64_t bytes = std::uint64_t{order_count_} * indices_of_order_ * index_bytes_;
  if (bytes > 0x7FFFFFFF) return false;
  gl.BindVertexArray(vertex_array_);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
  void* const memory = gl.MapBufferRange(GL_ELEMENT_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes),
                                         GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  if (memory != nullptr) {
    write_draw_orders(asset, {static_cast<std::byte*>(memory), static_cast<std::size_t>(bytes)});
    gl.UnmapBuffer(GL_ELEMENT_ARRAY_BUFFER);
  }
  gl.BindVertexArray(0);
  return memory != nullptr;
}

void HairModel::destroy() {
  if (renderer_ == nullptr) return;
  release(renderer_->functions());
  *this = HairModel();
}

void HairModel::release(const GlFunctions& gl) {
  gl.DeleteVertexArrays(1, &vertex_array_);
  gl.DeleteBuffers(1, &vertex_buffer_);
  gl.DeleteBuffers(1, &index_buffer_);
  gl.DeleteTextures(1, &base_texture_);
  gl.DeleteTextures(1, &shift_mask_texture_);
  gl.DeleteTextures(1, &palette_texture_);
  vertex_array_ = vertex_buffer_ = index_buffer_ = base_texture_ = shift_mask_texture_ = palette_texture_ = 0;
}

}  // namespace coif
