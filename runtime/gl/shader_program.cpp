#include "gl/shader_program.h"

namespace coif {
namespace {

// highp everywhere: exponents of some thousands leave nothing of a mediump highlight.
constexpr char kPrecision[] = "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n";

GLuint compile(const GlFunctions& gl, GLenum stage, const char* version, std::span<const char* const> pieces,
               std::span<char> log) {
  const GLchar* sources[2 + kMaxPieces] = {version, kPrecision};
  GLsizei count = 2;
  for (const char* piece : pieces.first(pieces.size() < kMaxPieces ? pieces.size() : kMaxPieces)) {
    sources[count++] = piece;
  }
  const GLuint shader = gl.CreateShader(stage);
  if (shader == 0) return 0;
  gl.ShaderSource(shader, count, sources, nullptr);
  gl.CompileShader(shader);
  GLint compiled = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
  if (compiled != GL_FALSE) return shader;
  gl.GetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteShader(shader);
  return 0;
}

GLuint link(const GlFunctions& gl, GLuint vertex, GLuint fragment, std::span<char> log) {
  const GLuint program = gl.CreateProgram();
  if (program == 0) return 0;
  gl.AttachShader(program, vertex);
  gl.AttachShader(program, fragment);
  gl.LinkProgram(program);
  GLint linked = GL_FALSE;
  gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
  if (linked != GL_FALSE) return program;
  gl.GetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
  gl.DeleteProgram(program);
  return 0;
}

}  // namespace

GLuint build_program(const GlFunctions& gl, const char* version, std::span<const char* const> vertex,
                     std::span<const char* const> fragment, std::span<char> log) {
  const GLuint vertex_shader = compile(gl, GL_VERTEX_SHADER, version, vertex, log);
  if (vertex_shader == 0) return 0;
  const GLuint fragment_shader = compile(gl, GL_FRAGMENT_SHADER, version, fragment, log);
  const GLuint program = fragment_shader == 0 ? 0 : link(gl, vertex_shader, fragment_shader, log);
  // Deleting marks them only; a linked program keeps what it needs.
  gl.DeleteShader(vertex_shader);
  gl.DeleteShader(fragment_shader);
  return program;
}

}  // namespace coif
