#pragma once

#include <coif/export.h>

namespace coif {

/// What stands in for parts of OpenGL ES 3.0 that WebGL 2 lacks: mapped buffers and fences that are waited for, and EAC
/// textures, which most browsers do not have either and are sent as GL_RG8 instead, decoded on their way. What is drawn
/// is the same, but for the last 3 of 11 bits of those texels. See RendererDesc::webgl; a program that does not name
/// kWebGl holds nothing of it.
struct WebGlCode;
extern COIF_API const WebGlCode kWebGl;

}  // namespace coif
