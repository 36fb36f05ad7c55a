#include "gl/renderer_state.h"
#include "gl/shader_programs.h"
#include "gl/textures.h"
#include "gl/webgl_code.h"

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <new>

namespace coif {
namespace {

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

/// The variant bits that programs need for this asset, whatever its material.
std::uint32_t needs_of(const Asset& asset, const DrawnHair& hair, const MatrixLayout& layout) {
  constexpr std::uint32_t kBones[] = {0, variant::kOneBone, variant::kFourBones};  // In the order of Skinning.
  return kBones[static_cast<std::size_t>(hair.skinning)] | (layout.bones_in_texture ? variant::kBonesInTexture : 0) |
         (asset.texture(TextureRole::kBaseColor) != nullptr ? variant::kBaseTexture : 0) |
         (asset.texture(TextureRole::kShiftMask) != nullptr ? variant::kShiftMask : 0) |
         (asset.texture(TextureRole::kNormal) != nullptr ? variant::kNormalMap : 0) |
         (asset.texture(TextureRole::kStrandAxis) != nullptr ? variant::kStrandMap : 0);
}

}  // namespace

Status HairModel::upload(HairRenderer& hair_renderer, const Asset& asset, const TransparencyMode& transparency) {
  static_assert(sizeof(ModelState) <= kStateBytes && alignof(ModelState) <= alignof(void*));
  if (!hair_renderer.is_created()) return Status::kNotCreated;
  if (!asset.is_open() || asset.vertices().empty() || asset.indices().empty()) return Status::kAssetLacksData;
  if (asset.indices().size() > 0x7FFFFFFF) return Status::kDriver;

  RendererState& renderer = *RendererState::of(hair_renderer);
  const GlFunctions& gl = renderer.gl;
  ModelState fresh;
  fresh.renderer = &renderer;
  fresh.hair = drawn_hair_of(asset);
  fresh.layout = matrix_layout_of(fresh.hair, renderer.block_bytes);
  fresh.needs = needs_of(asset, fresh.hair, fresh.layout);
  const MaterialRecord& material = fresh.hair.material;
  const PassList passes = transparency.plan_passes(material, fresh.hair.alpha);
  const Status built = renderer.build_missing(passes, fresh.needs, material, Component::kAll);
  if (built != Status::kOk) return built;
  clear_errors(gl);
  fresh.upload_mesh(gl, asset);
  const bool has_indices = fresh.upload_indices(gl, asset);
  reset_unpack_state(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  fresh.base_texture = upload_texture(renderer, asset, TextureRole::kBaseColor);
  fresh.shift_mask_texture = upload_texture(renderer, asset, TextureRole::kShiftMask);
  fresh.normal_texture = upload_texture(renderer, asset, TextureRole::kNormal);
  fresh.strand_texture = upload_texture(renderer, asset, TextureRole::kStrandAxis);
  if (fresh.layout.bones_in_texture) fresh.palette_texture = make_palette_texture(gl, fresh.hair.bone_count);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  if (!has_indices || gl.GetError() != GL_NO_ERROR) {
    fresh.release(gl);
    std::snprintf(renderer.failure, sizeof renderer.failure, "out of memory, or a texture is too large");
    return Status::kDriver;
  }
  destroy();
  state_ = new (static_cast<void*>(room_)) ModelState(fresh);
  return Status::kOk;
}

void HairModel::destroy() {
  if (state_ == nullptr) return;
  state_->release(state_->renderer->gl);
  state_ = nullptr;
}

std::uint32_t HairModel::bone_count() const { return state_ == nullptr ? 0 : state_->hair.bone_count; }

std::uint32_t HairModel::lod_count() const { return state_ == nullptr ? 0 : state_->hair.lod_count; }

const MaterialRecord& HairModel::material() const {
  static constexpr MaterialRecord kNothing{};
  return state_ == nullptr ? kNothing : state_->hair.material;
}

void ModelState::upload_mesh(const GlFunctions& gl, const Asset& asset) {
  const auto vertices = asset.vertices();

  gl.GenVertexArrays(1, &vertex_array);
  gl.GenBuffers(1, &vertex_buffer);
  gl.GenBuffers(1, &index_buffer);
  gl.BindVertexArray(vertex_array);
  gl.BindBuffer(GL_ARRAY_BUFFER, vertex_buffer);
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

bool ModelState::upload_indices(const GlFunctions& gl, const Asset& asset) {
  const std::uint64_t bytes = std::uint64_t{hair.order_count} * hair.indices_of_order * hair.index_bytes;
  if (bytes > 0x7FFFFFFF) return false;
  gl.BindVertexArray(vertex_array);
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_STATIC_DRAW);
  if (renderer->webgl != nullptr) {
    renderer->webgl->send_indices(gl, asset, hair, renderer->scratch);
    gl.BindVertexArray(0);
    return true;
  }
  void* const memory = gl.MapBufferRange(GL_ELEMENT_ARRAY_BUFFER, 0, static_cast<GLsizeiptr>(bytes),
                                         GL_MAP_WRITE_BIT | GL_MAP_INVALIDATE_BUFFER_BIT);
  if (memory != nullptr) {
    write_draw_orders(asset, hair, {static_cast<std::byte*>(memory), static_cast<std::size_t>(bytes)});
    gl.UnmapBuffer(GL_ELEMENT_ARRAY_BUFFER);
  }
  gl.BindVertexArray(0);
  return memory != nullptr;
}

void ModelState::release(const GlFunctions& gl) {
  gl.DeleteVertexArrays(1, &vertex_array);
  gl.DeleteBuffers(1, &vertex_buffer);
  gl.DeleteBuffers(1, &index_buffer);
  gl.DeleteTextures(1, &base_texture);
  gl.DeleteTextures(1, &shift_mask_texture);
  gl.DeleteTextures(1, &normal_texture);
  gl.DeleteTextures(1, &strand_texture);
  gl.DeleteTextures(1, &palette_texture);
  gl.DeleteTextures(1, &motion_texture);
}

}  // namespace coif
