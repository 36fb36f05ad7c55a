#include "report/shadow/measure_shadows.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace coif::report {
namespace {

constexpr GLsizei kColumns = 512;  // points in a row of the picture that they are written to
constexpr GLsizei kBlock = 2;      // Pixels of a point in each direction; a device takes differences over them.

// Each point is a little piece of its surface, so that the shader finds the slope as in a picture.
constexpr char kVertex[] = R"glsl(#version 300 es
uniform vec2 blocks;
layout(location = 0) in vec3 point;
layout(location = 1) in vec3 normal;
flat out vec3 middle;
flat out vec3 right;
flat out vec3 up;
void main() {
  const float kPixel = 1e-4;  // metres
  middle = point;
  vec3 aside = abs(normal.x) < 0.7 * length(normal) ? vec3(1.0, 0.0, 0.0) : vec3(0.0, 1.0, 0.0);
  right = cross(aside, normal);
  up = cross(normal, right);
  if (dot(normal, normal) > 0.0) {
    right *= 2.0 * kPixel / length(right);
    up *= 2.0 * kPixel / length(up);
  }
  vec2 block = vec2(gl_VertexID % int(blocks.x), gl_VertexID / int(blocks.x));
  gl_Position = vec4((block + 0.5) / blocks * 2.0 - 1.0, 0.0, 1.0);
  gl_PointSize = 2.0;
})glsl";

constexpr char kPreamble[] = "#version 300 es\nprecision highp float;\nprecision highp int;\n";

// Writes two bytes. A point without a normal has no slope: its neighbours are itself.
constexpr char kFragment[] = R"glsl(
uniform mat4 map_from_world;
uniform vec4 shadow_depth;
uniform vec4 shadow_map;
flat in vec3 middle;
flat in vec3 right;
flat in vec3 up;
out vec4 fragment;
void main() {
  vec2 aside = gl_PointCoord - 0.5;
  vec4 near = map_from_world * vec4(middle + aside.x * right + aside.y * up, 1.0);
  vec2 slope = hair_slope(near);
  float light = hair_light(map_from_world * vec4(middle, 1.0), slope, shadow_depth, shadow_map);
  float steps = floor(clamp(light, 0.0, 1.0) * 65535.0 + 0.5);
  fragment = vec4(floor(steps / 256.0), mod(steps, 256.0), 0.0, 255.0) / 255.0;
})glsl";

void attach(GLuint program, GLenum stage, std::span<const char* const> source) {
  const GLuint shader = glCreateShader(stage);
  glShaderSource(shader, GLsizei(source.size()), source.data(), nullptr);
  glCompileShader(shader);
  glAttachShader(program, shader);
  glDeleteShader(shader);
}

/// A picture to draw into, bound while this object lives.
class PointTarget {
 public:
  explicit PointTarget(GLsizei rows) {
    glGenFramebuffers(1, &framebuffer_);
    glGenRenderbuffers(1, &pixels_);
    glBindRenderbuffer(GL_RENDERBUFFER, pixels_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, kBlock * kColumns, kBlock * rows);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, pixels_);
    glViewport(0, 0, kBlock * kColumns, kBlock * rows);
  }
  PointTarget(const PointTarget&) = delete;
  PointTarget& operator=(const PointTarget&) = delete;
  ~PointTarget() {
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer_);
    glDeleteRenderbuffers(1, &pixels_);
  }

 private:
  GLuint framebuffer_ = 0, pixels_ = 0;
};

void draw_points(std::span<const ShadowPoint> points) {
  GLuint array = 0, buffer = 0;
  glGenVertexArrays(1, &array);
  glGenBuffers(1, &buffer);
  glBindVertexArray(array);
  glBindBuffer(GL_ARRAY_BUFFER, buffer);
  glBufferData(GL_ARRAY_BUFFER, GLsizeiptr(points.size_bytes()), points.data(), GL_STREAM_DRAW);
  static_assert(offsetof(ShadowPoint, place) == 0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ShadowPoint), nullptr);
  glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, sizeof(ShadowPoint),
                        reinterpret_cast<const void*>(offsetof(ShadowPoint, normal)));
  glEnableVertexAttribArray(0);
  glEnableVertexAttribArray(1);
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_DITHER);
  glDrawArrays(GL_POINTS, 0, GLsizei(points.size()));
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  glDeleteVertexArrays(1, &array);
  glDeleteBuffers(1, &buffer);
}

}  // namespace

tl::expected<ShadowProbe, ToolError> ShadowProbe::create(const HairShadow& shadow) {
  ShadowProbe probe(shadow);
  probe.program_ = glCreateProgram();
  const std::array<const char*, 1> vertex{kVertex};
  attach(probe.program_, GL_VERTEX_SHADER, vertex);
  const std::array<const char*, 4> fragment{kPreamble, shadow.code()[0], shadow.code()[1], kFragment};
  attach(probe.program_, GL_FRAGMENT_SHADER, fragment);
  glLinkProgram(probe.program_);
  GLint linked = GL_FALSE;
  glGetProgramiv(probe.program_, GL_LINK_STATUS, &linked);
  if (linked == GL_TRUE) return probe;
  GLchar log[512] = {};
  glGetProgramInfoLog(probe.program_, sizeof log, nullptr, log);
  return tl::unexpected(
      ToolError{ToolError::Kind::kUnsupported, std::string("the driver refuses the shadow's code: ") + log});
}

std::vector<float> ShadowProbe::light_at(std::span<const ShadowPoint> points) const {
  const auto rows = GLsizei((points.size() + kColumns - 1) / kColumns);
  if (rows == 0) return {};
  const PointTarget target(rows);
  const ShadowUniforms uniforms = shadow_->uniforms({});
  glUseProgram(program_);
  glUniform2f(glGetUniformLocation(program_, "blocks"), float(kColumns), float(rows));
  glUniformMatrix4fv(glGetUniformLocation(program_, "map_from_world"), 1, GL_FALSE, uniforms.map_from_origin);
  glUniform4fv(glGetUniformLocation(program_, "shadow_depth"), 1, uniforms.depth);
  glUniform4fv(glGetUniformLocation(program_, "shadow_map"), 1, uniforms.map);
  for (GLuint i = 0; i < HairShadow::kTextures; ++i) {
    if (shadow_->sampler(i) == nullptr) continue;
    glActiveTexture(GL_TEXTURE0 + i);
    glBindTexture(GL_TEXTURE_2D, shadow_->texture(i));
    glUniform1i(glGetUniformLocation(program_, shadow_->sampler(i)), GLint(i));
  }
  glActiveTexture(GL_TEXTURE0);
  draw_points(points);
  std::vector<std::uint8_t> pixels(std::size_t{4} * kBlock * kBlock * kColumns * std::size_t(rows));
  glReadPixels(0, 0, kBlock * kColumns, kBlock * rows, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  std::vector<float> light;
  light.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::size_t row = kBlock * (i / kColumns), column = kBlock * (i % kColumns);
    const std::uint8_t* pixel = &pixels[4 * (row * kBlock * kColumns + column)];
    light.push_back(float(pixel[0] * 256 + pixel[1]) / 65535);
  }
  return light;
}

}  // namespace coif::report
