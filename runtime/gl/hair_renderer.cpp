#include "gl/gl_functions.h"

#include <coif/renderer.h>

#include <cstdio>
#include <new>

namespace coif {
const GlFunctions& HairRenderer::functions() const {
  static_assert(sizeof(GlFunctions) <= kFunctionBytes);
  return *std::launder(reinterpret_cast<const GlFunctions*>(functions_));
}

Status HairRenderer::create(const GlLoader& loader) {
  if (loader.get_proc == nullptr) return Status::kBadArgument;
  destroy();
  GlFunctions* gl = new (static_cast<void*>(functions_)) GlFunctions;
  if (const char* missing = load_gl_functions(loader, *gl)) {
    std::snprintf(failure_, sizeof failure_, "%s is missing; OpenGL ES 3.0 is needed", missing);
    return Status::kDriver;
  }
  // Loaders such as glvnd's return a stub for any name, so finding the functions proves little.
  GLint major = 0;
  gl->GetIntegerv(GL_MAJOR_VERSION, &major);
  if (major < 3) {
    std::snprintf(failure_, sizeof failure_, "the current context has version %d; OpenGL ES 3.0 is needed", major);
    return Status::kDriver;
  }
  gl->GenBuffers(1, &draw_buffer_);
  gl->GenBuffers(1, &palette_buffer_);
  gl->GenTextures(1, &palette_texture_);
  created_ = true;
  return Status::kOk;
}

void HairRenderer::destroy() {
  failure_[0] = '\0';
  if (!created_) return;
  const GlFunctions& gl = functions();
  for (const Program& program : std::span(programs_).first(program_count_)) gl.DeleteProgram(program.name);
  program_count_ = 0;
  gl.DeleteBuffers(1, &draw_buffer_);
  gl.DeleteBuffers(1, &palette_buffer_);
  gl.DeleteTextures(1, &palette_texture_);
  draw_buffer_ = palette_buffer_ = palette_texture_ = 0;
  created_ = false;
}

}  // namespace coif
