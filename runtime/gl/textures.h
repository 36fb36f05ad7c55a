#pragma once
// Textures, and the binding points of textures and uniform blocks.

#include "gl/renderer_state.h"

#include <coif/asset.h>

#include <cstdint>

namespace coif {

// Shared by programs and draw calls. HairRenderer::draw() promises the host to leave these points empty.
inline constexpr GLuint kDrawIndex = 0;  // uniform buffer indices
inline constexpr GLuint kPaletteIndex = 1;
inline constexpr GLint kBaseUnit = 0;  // texture units
inline constexpr GLint kShiftMaskUnit = 1;
inline constexpr GLint kPaletteUnit = 2;
inline constexpr GLint kShadowUnit = 3;  // The first of HairShadow::kTextures units.
inline constexpr GLint kPeeledUnit = 7;
inline constexpr GLint kFoundUnit = 8;
inline constexpr GLint kNormalUnit = 9;
inline constexpr GLint kStrandUnit = 10;
inline constexpr GLuint kListHeadIndex = 0;  // shader storage buffer indices
inline constexpr GLuint kListNodeIndex = 1;

/// Does nothing for texture 0.
COIF_API void bind_texture(const GlFunctions& gl, GLint unit, GLuint texture);
COIF_API void unbind_texture(const GlFunctions& gl, GLint unit);

/// Sets every GL_UNPACK parameter and the pixel unpack buffer to its initial value.
void reset_unpack_state(const GlFunctions& gl);

/// Makes the asset's texture of this role with all its mips; 0 where the asset has none. Leaves the texture bound to
/// the active unit. glGetError reports failures.
GLuint upload_texture(const RendererState& renderer, const Asset& asset, TextureRole role);

/// Makes a texture without mips, for lookups without filtering. Leaves it bound to the active unit. glGetError reports
/// failures.
[[nodiscard]] COIF_API GLuint make_texture(const GlFunctions& gl, GLenum format, GLsizei width, GLsizei height);

/// A texture for the matrices of so many bones, three texels each, 256 bones per row: with one bone per row the most
/// bones would exceed the height of 2048 that OpenGL ES 3.0 promises. Each further frame begins with a row of its own.
/// Leaves the active unit's 2D texture empty.
[[nodiscard]] GLuint make_palette_texture(const GlFunctions& gl, std::uint32_t bones, std::uint32_t frames = 1);

/// Copies one frame's matrices, which lie in `buffer` from `offset` on, and leaves the texture bound to its unit.
/// Resets the active unit, the pixel unpack buffer and GL_UNPACK state.
void send_palette_texture(const GlFunctions& gl, GLuint buffer, std::uint32_t offset, GLuint texture,
                          std::uint32_t bones, std::uint32_t frame = 0);

}  // namespace coif
