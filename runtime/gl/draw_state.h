#pragma once

#include "gl/gl_functions.h"
#include "gl/passes.h"

namespace coif {

/// What passes share: premultiplied blending, depth test, winding.
void set_draw_state(const GlFunctions& gl);

/// What this pass wants beside.
void set_pass_state(const GlFunctions& gl, const Pass& pass);

/// Everything that the two above set, at OpenGL's initial values.
void leave_draw_state(const GlFunctions& gl);

/// 0: nothing happens.
void bind_texture(const GlFunctions& gl, GLint unit, GLuint texture);
void unbind_texture(const GlFunctions& gl, GLint unit);

}  // namespace coif
