#include "gl/gl_functions.h"
#include "gl/texture_upload.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>

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
};

// Attribute locations of shaders/hair.vert.
enum Attribute : GLuint { kPosition, kNormal, kTangent, kTexturePlace, kBones, kWeights };

const void* byte_offset(std::size_t bytes) { return reinterpret_cast<const void*>(bytes); }

void describe_vertices(const GlFunctions& gl, std::size_t skin_begin) {
  constexpr GLsizei kStride = sizeof(VertexRecord);
  gl.VertexAttribPointer(kPosition, 3, GL_FLOAT, GL_FALSE, kStride, byte_offset(offsetof(VertexRecord, position)));
  gl.VertexAttribPointer(kNormal, 3, GL_SHORT, GL_TRUE, kStride, byte_offset(offsetof(VertexRecord, normal)));
  gl.VertexAttribPointer(kTangent, 4, GL_SHORT, GL_TRUE, kStride, byte_offset(offsetof(VertexRecord, tangent)));
  gl.VertexAttribPointer(kTexturePlace, 2, GL_FLOAT, GL_FALSE, kStride, byte_offset(offsetof(VertexRecord, uv)));
  gl.VertexAttribIPointer(kBones, 4, GL_UNSIGNED_SHORT, sizeof(SkinRecord),
                          byte_offset(skin_begin + offsetof(SkinRecord, bone)));
  gl.VertexAttribPointer(kWeights, 4, GL_UNSIGNED_BYTE, GL_TRUE, sizeof(SkinRecord),
                         byte_offset(skin_begin + offsetof(SkinRecord, weight)));
  for (GLuint attribute : {kPosition, kNormal, kTangent, kTexturePlace, kBones, kWeights}) {
    gl.EnableVertexAttribArray(attribute);
  }
}

void clear_errors(const GlFunctions& gl) {
  // A lost context may report an error for ever; there are fewer kinds than this.
  for (int i = 0; i < 16 && gl.GetError() != GL_NO_ERROR; ++i) {
  }
}

}  // namespace

Status HairModel::upload(HairRenderer& renderer, const Asset& asset) {
  if (!renderer.is_created()) return Status::kNotCreated;
  if (!asset.is_open() || asset.vertices().empty() || asset.indices().empty()) return Status::kAssetLacksData;
  if (asset.indices().size() > 0x7FFFFFFF) return Status::kDriver;

  const GlFunctions& gl = renderer.functions();
  clear_errors(gl);
  HairModel fresh;
  fresh.upload_mesh(gl, asset);
  reset_unpack_state(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  fresh.base_texture_ = upload_texture(gl, asset, TextureRole::kBaseColor);
  fresh.shift_mask_texture_ = upload_texture(gl, asset, TextureRole::kShiftMask);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  if (gl.GetError() != GL_NO_ERROR) {
    fresh.release(gl);
    return Status::kDriver;
  }

  destroy();
  renderer_ = &renderer;
  vertex_array_ = fresh.vertex_array_;
  vertex_buffer_ = fresh.vertex_buffer_;
  index_buffer_ = fresh.index_buffer_;
  base_texture_ = fresh.base_texture_;
  shift_mask_texture_ = fresh.shift_mask_texture_;
  find_lods(asset);
  bone_count_ = static_cast<std::uint32_t>(asset.bones().size());
  material_ = asset.material() != nullptr ? *asset.material() : kGalleryMaterial;
  return Status::kOk;
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
  describe_vertices(gl, vertices.size_bytes());
  gl.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, index_buffer_);
  gl.BufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(asset.indices().size_bytes()), asset.indices().data(),
                GL_STATIC_DRAW);
  gl.BindVertexArray(0);
  gl.BindBuffer(GL_ARRAY_BUFFER, 0);
}

void HairModel::find_lods(const Asset& asset) {
  lod_count_ = asset.lod_count();
  for (std::uint32_t lod = 0; lod < lod_count_; ++lod) {
    const auto count = static_cast<std::uint32_t>(asset.lod_indices(lod).size());
    lods_[lod] = {asset.lod_patches(lod).front().first_index, count};
  }
}

void HairModel::destroy() {
  if (renderer_ == nullptr) return;
  release(renderer_->functions());
  renderer_ = nullptr;
  lod_count_ = 0;
  bone_count_ = 0;
  material_ = {};
}

void HairModel::release(const GlFunctions& gl) {
  gl.DeleteVertexArrays(1, &vertex_array_);
  gl.DeleteBuffers(1, &vertex_buffer_);
  gl.DeleteBuffers(1, &index_buffer_);
  gl.DeleteTextures(1, &base_texture_);
  gl.DeleteTextures(1, &shift_mask_texture_);
  vertex_array_ = vertex_buffer_ = index_buffer_ = base_texture_ = shift_mask_texture_ = 0;
}

}  // namespace coif
