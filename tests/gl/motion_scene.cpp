#include "gl/motion_scene.h"

#include <GLES3/gl3.h>

#include <algorithm>
#include <cmath>

namespace coif {

void look_from(Frame& frame, const Vec3& eye) {
  constexpr float kNear = 0.1f, kFar = 5, kNarrow = 2.5f;
  auto& m = frame.clip;
  m[0] = m[5] = kNarrow;
  m[10] = (kNear + kFar) / (kNear - kFar);
  m[11] = -1;
  m[12] = -kNarrow * eye.x;
  m[13] = -kNarrow * eye.y;
  m[14] = 2 * kNear * kFar / (kNear - kFar) - m[10] * eye.z;
  m[15] = eye.z;
  frame.eye = eye;
}

Frame frame_of(const Asset& asset, float lift, float yaw) {
  Frame frame;
  frame.palette.resize(asset.bones().size());
  for (std::size_t c = 0; c < asset.chains().size(); ++c) {
    const ChainRecord& chain = asset.chains()[c];
    const float(&root)[3] = asset.bones()[chain.first_bone].joint;
    const float angle = lift * float(1 + c % 3), s = std::sin(angle), k = std::cos(angle);
    const Mat34 turn{{{k, -s, 0, root[0] - k * root[0] + s * root[1]},
                      {s, k, 0, root[1] - s * root[0] - k * root[1]},
                      {0, 0, 1, 0}}};
    for (std::uint32_t b = 0; b < chain.bone_count; ++b) frame.palette[chain.first_bone + b] = turn;
  }
  frame.head.rotation = {0, std::sin(yaw / 2), 0, std::cos(yaw / 2)};
  look_from(frame, {0, -0.05f, 1});
  return frame;
}

MotionDesc desc_of(const Frame& now, const Frame& before) {
  MotionDesc desc;
  std::ranges::copy(now.clip, desc.clip_from_world);
  std::ranges::copy(before.clip, desc.previous_clip_from_world);
  desc.eye = now.eye;
  desc.previous_eye = before.eye;
  return desc;
}

void MotionScene::SetUp() {
  CountedGlTest::SetUp();
  if (!context_) return;
  GLuint buffers[2] = {}, framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(2, buffers);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLenum formats[2] = {GL_RG32F, GL_DEPTH_COMPONENT24};
  const GLenum attachments[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, formats[i], kSide, kSide);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffers[i]);
  }
  glViewport(0, 0, kSide, kSide);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
    GTEST_SKIP() << "the device cannot draw to two floats a pixel";
  }
}

void MotionScene::clear_vectors() {
  constexpr GLfloat kNothing[4] = {kUntouched, kUntouched, 0, 0}, kFar = 1;
  glClearBufferfv(GL_COLOR, 0, kNothing);
  glClearBufferfv(GL_DEPTH, 0, &kFar);
}

std::vector<MotionScene::Vector> MotionScene::read_vectors() {
  std::vector<std::array<float, 4>> found(kSide * kSide);
  glReadPixels(0, 0, kSide, kSide, GL_RGBA, GL_FLOAT, found.data());
  std::vector<Vector> vectors;
  for (const auto& pixel : found) vectors.push_back({pixel[0], pixel[1]});
  return vectors;
}

std::vector<MotionScene::Vector> MotionScene::vectors(const Asset& asset, const Frame& now, const Frame& before,
                                                      const MotionDesc* asked) {
  HairModel model;
  EXPECT_EQ(model.upload(renderer_, asset), Status::kOk);
  const HairInstance is{now.head, now.palette, 0}, was{before.head, before.palette, 0};
  clear_vectors();
  const MotionDesc desc = asked != nullptr ? *asked : desc_of(now, before);
  EXPECT_EQ(draw_motion_vectors(renderer_, model, {&is, 1}, {&was, 1}, desc), Status::kOk);
  model.destroy();
  return read_vectors();
}

}  // namespace coif
