#pragma once
// kWebGl's replacements for what WebGL 2 lacks.

#include "gl/gl_functions.h"

#include <coif/asset.h>
#include <coif/drawing.h>
#include <coif/webgl.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// `scratch` is RendererDesc::scratch, memory for data before it is sent.
struct WebGlCode {
  /// Sends write_draw_orders() to the bound index buffer, which has its storage.
  void (*send_indices)(const GlFunctions& gl, const Asset& asset, const DrawnHair& hair, std::span<std::byte> scratch);
  /// Decodes one mip of a texture of blocks and sends it to the bound one of GL_RG8 or GL_SRGB8_ALPHA8;
  /// GL_UNPACK_ALIGNMENT must be 1.
  void (*send_blocks)(const GlFunctions& gl, const Asset& asset, const TextureRecord& record, std::uint32_t mip,
                      std::span<std::byte> scratch);
};

/// Decodes a row of RG11 EAC blocks to four rows of `width` texels of two bytes each, the nearest to what a sampler
/// would return. `blocks` has 16 bytes for each four texels begun; `out` 8 * width.
void decode_eac_rows(std::span<const std::byte> blocks, std::uint32_t width, std::span<std::byte> out);

/// The same of kSrgb8Alpha8Etc2, four bytes a texel; `out` has 16 * width.
void decode_color_rows(std::span<const std::byte> blocks, std::uint32_t width, std::span<std::byte> out);

}  // namespace coif
