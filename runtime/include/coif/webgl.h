#pragma once

#include <coif/export.h>

namespace coif {

/// Replaces the parts of OpenGL ES 3.0 that WebGL 2 lacks: mapped buffers, waiting for fences, and EAC textures. Most
/// browsers lack these too, so they are decoded and sent as GL_RG8. The picture is the same, except for the last 3 of
/// 11 bits of those texels. See RendererDesc::webgl. A program that does not name kWebGl does not link this code.
struct WebGlCode;
extern COIF_API const WebGlCode kWebGl;

}  // namespace coif
