#include "gl/gl_test.h"

#include "models/absent.h"

#include <GLES3/gl3.h>

#include <chrono>
#include <cstdlib>
#include <string>
#include <thread>

namespace coif {
namespace {

void bind_target(GLsizei size) {
  GLuint framebuffer = 0;
  GLuint buffers[2] = {};
  glGenFramebuffers(1, &framebuffer);
  glGenRenderbuffers(2, buffers);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  const GLenum formats[2] = {GL_RGBA8, GL_DEPTH_COMPONENT24};
  const GLenum attachments[2] = {GL_COLOR_ATTACHMENT0, GL_DEPTH_ATTACHMENT};
  for (int i = 0; i < 2; ++i) {
    glBindRenderbuffer(GL_RENDERBUFFER, buffers[i]);
    glRenderbufferStorage(GL_RENDERBUFFER, formats[i], size, size);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachments[i], GL_RENDERBUFFER, buffers[i]);
  }
  glViewport(0, 0, size, size);
}

}  // namespace

Status draw_head(HairRenderer& renderer, const HairModel& model, const HeadDraw& desc) {
  const HairInstance instance{desc.head, desc.palette, desc.lod};
  return renderer.draw(model, {&instance, 1}, desc);
}

void GlTest::SetUp() {
  auto context = render::EglContext::create();
  if (!context) COIF_FAIL_FOR_LACK_OF(context.error().message);
  context_.emplace(std::move(*context));
  ASSERT_EQ(renderer_.create(context_->loader(), kSmallBlocks), Status::kOk) << renderer_.failure();
  bind_target(kSize);
  clear();
}

void GlTest::TearDown() {
  if (!context_) return;
  EXPECT_EQ(glGetError(), GLenum{GL_NO_ERROR});
  renderer_.destroy();
}

void GlTest::clear(const Pixel& color) {
  glClearColor(float(color[0]) / 255, float(color[1]) / 255, float(color[2]) / 255, float(color[3]) / 255);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

Pixel GlTest::pixel(int x, int y) {
  std::uint8_t rgba[4] = {};
  glReadPixels(x, y, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
  return {rgba[0], rgba[1], rgba[2], rgba[3]};
}

HeadDraw GlTest::at_rest(std::uint32_t bones) {
  static const std::array<Mat34, kMaxBones> kRest{};
  HeadDraw desc;
  desc.clip_from_world[0] = desc.clip_from_world[5] = desc.clip_from_world[15] = 1;
  desc.clip_from_world[10] = -0.1f;
  desc.eye = {0, 0, 3};
  desc.palette = std::span(kRest).first(bones);
  return desc;
}

void GlTest::draw(const AssetContents& contents, const HeadDraw& desc) {
  const DrawnAsset asset(contents);
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *asset), Status::kOk);
  ASSERT_EQ(draw_head(renderer_, model, desc), Status::kOk);
  model.destroy();
}

testing::AssertionResult near(const Pixel& found, const Pixel& expected, int tolerance) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (std::abs(found[i] - expected[i]) > tolerance) {
      return testing::AssertionFailure() << testing::PrintToString(found) << " instead of "
                                         << testing::PrintToString(expected);
    }
  }
  return testing::AssertionSuccess();
}

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
    std::this_thread::sleep_for(std::chrono::duration<double>(current->draw_seconds));
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
