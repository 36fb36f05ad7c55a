#include "view/page/developed_target.h"

#include "render/gl_program.h"

#include <GLES3/gl3.h>

#include <algorithm>

namespace coif::view {
namespace {

constexpr char kVertex[] = R"glsl(#version 300 es
void main() {  // one triangle that covers the canvas
  gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);
})glsl";

// tools/render/tone_curve.cpp in the GPU's words.
constexpr char kFragment[] = R"glsl(#version 300 es
precision highp float;
precision highp int;
uniform highp sampler2D light;
uniform int finer;
out vec4 fragment;
const float kShoulder = 0.75;
vec3 with_tone(vec3 radiance) {
  float most = max(radiance.r, max(radiance.g, radiance.b));
  if (!(most > kShoulder)) return radiance;
  float room = 1.0 - kShoulder;
  return radiance * ((kShoulder + room * (1.0 - exp((kShoulder - most) / room))) / most);
}
vec3 encoded(vec3 linear) {
  vec3 dark = 12.92 * linear;
  vec3 bright = 1.055 * pow(linear, vec3(1.0 / 2.4)) - 0.055;
  return mix(bright, dark, vec3(lessThanEqual(linear, vec3(0.0031308))));
}
void main() {
  ivec2 corner = ivec2(gl_FragCoord.xy) * finer;
  vec3 sum = vec3(0.0);
  for (int y = 0; y < finer; ++y) {
    for (int x = 0; x < finer; ++x) {
      sum += with_tone(clamp(texelFetch(light, corner + ivec2(x, y), 0).rgb, 0.0, 65504.0));
    }
  }
  fragment = vec4(encoded(clamp(sum / float(finer * finer), 0.0, 1.0)), 1.0);
})glsl";

GLuint renderbuffer(GLenum format, GLsizei width, GLsizei height, GLsizei samples) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  return buffer;
}

bool is_complete() { return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE; }

}  // namespace

tl::expected<DevelopedTarget, ToolError> DevelopedTarget::create() {
  const char* const fragment = kFragment;
  const auto program = render::build_gl_program(kVertex, {&fragment, 1});
  if (!program) return tl::unexpected(program.error());
  DevelopedTarget target;
  target.program_ = *program;
  glGenVertexArrays(1, &target.vertex_array_);
  return target;
}

void DevelopedTarget::destroy() {
  free_target();
  glDeleteProgram(program_);
  glDeleteVertexArrays(1, &vertex_array_);
  *this = DevelopedTarget();
}

void DevelopedTarget::free_target() {
  glDeleteFramebuffers(1, &drawn_);
  if (resolved_ != drawn_) glDeleteFramebuffers(1, &resolved_);
  glDeleteTextures(1, &texture_);
  glDeleteRenderbuffers(1, &color_);
  glDeleteRenderbuffers(1, &depth_);
  drawn_ = resolved_ = texture_ = color_ = depth_ = 0;
  size_ = {};
}

bool DevelopedTarget::resize(std::uint32_t width, std::uint32_t height, std::uint32_t finer, std::uint32_t covered) {
  const Size wanted{width, height, finer, covered};
  if (size_ == wanted) return true;
  free_target();
  size_ = wanted;
  if (make(GL_RGBA16F)) return true;
  free_target();
  size_ = wanted;
  if (make(GL_SRGB8_ALPHA8)) return true;
  free_target();
  return false;
}

bool DevelopedTarget::make(std::uint32_t color_format) {
  const auto columns = GLsizei(width()), rows = GLsizei(height());
  GLint most = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &most);
  const auto samples = GLsizei(std::min(GLint(size_.covered), most));
  glGenTextures(1, &texture_);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexStorage2D(GL_TEXTURE_2D, 1, color_format, columns, rows);
  glBindTexture(GL_TEXTURE_2D, 0);
  glGenFramebuffers(1, &resolved_);
  glBindFramebuffer(GL_FRAMEBUFFER, resolved_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  if (!is_complete()) return false;
  drawn_ = resolved_;
  if (samples > 0) {
    glGenFramebuffers(1, &drawn_);
    glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
    color_ = renderbuffer(color_format, columns, rows, samples);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, color_);
  }
  depth_ = renderbuffer(GL_DEPTH_COMPONENT24, columns, rows, samples);
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth_);
  return is_complete();
}

void DevelopedTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
  glViewport(0, 0, GLsizei(width()), GLsizei(height()));
}

void DevelopedTarget::develop() const {
  if (drawn_ != resolved_) {
    const auto columns = GLint(width()), rows = GLint(height());
    glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
    glBlitFramebuffer(0, 0, columns, rows, 0, 0, columns, rows, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  }
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glViewport(0, 0, GLsizei(size_.width), GLsizei(size_.height));
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDisable(GL_CULL_FACE);
  glUseProgram(program_);
  glUniform1i(glGetUniformLocation(program_, "light"), 0);
  glUniform1i(glGetUniformLocation(program_, "finer"), GLint(size_.finer));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture_);
  glBindVertexArray(vertex_array_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  glBindTexture(GL_TEXTURE_2D, 0);
  glUseProgram(0);
}

}  // namespace coif::view
