#include "render/motion_colors.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace coif::render {
namespace {

constexpr float kFull = 0.01f;  ///< Parts of the picture in a frame, from which on a colour is full.
constexpr float kStanding = 0.18f;
constexpr float kNoVector = -9;  ///< No vector is so long.

}  // namespace

void motion_color(float x, float y, std::span<float, 3> rgb) {
  const float share = std::min(std::hypot(x, y) / kFull, 1.0f);
  const float turn = std::atan2(y, x) / (2 * std::numbers::pi_v<float>);  // -0.5..0.5
  for (std::size_t k = 0; k < 3; ++k) {
    // 0 at the channel's own hue, to 0.5
    const float away = std::abs(turn - float(k) / 3 - std::round(turn - float(k) / 3));
    const float full = std::clamp(2 - 6 * away, 0.0f, 1.0f);
    rgb[k] = kStanding + share * (0.8f * full - kStanding);
  }
}

tl::expected<MotionTarget, ToolError> MotionTarget::create(std::uint32_t width, std::uint32_t height) {
  MotionTarget target;
  target.width_ = width;
  target.height_ = height;
  GLuint buffers[2] = {};
  glGenFramebuffers(1, &target.framebuffer_);
  glGenRenderbuffers(2, buffers);
  glBindFramebuffer(GL_FRAMEBUFFER, target.framebuffer_);
  const GLenum formats[2] = {GL_RG16F, GL_DEPTH_COMPONENT24};
  const GLenum attachments[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, formats[i], GLsizei(width), GLsizei(height));
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffers[i]);
  }
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return target;
  return failure(ToolError::Kind::kUnsupported, "the device cannot draw to two half floats a pixel");
}

void MotionTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, GLsizei(width_), GLsizei(height_));
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDepthMask(GL_TRUE);
  constexpr GLfloat kNothing[4] = {kNoVector, kNoVector, 0, 0}, kFar = 1;
  glClearBufferfv(GL_COLOR, 0, kNothing);
  glClearBufferfv(GL_DEPTH, 0, &kFar);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LEQUAL);
}

void MotionTarget::color(std::span<float> radiance) const {
  std::vector<std::array<float, 4>> vectors(std::size_t{width_} * height_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glReadPixels(0, 0, GLsizei(width_), GLsizei(height_), GL_RGBA, GL_FLOAT, vectors.data());
  for (std::size_t y = 0; y < height_; ++y) {
    for (std::size_t x = 0; x < width_; ++x) {
      const std::array<float, 4>& vector = vectors[(height_ - 1 - y) * width_ + x];
      if (vector[0] <= 0.5f * kNoVector) continue;
      motion_color(vector[0], vector[1], radiance.subspan(4 * (y * width_ + x)).first<3>());
    }
  }
}

}  // namespace coif::render
