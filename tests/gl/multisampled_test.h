#pragma once

#include "gl/gl_test.h"

#include <GLES3/gl3.h>

#include <cstdint>
#include <vector>

namespace coif {

/// A card of this alpha that fills the view.
inline DrawnCard whole_card(int alpha, float z = 0) {
  DrawnCard card;
  card.center[2] = z;
  card.half_size = 1;
  card.rgba = {255, 255, 255, std::uint8_t(alpha)};
  return card;
}

/// Draws into four samples per pixel.
class MultisampledTest : public GlTest {
 protected:
  static constexpr int kSamples = 4;

  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &resolved_);
    GLuint framebuffer = 0, buffers[2] = {};
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenRenderbuffers(2, buffers);
    const GLenum formats[2] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
    const GLenum attachments[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
    for (int i = 0; i < 2; ++i) {
      glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
      glRenderbufferStorageMultisample(GL_RENDERBUFFER, kSamples, formats[i], kSize, kSize);
      glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffers[i]);
    }
    drawn_ = GLint(framebuffer);
    ASSERT_EQ(glCheckFramebufferStatus(GL_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  }

  std::vector<std::uint8_t> resolve() {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(drawn_));
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(resolved_));
    glBlitFramebuffer(0, 0, kSize, kSize, 0, 0, kSize, kSize, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, GLuint(resolved_));
    const auto rgba = read_pixels(kSize);
    glBindFramebuffer(GL_FRAMEBUFFER, GLuint(drawn_));
    return rgba;
  }

  GLint resolved_ = 0;
  GLint drawn_ = 0;
};

}  // namespace coif
