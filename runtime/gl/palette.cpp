#include "gl/palette.h"

#include "gl/binding_points.h"
#include "gl/texture_upload.h"

namespace coif {
namespace {

// The block's whole size: storage for less is undefined behaviour even where no shader reads the rest.
constexpr GLsizeiptr kBlockBytes = kUniformBones * sizeof(Mat34);
constexpr GLsizei kTexelsPerBone = 3;  // the rows of its matrix
// A row of texels holds this many bones: with one a row, the most bones would exceed the texture height of 2048 that
// OpenGL ES 3.0 promises.
constexpr GLsizei kBonesPerRow = 256;
constexpr GLsizei kRowTexels = kBonesPerRow * kTexelsPerBone;

}  // namespace

void send_palette_block(const GlFunctions& gl, GLuint buffer, std::span<const Mat34> palette) {
  // Data afresh for each head: the driver gives new storage while the GPU still reads the head before.
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kPaletteIndex, buffer);
  gl.BufferData(GL_UNIFORM_BUFFER, kBlockBytes, nullptr, GL_STREAM_DRAW);
  gl.BufferSubData(GL_UNIFORM_BUFFER, 0, static_cast<GLsizeiptr>(palette.size_bytes()), palette.data());
}

void send_palette_texture(const GlFunctions& gl, GLuint texture, std::span<const Mat34> palette) {
  reset_unpack_state(gl);
  gl.ActiveTexture(GL_TEXTURE0 + kPaletteUnit);
  gl.BindSampler(kPaletteUnit, 0);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);  // no mips, and floats are not filterable
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  const auto bones = static_cast<GLsizei>(palette.size());
  const GLsizei full_rows = bones / kBonesPerRow;
  const GLsizei rest = bones % kBonesPerRow;
  // Afresh, for the same reason as the block.
  gl.TexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, kRowTexels, full_rows + (rest > 0 ? 1 : 0), 0, GL_RGBA, GL_FLOAT,
                nullptr);
  gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, kRowTexels, full_rows, GL_RGBA, GL_FLOAT, palette.data());
  if (rest > 0) {
    gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, full_rows, rest * kTexelsPerBone, 1, GL_RGBA, GL_FLOAT,
                     palette.data() + full_rows * kBonesPerRow);
  }
}

}  // namespace coif
