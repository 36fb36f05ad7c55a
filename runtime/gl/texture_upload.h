#pragma once

#include "gl/gl_functions.h"

#include <coif/asset.h>

namespace coif {

/// Sets every GL_UNPACK parameter and the pixel unpack buffer to its initial value, whatever the host left there.
void reset_unpack_state(const GlFunctions& gl);

/// Makes the asset's texture of this role with all its mips; 0 where the asset has none. Leaves the texture bound to
/// the active unit. Errors show in glGetError.
GLuint upload_texture(const GlFunctions& gl, const Asset& asset, TextureRole role);

}  // namespace coif
