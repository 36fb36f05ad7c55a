#pragma once

#include "gl/gl_functions.h"

#include <coif/math.h>

#include <cstdint>
#include <span>

namespace coif {

/// Bones whose matrices fit into PaletteBlock of shaders/hair.vert: 12 KiB of the 16 that OpenGL ES 3.0 promises. With
/// more bones, all matrices are in the texture.
inline constexpr std::uint32_t kUniformBones = 256;

/// Binds `buffer` as the shader's block, with the matrices, at most kUniformBones.
void send_palette_block(const GlFunctions& gl, GLuint buffer, std::span<const Mat34> palette);

/// Gives `texture` the matrices and leaves it bound to its unit. Resets the active unit and GL_UNPACK state on its way.
void send_palette_texture(const GlFunctions& gl, GLuint texture, std::span<const Mat34> palette);

}  // namespace coif
