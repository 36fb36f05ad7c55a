#include "gl/binding_points.h"
#include "gl/gl_functions.h"
#include "gl/shader_program.h"

#include <coif/renderer.h>

#include <hair_shaders.h>

#include <cstdio>
#include <new>

namespace coif {
namespace {

void bind_samplers_and_blocks(const GlFunctions& gl, GLuint program) {
  gl.UseProgram(program);  // The depth program lacks the second sampler; location -1 is ignored.
  gl.Uniform1i(gl.GetUniformLocation(program, "base_texture"), kBaseUnit);
  gl.Uniform1i(gl.GetUniformLocation(program, "shift_mask_texture"), kShiftMaskUnit);
  gl.Uniform1i(gl.GetUniformLocation(program, "palette_texture"), kPaletteUnit);
  gl.UseProgram(0);
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "DrawBlock"), kDrawIndex);
  gl.UniformBlockBinding(program, gl.GetUniformBlockIndex(program, "PaletteBlock"), kPaletteIndex);
}

}  // namespace

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
  if (const Status status = create_programs(); status != Status::kOk) return status;
  gl->GenBuffers(1, &draw_buffer_);
  gl->GenBuffers(1, &palette_buffer_);
  gl->GenTextures(1, &palette_texture_);
  created_ = true;
  return Status::kOk;
}

Status HairRenderer::create_programs() {
  const GlFunctions& gl = functions();
  const char* const vertex[] = {kShaderDrawBlockGlsl, kShaderHairVert};
  const char* const shaded[] = {kShaderDrawBlockGlsl, kShaderHairAlphaGlsl, kShaderHairShadingGlsl,
                                kShaderHairDirectionGlsl, kShaderHairFrag};
  const char* const depth[] = {kShaderDrawBlockGlsl, kShaderHairAlphaGlsl, kShaderHairDepthFrag};
  shaded_program_ = build_program(gl, vertex, shaded, failure_);
  depth_program_ = shaded_program_ == 0 ? 0 : build_program(gl, vertex, depth, failure_);
  if (depth_program_ == 0) {
    gl.DeleteProgram(shaded_program_);
    shaded_program_ = 0;
    return Status::kDriver;
  }
  bind_samplers_and_blocks(gl, shaded_program_);
  bind_samplers_and_blocks(gl, depth_program_);
  shaded_alpha_range_ = gl.GetUniformLocation(shaded_program_, "alpha_range");
  depth_alpha_range_ = gl.GetUniformLocation(depth_program_, "alpha_range");
  return Status::kOk;
}

void HairRenderer::destroy() {
  failure_[0] = '\0';
  if (!created_) return;
  const GlFunctions& gl = functions();
  gl.DeleteProgram(shaded_program_);
  gl.DeleteProgram(depth_program_);
  gl.DeleteBuffers(1, &draw_buffer_);
  gl.DeleteBuffers(1, &palette_buffer_);
  gl.DeleteTextures(1, &palette_texture_);
  shaded_program_ = depth_program_ = draw_buffer_ = palette_buffer_ = palette_texture_ = 0;
  created_ = false;
}

}  // namespace coif
