#include "render/offscreen_target.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <string>

namespace coif {
namespace {

void attach(GLenum attachment, GLenum format, std::uint32_t width, std::uint32_t height, GLsizei samples) {
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, static_cast<GLsizei>(width),
                                   static_cast<GLsizei>(height));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
}

}  // namespace

tl::expected<OffscreenTarget, ToolError> OffscreenTarget::create(std::uint32_t width, std::uint32_t height,
                                                                 std::uint32_t samples) {
  GLint max_samples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
  const GLsizei used_samples = std::min(static_cast<GLsizei>(samples), static_cast<GLsizei>(max_samples));

  OffscreenTarget target;
  target.width_ = width;
  target.height_ = height;
  glGenFramebuffers(1, &target.resolved_);
  glBindFramebuffer(GL_FRAMEBUFFER, target.resolved_);
  attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, width, height, 0);
  const bool readable = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glGenFramebuffers(1, &target.drawn_);
  glBindFramebuffer(GL_FRAMEBUFFER, target.drawn_);
  attach(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8, width, height, used_samples);
  attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height, used_samples);
  if (!readable || glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    return tl::unexpected(ToolError{ToolError::Kind::kUnsupported,
                                    "the driver has no framebuffer of " + std::to_string(width) + " x " +
                                        std::to_string(height) + " pixels; ask for a smaller picture"});
  }
  return target;
}

void OffscreenTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
  glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
}

std::vector<std::uint8_t> OffscreenTarget::read() const {
  const GLint width = static_cast<GLint>(width_);
  const GLint height = static_cast<GLint>(height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
  std::vector<std::uint8_t> pixels(std::size_t{4} * width_ * height_);
  glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);

  // OpenGL's first row is the lowest, a picture's the highest.
  const std::size_t row = std::size_t{4} * width_;
  for (std::size_t low = 0, high = height_ - 1; low < high; ++low, --high) {
    std::swap_ranges(pixels.begin() + static_cast<std::ptrdiff_t>(low * row),
                     pixels.begin() + static_cast<std::ptrdiff_t>((low + 1) * row),
                     pixels.begin() + static_cast<std::ptrdiff_t>(high * row));
  }
  return pixels;
}

}  // namespace coif
