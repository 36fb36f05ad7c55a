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
  X(ColorMask)               \
  X(CompileShader)           \
  X(CompressedTexSubImage2D) \
  X(CreateProgram)           \
  X(CreateShader)            \
  X(CullFace)                \
  X(DeleteBuffers)           \
  X(DeleteProgram)           \
  X(DeleteShader)            \
  X(DeleteTextures)          \
  X(DeleteVertexArrays)      \
  X(DepthFunc)               \
  X(DepthMask)               \
  X(Disable)                 \
  X(DrawElementsInstanced)   \
  X(Enable)                  \
  X(EnableVertexAttribArray) \
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
  X(PixelStorei)             \
  X(ShaderSource)            \
  X(TexParameteri)           \
  X(TexStorage2D)            \
  X(TexSubImage2D)           \
  X(Uniform1i)               \
  X(Uniform3f)               \
  X(UniformBlockBinding)     \
  X(UseProgram)              \
  X(VertexAttribIPointer)    \
  X(VertexAttribPointer)

/// A list of its own, because WebGL 2 cannot map memory.
#define COIF_GL_MAPPING_FUNCTIONS(X) \
  X(ClientWaitSync)                  \
  X(DeleteSync)                      \
  X(FenceSync)                       \
  X(MapBufferRange)                  \
  X(UnmapBuffer)

/// Defines a struct of the functions in LIST, each with its exact type, and load(), which fills it. load() returns the
/// name of the first function that the host does not find, null when it finds all.
#define COIF_GL_TABLE(Table, LIST)             \
  struct Table {                               \
    LIST(COIF_GL_MEMBER)                       \
    const char* load(const GlLoader& loader) { \
      LIST(COIF_GL_LOAD)                       \
      return nullptr;                          \
    }                                          \
  }
#define COIF_GL_MEMBER(name) decltype(&gl##name) name = nullptr;
#define COIF_GL_LOAD(name)                                                           \
  name = reinterpret_cast<decltype(name)>(loader.get_proc("gl" #name, loader.user)); \
  if (name == nullptr) return "gl" #name;

namespace coif {

COIF_GL_TABLE(GlCoreFunctions, COIF_GL_FUNCTIONS);
COIF_GL_TABLE(GlMappingFunctions, COIF_GL_MAPPING_FUNCTIONS);

struct GlFunctions : GlCoreFunctions, GlMappingFunctions {
  /// Loads what is needed. Returns the name of the first function that is missing, else null.
  const char* load(const GlLoader& loader, bool maps) {
    const char* const missing = GlCoreFunctions::load(loader);
    return missing != nullptr || !maps ? missing : GlMappingFunctions::load(loader);
  }
};

COIF_API void clear_errors(const GlFunctions& gl);

}  // namespace coif
