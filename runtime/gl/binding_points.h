#pragma once

#include <GLES3/gl3.h>

namespace coif {

// Where programs and draw calls meet. HairRenderer::draw() promises the host to leave these points empty.
inline constexpr GLuint kDrawIndex = 0;  // uniform buffer indices
inline constexpr GLuint kPaletteIndex = 1;
inline constexpr GLint kBaseUnit = 0;  // texture units
inline constexpr GLint kShiftMaskUnit = 1;
inline constexpr GLint kPaletteUnit = 2;
inline constexpr GLint kShadowUnit = 3;  // and the next, as many as HairShadow::kTextures
inline constexpr GLint kPeeledUnit = 7;
inline constexpr GLint kFoundUnit = 8;
inline constexpr GLuint kListHeadIndex = 0;  // shader storage buffer indices
inline constexpr GLuint kListNodeIndex = 1;

}  // namespace coif
