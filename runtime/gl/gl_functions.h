#pragma once
// The OpenGL ES 3.0 functions this library calls. The header declares them, which gives each its exact type; none is
// ever linked.

#include <coif/renderer.h>

#include <GLES3/gl3.h>

#define COIF_GL_FUNCTIONS(X) \
  X(ActiveTexture)           \
  X(AttachShader)            \
  X(BindBuffer)              \
  X(BindBufferBase)          \
  X(BindBufferRange)         \
  X(BindSampler)             \
  X(BindTexture)             \
  X(BindVertexArray)         \
  X(BlendEquation)           \
  X(BlendFunc)               \
  X(BlendFuncSeparate)       \
  X(BufferData)              \
  X(BufferSubData)           \
  X(ClientWaitSync)          \
  X(ColorMask)               \
  X(CompileShader)           \
  X(CompressedTexSubImage2D) \
  X(CreateProgram)           \
  X(CreateShader)            \
  X(CullFace)                \
  X(DeleteBuffers)           \
  X(DeleteProgram)           \
  X(DeleteShader)            \
  X(DeleteSync)              \
  X(DeleteTextures)          \
  X(DeleteVertexArrays)      \
  X(DepthFunc)               \
  X(DepthMask)               \
  X(Disable)                 \
  X(DrawElementsInstanced)   \
  X(Enable)                  \
  X(EnableVertexAttribArray) \
  X(FenceSync)               \
  X(FrontFace)               \
  X(GenBuffers)              \
  X(GenTextures)             \
  X(GenVertexArrays)         \
  X(GetError)                \
  X(GetIntegerv)             \
  X(GetProgramInfoLog)       \
  X(GetProgramiv)            \
  X(GetShaderInfoLog)        \
  X(GetShaderiv)             \
  X(GetUniformBlockIndex)    \
  X(GetUniformLocation)      \
  X(LinkProgram)             \
  X(MapBufferRange)          \
  X(PixelStorei)             \
  X(ShaderSource)            \
  X(TexParameteri)           \
  X(TexStorage2D)            \
  X(TexSubImage2D)           \
  X(Uniform1i)               \
  X(Uniform3f)               \
  X(UniformBlockBinding)     \
  X(UnmapBuffer)             \
  X(UseProgram)              \
  X(VertexAttribIPointer)    \
  X(VertexAttribPointer)

namespace coif {

struct GlFunctions {
#define COIF_GL_MEMBER(name) decltype(&gl##name) name = nullptr;
  COIF_GL_FUNCTIONS(COIF_GL_MEMBER)
#undef COIF_GL_MEMBER
};

/// Fills `functions`. Returns the name of the first function that the host does not find, null when all are there.
const char* load_gl_functions(const GlLoader& loader, GlFunctions& functions);

void clear_errors(const GlFunctions& gl);

}  // namespace coif
