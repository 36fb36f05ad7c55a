#pragma once

#include "gl/gl_functions.h"

#include <coif/math.h>

#include <cstdint>
#include <span>

namespace coif {

/// Bones whose matrices fit into PaletteBlock of shaders/hair.vert: 12 KiB of the 16 that OpenGL ES 3.0 promises. With more
/// bones, all matrices are in the texture.
inline constexpr std::uint32_t kUniformBones = 256;

[[nodiscard]] inline bool fits_uniform_block(std::span<const Mat34> palette) { return palette.size() <= kUniformBones; }

/// Binds `buffer` as the shader's block, with the matrices where they fit. Storage comes in either case: a block without
/// it is undefined behaviour even where no shader reads it.
void send_palette_block(const GlFunctions& gl, GLuint buffer, std::span<const Mat34> palette);

/// Gives `texture` the matrices and leaves it bound to its unit. Resets the active unit and GL_UNPACK state on its way.
void send_palette_texture(const GlFunctions& gl, GLuint texture, std::span<const Mat34> palette);

}  // namespace coif
