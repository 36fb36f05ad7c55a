#pragma once

#include "gl/gl_functions.h"

#include <cstdint>

namespace coif {

/// A texture for the matrices of as many bones, three texels each, 256 bones to a row: with one a row, the most bones would
/// exceed the height of 2048 that OpenGL ES 3.0 promises. Leaves the active unit's 2D texture empty.
[[nodiscard]] GLuint make_palette_texture(const GlFunctions& gl, std::uint32_t bones);

/// Copies matrices, which lie in `buffer` from `offset` on, and leaves the texture bound to its unit. Resets the active
/// unit, the pixel unpack buffer and GL_UNPACK state on its way.
void send_palette_texture(const GlFunctions& gl, GLuint buffer, std::uint32_t offset, GLuint texture,
                          std::uint32_t bones);

}  // namespace coif
