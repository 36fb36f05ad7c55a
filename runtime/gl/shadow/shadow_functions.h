#pragma once
// The OpenGL ES 3.0 functions that only shadows need, apart from the renderer's own, so that a game without shadows asks
// its host for none of them.

#include "gl/gl_functions.h"

#include <GLES3/gl3.h>

#define COIF_SHADOW_FUNCTIONS(X) \
  X(BindFramebuffer)             \
  X(CheckFramebufferStatus)      \
  X(ClearBufferfv)               \
  X(DeleteFramebuffers)          \
  X(DrawBuffers)                 \
  X(FramebufferTexture2D)        \
  X(GenFramebuffers)             \
  X(PolygonOffset)               \
  X(Viewport)

namespace coif {

struct ShadowFunctions {
#define COIF_GL_MEMBER(name) decltype(&gl##name) name = nullptr;
  COIF_SHADOW_FUNCTIONS(COIF_GL_MEMBER)
#undef COIF_GL_MEMBER
};

/// As load_gl_functions().
const char* load_shadow_functions(const GlLoader& loader, ShadowFunctions& functions);

}  // namespace coif
