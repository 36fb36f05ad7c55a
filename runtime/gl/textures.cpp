#include "gl/textures.h"

#include "gl/webgl_code.h"

#include <coif/math.h>

#include <cstddef>
#include <span>

namespace coif {
namespace {

struct PixelLayout {
  GLenum storage;
  GLenum transfer;  // GL_NONE: compressed
};

PixelLayout layout_of(TexelFormat format, bool decodes) {
  switch (format) {
    case TexelFormat::kSrgb8Alpha8: break;
    case TexelFormat::kRg8: return {GL_RG8, GL_RG};
    case TexelFormat::kRg11Eac:
      if (decodes) return {GL_RG8, GL_RG};
      return {GL_COMPRESSED_RG11_EAC, GL_NONE};  // core in OpenGL ES 3.0
    case TexelFormat::kSrgb8Alpha8Etc2:
      if (decodes) break;
      return {GL_COMPRESSED_SRGB8_ALPHA8_ETC2_EAC, GL_NONE};  // core, too
  }
  return {GL_SRGB8_ALPHA8, GL_RGBA};
}

GLsizei mip_size(std::uint32_t size, std::uint32_t mip) {
  return static_cast<GLsizei>((size >> mip) > 0 ? size >> mip : 1);
}

/// Artists tile strand textures along long strips. Where nothing tiles, repeating would only blend the roots' row of
/// texels into the tips.
GLint wrap_of(const Asset& asset) {
  constexpr float kSlack = 1e-3f;  // Exporters round.
  for (const VertexRecord& vertex : asset.vertices()) {
    for (const float place : vertex.uv) {
      if (place < -kSlack || place > 1.0f + kSlack) return GL_REPEAT;
    }
  }
  return GL_CLAMP_TO_EDGE;
}

GLuint bind_new_texture(const GlFunctions& gl, GLint wrap) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrap);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrap);
  return texture;
}

void send_mip(const RendererState& renderer, const Asset& asset, const TextureRecord& record, std::uint32_t mip) {
  const GlFunctions& gl = renderer.gl;
  const PixelLayout layout = layout_of(record.format, false);
  if (renderer.webgl != nullptr && layout.transfer == GL_NONE) {
    renderer.webgl->send_blocks(gl, asset, record, mip, renderer.scratch);
    return;
  }
  const auto level = static_cast<GLint>(mip);
  const GLsizei width = mip_size(record.width, mip);
  const GLsizei height = mip_size(record.height, mip);
  const std::span<const std::byte> texels = asset.texels(record, mip);
  if (layout.transfer == GL_NONE) {
    gl.CompressedTexSubImage2D(GL_TEXTURE_2D, level, 0, 0, width, height, layout.storage,
                               static_cast<GLsizei>(texels.size()), texels.data());
  } else {
    gl.TexSubImage2D(GL_TEXTURE_2D, level, 0, 0, width, height, layout.transfer, GL_UNSIGNED_BYTE, texels.data());
  }
}

constexpr GLsizei kTexelsPerBone = 3;  // the rows of its matrix
constexpr GLsizei kBonesPerRow = 256;
constexpr GLsizei kRowTexels = kBonesPerRow * kTexelsPerBone;

GLsizei rows_of(std::uint32_t bones) { return (static_cast<GLsizei>(bones) + kBonesPerRow - 1) / kBonesPerRow; }

const void* place_in_buffer(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

}  // namespace

void bind_texture(const GlFunctions& gl, GLint unit, GLuint texture) {
  if (texture == 0) return;
  const auto place = static_cast<GLuint>(unit);
  gl.BindSampler(place, 0);  // A sampler of the host would override the texture's own filters.
  gl.ActiveTexture(GL_TEXTURE0 + place);
  gl.BindTexture(GL_TEXTURE_2D, texture);
}

void unbind_texture(const GlFunctions& gl, GLint unit) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(unit));
  gl.BindTexture(GL_TEXTURE_2D, 0);
}

void reset_unpack_state(const GlFunctions& gl) {
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl.PixelStorei(GL_UNPACK_ROW_LENGTH, 0);
  gl.PixelStorei(GL_UNPACK_IMAGE_HEIGHT, 0);
  gl.PixelStorei(GL_UNPACK_SKIP_ROWS, 0);
  gl.PixelStorei(GL_UNPACK_SKIP_PIXELS, 0);
  gl.PixelStorei(GL_UNPACK_SKIP_IMAGES, 0);
}

GLuint upload_texture(const RendererState& renderer, const Asset& asset, TextureRole role) {
  const GlFunctions& gl = renderer.gl;
  const TextureRecord* const record = asset.texture(role);
  if (record == nullptr) return 0;
  const GLuint texture = bind_new_texture(gl, wrap_of(asset));
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
  gl.TexStorage2D(GL_TEXTURE_2D, static_cast<GLsizei>(record->mip_count),
                  layout_of(record->format, renderer.webgl != nullptr).storage, static_cast<GLsizei>(record->width),
                  static_cast<GLsizei>(record->height));
  for (std::uint32_t mip = 0; mip < record->mip_count; ++mip) send_mip(renderer, asset, *record, mip);
  gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  return texture;
}

GLuint make_texture(const GlFunctions& gl, GLenum format, GLsizei width, GLsizei height) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // integers and floats are not filterable
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexStorage2D(GL_TEXTURE_2D, 1, format, width, height);
  return texture;
}

GLuint make_palette_texture(const GlFunctions& gl, std::uint32_t bones, std::uint32_t frames) {
  const GLuint texture = make_texture(gl, GL_RGBA32F, kRowTexels, rows_of(bones) * static_cast<GLsizei>(frames));
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

void send_palette_texture(const GlFunctions& gl, GLuint buffer, std::uint32_t offset, GLuint texture,
                          std::uint32_t bones, std::uint32_t frame) {
  reset_unpack_state(gl);
  gl.ActiveTexture(GL_TEXTURE0 + kPaletteUnit);
  gl.BindSampler(kPaletteUnit, 0);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  const GLsizei full_rows = static_cast<GLsizei>(bones) / kBonesPerRow;
  const GLsizei rest = static_cast<GLsizei>(bones) % kBonesPerRow;
  const GLint first = rows_of(bones) * static_cast<GLint>(frame);
  if (full_rows > 0) {
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, first, kRowTexels, full_rows, GL_RGBA, GL_FLOAT, place_in_buffer(offset));
  }
  if (rest > 0) {
    const std::size_t done = std::size_t(full_rows) * kBonesPerRow * sizeof(Mat34);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, first + full_rows, rest * kTexelsPerBone, 1, GL_RGBA, GL_FLOAT,
                     place_in_buffer(offset + done));
  }
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

}  // namespace coif
