#pragma once
// What kWebGl does in place of what WebGL 2 lacks.

#include "gl/gl_functions.h"

#include <coif/asset.h>
#include <coif/drawing.h>
#include <coif/webgl.h>

#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

/// `scratch`: what is written before it is sent, RendererDesc::scratch.
struct WebGlCode {
  /// write_draw_orders() into the bound index buffer, which has its storage.
  void (*send_indices)(const GlFunctions& gl, const Asset& asset, const DrawnHair& hair, std::span<std::byte> scratch);
  /// One mip of an EAC texture to the bound one of GL_RG8; GL_UNPACK_ALIGNMENT is 1.
  void (*send_eac)(const GlFunctions& gl, const Asset& asset, const TextureRecord& record, std::uint32_t mip,
                   std::span<std::byte> scratch);
};

/// A row of blocks of RG11 EAC, four rows of `width` texels as two bytes each, the nearest to what a sampler would
/// return. `blocks` has 16 bytes for each four texels begun; `out` 8 * width.
void decode_eac_rows(std::span<const std::byte> blocks, std::uint32_t width, std::span<std::byte> out);

}  // namespace coif
