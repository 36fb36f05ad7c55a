#include "view/page/view_scene.h"

#include <GLES3/gl3.h>

#include <string_view>

#define COIF_WEB_GL_FUNCTIONS(X) \
  X(ActiveTexture)               \
  X(AttachShader)                \
  X(BindBuffer)                  \
  X(BindBufferBase)              \
  X(BindBufferRange)             \
  X(BindFramebuffer)             \
  X(BindSampler)                 \
  X(BindTexture)                 \
  X(BindVertexArray)             \
  X(BlendEquation)               \
  X(BlendFunc)                   \
  X(BlendFuncSeparate)           \
  X(BufferData)                  \
  X(BufferSubData)               \
  X(CheckFramebufferStatus)      \
  X(ClearBufferfv)               \
  X(ColorMask)                   \
  X(CompileShader)               \
  X(CompressedTexSubImage2D)     \
  X(CreateProgram)               \
  X(CreateShader)                \
  X(CullFace)                    \
  X(DeleteBuffers)               \
  X(DeleteFramebuffers)          \
  X(DeleteProgram)               \
  X(DeleteShader)                \
  X(DeleteTextures)              \
  X(DeleteVertexArrays)          \
  X(DepthFunc)                   \
  X(DepthMask)                   \
  X(Disable)                     \
  X(DrawArrays)                  \
  X(DrawBuffers)                 \
  X(DrawElementsInstanced)       \
  X(Enable)                      \
  X(EnableVertexAttribArray)     \
  X(FramebufferTexture2D)        \
  X(FrontFace)                   \
  X(GenBuffers)                  \
  X(GenFramebuffers)             \
  X(GenTextures)                 \
  X(GenVertexArrays)             \
  X(GetError)                    \
  X(GetIntegerv)                 \
  X(GetProgramInfoLog)           \
  X(GetProgramiv)                \
  X(GetShaderInfoLog)            \
  X(GetShaderiv)                 \
  X(GetUniformBlockIndex)        \
  X(GetUniformLocation)          \
  X(LinkProgram)                 \
  X(PixelStorei)                 \
  X(PolygonOffset)               \
  X(ShaderSource)                \
  X(TexParameteri)               \
  X(TexStorage2D)                \
  X(TexSubImage2D)               \
  X(Uniform1i)                   \
  X(Uniform3f)                   \
  X(Uniform4f)                   \
  X(UniformBlockBinding)         \
  X(UseProgram)                  \
  X(VertexAttribIPointer)        \
  X(VertexAttribPointer)         \
  X(Viewport)

namespace coif::view {
namespace {

struct Named {
  std::string_view name;
  void* function;
};

void* find(const char* name, void*) {
#define COIF_WEB_GL_ROW(function) {"gl" #function, reinterpret_cast<void*>(gl##function)},
  static const Named kAll[] = {COIF_WEB_GL_FUNCTIONS(COIF_WEB_GL_ROW)};
#undef COIF_WEB_GL_ROW
  for (const Named& one : kAll) {
    if (one.name == name) return one.function;
  }
  return nullptr;
}

}  // namespace

GlLoader web_gl_loader() { return {find, nullptr}; }

}  // namespace coif::view
