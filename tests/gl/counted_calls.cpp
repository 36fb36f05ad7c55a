#include "gl/counted_calls.h"

#include <string>

namespace coif {
namespace {

CountedCalls* current = nullptr;

}  // namespace

/// What the renderer gets instead of OpenGL's functions of these names.
struct CountedCalls::Hooks {
  static void link_program(GLuint program) {
    ++current->links;
    glLinkProgram(program);
  }
  static void use_program(GLuint program) {
    current->program_ = program;
    glUseProgram(program);
  }
  static void draw_elements(GLenum mode, GLsizei count, GLenum type, const void* indices) {
    ++current->draws;
    current->drawn_with.push_back(current->program_);
    glDrawElements(mode, count, type, indices);
  }
  static void tex_storage(GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
    ++current->textures;
    glTexStorage2D(target, levels, format, width, height);
  }
  static void shader_source(GLuint shader, GLsizei count, const GLchar* const* pieces, const GLint* lengths) {
    const GLchar* const nonsense = "no shader";
    if (current->spoils_shaders_) return glShaderSource(shader, 1, &nonsense, nullptr);
    glShaderSource(shader, count, pieces, lengths);
  }

  static void* find(const char* name, void* user) {
    const std::string asked = name;
    if (asked == "glLinkProgram") return reinterpret_cast<void*>(link_program);
    if (asked == "glUseProgram") return reinterpret_cast<void*>(use_program);
    if (asked == "glDrawElements") return reinterpret_cast<void*>(draw_elements);
    if (asked == "glTexStorage2D") return reinterpret_cast<void*>(tex_storage);
    if (asked == "glShaderSource") return reinterpret_cast<void*>(shader_source);
    const GlLoader& real = static_cast<CountedCalls*>(user)->real_;
    return real.get_proc(name, real.user);
  }
};

CountedCalls::CountedCalls(const GlLoader& real) : real_(real) { current = this; }

CountedCalls::~CountedCalls() { current = nullptr; }

GlLoader CountedCalls::loader() { return {Hooks::find, this}; }

}  // namespace coif
