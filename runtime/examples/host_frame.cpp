#include "host_frame.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace host {
namespace {

void* find_function(const char* name, void*) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

constexpr char kVertexCode[] = R"(#version 300 es
uniform mat4 clip_from_world;
uniform vec4 sides;  // left, bottom, right, top
uniform float z;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = clip_from_world * vec4(mix(sides.xy, sides.zw, corner), z, 1.0);
}
)";

constexpr char kFragmentCode[] = R"(#version 300 es
precision mediump float;
uniform vec4 color;
out vec4 result;
void main() { result = color; }
)";

GLuint compile(GLenum kind, const char* code) {
  const GLuint shader = glCreateShader(kind);
  glShaderSource(shader, 1, &code, nullptr);
  glCompileShader(shader);
  return shader;
}

GLuint link_program() {
  const GLuint program = glCreateProgram();
  glAttachShader(program, compile(GL_VERTEX_SHADER, kVertexCode));
  glAttachShader(program, compile(GL_FRAGMENT_SHADER, kFragmentCode));
  glLinkProgram(program);
  GLint linked = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &linked);
  return linked == GL_TRUE ? program : 0;
}

void attach_texture(GLenum attachment, GLenum format) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexStorage2D(GL_TEXTURE_2D, 1, format, kSize, kSize);
  glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture, 0);
  glBindTexture(GL_TEXTURE_2D, 0);
}

}  // namespace

bool Context::open() {
  display_ = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) return false;
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (eglBindAPI(EGL_OPENGL_ES_API) == EGL_FALSE) return false;
  if (eglChooseConfig(display_, wanted, &config, 1, &found) == EGL_FALSE || found == 0) return false;
  context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, version);
  return context_ != EGL_NO_CONTEXT && eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_TRUE;
}

Context::~Context() {
  if (display_ == nullptr) return;
  eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (context_ != nullptr) eglDestroyContext(display_, context_);
  eglTerminate(display_);
}

coif::GlLoader Context::loader() { return {find_function, nullptr}; }

std::array<float, 16> Camera::clip_from_world() const {
  constexpr float kNear = 0.1f, kFar = 10.0f;
  constexpr float kFocus = 2.0f;  // a square field of view of 53 degrees
  constexpr float kScale = (kNear + kFar) / (kNear - kFar), kOffset = 2 * kNear * kFar / (kNear - kFar);
  return {kFocus,
          0,
          0,
          0,  //
          0,
          kFocus,
          0,
          0,  //
          0,
          0,
          kScale,
          -1,  //
          -kFocus * eye[0],
          -kFocus * eye[1],
          kOffset - kScale * eye[2],
          eye[2]};
}

bool Frame::create() {
  program_ = link_program();
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  attach_texture(GL_COLOR_ATTACHMENT0, GL_SRGB8_ALPHA8);
  attach_texture(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24);
  return program_ != 0 && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

void Frame::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, kSize, kSize);
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, kSize, kSize);
  glDepthMask(GL_TRUE);
  glClearColor(0.2f, 0.3f, 0.5f, 1.0f);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void Frame::draw(const Camera& camera, const Rectangle& rectangle) const {
  const bool is_solid = rectangle.color[3] >= 1.0f;
  const auto place = [this](const char* name) { return glGetUniformLocation(program_, name); };
  glUseProgram(program_);
  glUniformMatrix4fv(place("clip_from_world"), 1, GL_FALSE, camera.clip_from_world().data());
  glUniform4f(place("sides"), rectangle.left, rectangle.bottom, rectangle.right, rectangle.top);
  glUniform1f(place("z"), rectangle.z);
  glUniform4fv(place("color"), 1, rectangle.color.data());
  glDisable(GL_CULL_FACE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthMask(is_solid ? GL_TRUE : GL_FALSE);
  is_solid ? glDisable(GL_BLEND) : glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

Pixels Frame::read() const {
  Pixels pixels(kSize * kSize);
  glReadPixels(0, 0, kSize, kSize, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

bool Frame::is_as_begun() const {
  GLint bound = 0, viewport[4] = {}, scissor[4] = {};
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glGetIntegerv(GL_VIEWPORT, viewport);
  glGetIntegerv(GL_SCISSOR_BOX, scissor);
  return GLuint(bound) == framebuffer_ && viewport[2] == kSize && viewport[3] == kSize && scissor[2] == kSize &&
         scissor[3] == kSize && glIsEnabled(GL_SCISSOR_TEST) == GL_TRUE && glGetError() == GL_NO_ERROR;
}

}  // namespace host
