#include "gl/palette_texture.h"

#include "gl/binding_points.h"
#include "gl/texture_upload.h"

#include <coif/math.h>

#include <cstddef>

namespace coif {
namespace {

constexpr GLsizei kTexelsPerBone = 3;  // the rows of its matrix
constexpr GLsizei kBonesPerRow = 256;
constexpr GLsizei kRowTexels = kBonesPerRow * kTexelsPerBone;

const void* place_in_buffer(std::size_t offset) { return reinterpret_cast<const void*>(offset); }

}  // namespace

GLuint make_palette_texture(const GlFunctions& gl, std::uint32_t bones) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // no mips, and floats are not filterable
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA32F, kRowTexels,
                  (static_cast<GLsizei>(bones) + kBonesPerRow - 1) / kBonesPerRow);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  return texture;
}

void send_palette_texture(const GlFunctions& gl, GLuint buffer, std::uint32_t offset, GLuint texture,
                          std::uint32_t bones) {
  reset_unpack_state(gl);
  gl.ActiveTexture(GL_TEXTURE0 + kPaletteUnit);
  gl.BindSampler(kPaletteUnit, 0);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  const GLsizei full_rows = static_cast<GLsizei>(bones) / kBonesPerRow;
  const GLsizei rest = static_cast<GLsizei>(bones) % kBonesPerRow;
  if (full_rows > 0) {
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kRowTexels, full_rows, GL_RGBA, GL_FLOAT, place_in_buffer(offset));
  }
  if (rest > 0) {
    const std::size_t done = std::size_t(full_rows) * kBonesPerRow * sizeof(Mat34);
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, full_rows, rest * kTexelsPerBone, 1, GL_RGBA, GL_FLOAT,
                     place_in_buffer(offset + done));
  }
  gl.BindBuffer(GL_PIXEL_UNPACK_BUFFER, 0);
}

}  // namespace coif
