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
  static void draw_instances(GLenum mode, GLsizei count, GLenum type, const void* indices, GLsizei instances) {
    ++current->draws;
    current->instances += instances;
    current->drawn_with.push_back(current->program_);
    glDrawElementsInstanced(mode, count, type, indices, instances);
  }
  static void buffer_data(GLenum target, GLsizeiptr bytes, const void* data, GLenum usage) {
    ++current->storage;
    glBufferData(target, bytes, data, usage);
  }
  static void gen_buffers(GLsizei count, GLuint* names) {
    ++current->objects;
    glGenBuffers(count, names);
  }
  static void gen_textures(GLsizei count, GLuint* names) {
    ++current->objects;
    glGenTextures(count, names);
  }
  static void tex_storage(GLenum target, GLsizei levels, GLenum format, GLsizei width, GLsizei height) {
    ++current->textures;
    ++current->storage;
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
    if (asked == "glDrawElementsInstanced") return reinterpret_cast<void*>(draw_instances);
    if (asked == "glTexStorage2D") return reinterpret_cast<void*>(tex_storage);
    if (asked == "glBufferData") return reinterpret_cast<void*>(buffer_data);
    if (asked == "glGenBuffers") return reinterpret_cast<void*>(gen_buffers);
    if (asked == "glGenTextures") return reinterpret_cast<void*>(gen_textures);
    if (asked == "glShaderSource") return reinterpret_cast<void*>(shader_source);
    const GlLoader& real = static_cast<CountedCalls*>(user)->real_;
    return real.get_proc(name, real.user);
  }
};

CountedCalls::CountedCalls(const GlLoader& real) : real_(real) { current = this; }

CountedCalls::~CountedCalls() { current = nullptr; }

GlLoader CountedCalls::loader() { return {Hooks::find, this}; }

}  // namespace coif
