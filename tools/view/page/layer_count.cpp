#include "view/page/layer_count.h"

#include "render/gl_program.h"
#include "view/page/hair_views.h"

#include <GLES3/gl3.h>

#include <cstddef>

namespace coif::view {
namespace {

constexpr char kVertex[] = R"glsl(#version 300 es
void main() {  // one triangle that covers the picture
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
})glsl";

constexpr char kFragment[] = R"glsl(#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D layers;
uniform vec3 colors[7];  // sRGB; of 1, 2, up to 4, 8, ... layers
out vec4 fragment;
vec3 linear(vec3 srgb) {
  vec3 bright = pow((srgb + 0.055) / 1.055, vec3(2.4));
  return mix(bright, srgb / 12.92, vec3(lessThanEqual(srgb, vec3(0.04045))));
}
void main() {
  int count = int(round(255.0 * texelFetch(layers, ivec2(gl_FragCoord.xy), 0).r));
  if (count == 0) discard;
  int doublings = 0;
  while ((1 << doublings) < count && doublings < 6) ++doublings;
  fragment = vec4(linear(colors[doublings]), 1.0);
})glsl";
static_assert(kLayerColors.size() == 7);

}  // namespace

tl::expected<std::unique_ptr<LayerCount>, ToolError> LayerCount::create() {
  const char* const fragment = kFragment;
  const auto program = render::build_gl_program(kVertex, {&fragment, 1});
  if (!program) return tl::unexpected(program.error());
  std::unique_ptr<LayerCount> count(new LayerCount);
  count->program_ = *program;
  glGenVertexArrays(1, &count->vertex_array_);
  float colors[3 * kLayerColors.size()];
  for (std::size_t i = 0; i < 3 * kLayerColors.size(); ++i) colors[i] = float(kLayerColors[i / 3][i % 3]) / 255;
  glUseProgram(*program);
  glUniform3fv(glGetUniformLocation(*program, "colors"), GLsizei(kLayerColors.size()), colors);
  glUniform1i(glGetUniformLocation(*program, "layers"), 0);
  glUseProgram(0);
  return count;
}

LayerCount::~LayerCount() {
  free_target();
  glDeleteProgram(program_);
  glDeleteVertexArrays(1, &vertex_array_);
}

void LayerCount::free_target() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &texture_);
  glDeleteRenderbuffers(1, &depth_);
  framebuffer_ = texture_ = depth_ = width_ = height_ = 0;
}

bool LayerCount::begin(std::uint32_t width, std::uint32_t height) {
  if (width != width_ || height != height_) {
    free_target();
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    glGenTextures(1, &texture_);
    glBindTexture(GL_TEXTURE_2D, texture_);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_R8, GLsizei(width), GLsizei(height));
    glBindTexture(GL_TEXTURE_2D, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
    glGenRenderbuffers(1, &depth_);
    glBindRenderbuffer(GL_RENDERBUFFER, depth_);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_DEPTH_COMPONENT24, GLsizei(width), GLsizei(height));
    glBindRenderbuffer(GL_RENDERBUFFER, 0);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
    width_ = width;
    height_ = height;
  }
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, GLsizei(width), GLsizei(height));
  glClearColor(0, 0, 0, 0);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  return true;
}

void LayerCount::color() const {
  glUseProgram(program_);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glBindVertexArray(vertex_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
}

}  // namespace coif::view
