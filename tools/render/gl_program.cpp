#include "render/gl_program.h"

#include <GLES3/gl3.h>

#include <string>

namespace coif::render {
namespace {

GLuint compile_shader(GLenum stage, std::span<const char* const> source, std::string& log) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, GLsizei(source.size()), source.data(), nullptr);
  glCompileShader(shader);
  GLchar text[512] = {};
  glGetShaderInfoLog(shader, sizeof text, nullptr, text);
  log += text;
  return shader;
}

}  // namespace

tl::expected<std::uint32_t, ToolError> build_gl_program(const char* vertex_source,
                                                        std::span<const char* const> fragment_source) {
  std::string log;
  const GLuint program = glCreateProgram();
  const GLuint vertex = compile_shader(GL_VERTEX_SHADER, {&vertex_source, 1}, log);
  const GLuint fragment = compile_shader(GL_FRAGMENT_SHADER, fragment_source, log);
  glAttachShader(program, vertex);
  glAttachShader(program, fragment);
  glLinkProgram(program);
  glDeleteShader(vertex);
  glDeleteShader(fragment);
  GLint linked = GL_FALSE;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return program;
  return failure(ToolError::Kind::kUnsupported, "the driver refuses the shaders of a picture: " + log);
}

}  // namespace coif::render
