#include "render/egl_context.h"

#include "base/srgb.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <algorithm>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace coif::render {
namespace {

EGLConfig choose_config(EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (eglChooseConfig(display, wanted, &config, 1, &found) == EGL_FALSE || found == 0) return nullptr;
  return config;
}

/// Adds graphics cards without a window system, as in servers.
void add_devices(std::vector<EGLDisplay>& displays) {
  const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
  EGLDeviceEXT devices[16] = {};
  EGLint count = 0;
  if (query == nullptr || query(EGLint(std::size(devices)), devices, &count) == EGL_FALSE) return;
  for (EGLint i = 0; i < count; ++i) {
    displays.push_back(eglGetPlatformDisplay(EGL_PLATFORM_DEVICE_EXT, devices[i], nullptr));
  }
}

std::vector<EGLDisplay> all_displays() {
  std::vector<EGLDisplay> displays{eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
                                   eglGetDisplay(EGL_DEFAULT_DISPLAY)};
  add_devices(displays);
  return displays;
}

void* find_function(const char* name, void*) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

}  // namespace

// Loaders also return functions of absent extensions, so the list must be checked.
bool has_extension(const GlLoader& loader, std::string_view wanted) {
  const auto get_integer = reinterpret_cast<PFNGLGETINTEGERVPROC>(loader.get_proc("glGetIntegerv", loader.user));
  const auto get_string = reinterpret_cast<PFNGLGETSTRINGIPROC>(loader.get_proc("glGetStringi", loader.user));
  if (get_integer == nullptr || get_string == nullptr) return false;
  GLint count = 0;
  get_integer(GL_NUM_EXTENSIONS, &count);
  for (GLuint i = 0; i < GLuint(count); ++i) {
    const auto* name = reinterpret_cast<const char*>(get_string(GL_EXTENSIONS, i));
    if (name != nullptr && name == wanted) return true;
  }
  return false;
}

bool EglContext::open(void* display, Handles& handles) {
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE) return false;
  handles.display = display;
  if (eglBindAPI(EGL_OPENGL_ES_API) == EGL_FALSE) return false;
  const EGLConfig config = choose_config(display);
  if (config == nullptr) return false;
  // A surface nobody draws to: every EGL offers pixel buffers, not every EGL a context without surface.
  const EGLint size[] = {EGL_WIDTH, 1, EGL_HEIGHT, 1, EGL_NONE};
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  handles.surface = eglCreatePbufferSurface(display, config, size);
  handles.context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  return handles.surface != EGL_NO_SURFACE && handles.context != EGL_NO_CONTEXT &&
         eglMakeCurrent(display, handles.surface, handles.surface, handles.context) == EGL_TRUE;
}

tl::expected<EglContext, ToolError> EglContext::create() {
  for (const EGLDisplay display : all_displays()) {
    Handles handles;
    if (open(display, handles)) return EglContext(handles);
    release(handles);
  }
  return failure(ToolError::Kind::kUnsupported,
                 "no EGL display with OpenGL ES 3.0; install a driver, for example Mesa's software renderer (Debian: "
                 "libegl-mesa0, libgl1-mesa-dri)");
}

void EglContext::release(Handles& handles) {
  if (handles.display == nullptr) return;
  eglMakeCurrent(handles.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  if (handles.context != EGL_NO_CONTEXT) eglDestroyContext(handles.display, handles.context);
  if (handles.surface != EGL_NO_SURFACE) eglDestroySurface(handles.display, handles.surface);
  eglTerminate(handles.display);
  handles = {};
}

EglContext::EglContext(EglContext&& other) noexcept : handles_(other.handles_) { other.handles_ = {}; }

EglContext::~EglContext() { release(handles_); }

GlLoader EglContext::loader() const { return {find_function, nullptr}; }

std::string EglContext::device() const {
  const GLubyte* name = glGetString(GL_RENDERER);
  return name != nullptr ? reinterpret_cast<const char*>(name) : "";
}

tl::expected<std::unique_ptr<DrawingDevice>, ToolError> DrawingDevice::create(const RendererDesc& desc,
                                                                              const GlLoader* through) {
  auto context = EglContext::create();
  if (!context) return tl::unexpected(context.error());
  auto device = std::make_unique<DrawingDevice>(std::move(*context));
  const GlLoader loader = through != nullptr ? *through : device->context.loader();
  if (device->renderer.create(loader, desc) == Status::kOk) return device;
  return failure(ToolError::Kind::kUnsupported,
                 std::string("the renderer does not start: ") + device->renderer.failure());
}

namespace {

/// Returns the number of samples, which the driver may choose higher than requested.
GLint attach(GLenum attachment, GLenum format, std::uint32_t width, std::uint32_t height, GLsizei samples) {
  GLint given = 0;
  GLuint buffer = 0;
  glGenRenderbuffers(1, &buffer);
  glBindRenderbuffer(GL_RENDERBUFFER, buffer);
  glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, static_cast<GLsizei>(width),
                                   static_cast<GLsizei>(height));
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, buffer);
  glGetRenderbufferParameteriv(GL_RENDERBUFFER, GL_RENDERBUFFER_SAMPLES, &given);
  return given;
}

/// OpenGL's first row is the lowest, a picture's the highest.
template <typename Value>
std::vector<Value> top_down(std::vector<Value> pixels, std::size_t row) {
  const std::size_t height = pixels.size() / row;
  for (std::size_t low = 0, high = height - 1; low < high; ++low, --high) {
    const auto at = [&](std::size_t y) { return pixels.begin() + static_cast<std::ptrdiff_t>(y * row); };
    std::swap_ranges(at(low), at(low + 1), at(high));
  }
  return pixels;
}

}  // namespace

tl::expected<OffscreenTarget, ToolError> OffscreenTarget::create(std::uint32_t width, std::uint32_t height,
                                                                 std::uint32_t samples, Pixels pixels) {
  GLint max_samples = 0;
  glGetIntegerv(GL_MAX_SAMPLES, &max_samples);
  const GLsizei used_samples = std::min(static_cast<GLsizei>(samples), static_cast<GLsizei>(max_samples));

  OffscreenTarget target;
  target.width_ = width;
  target.height_ = height;
  const bool draws_floats = has_extension({find_function, nullptr}, "GL_EXT_color_buffer_float");
  target.pixels_ = draws_floats ? pixels : Pixels::kSrgb;
  const GLenum format = target.pixels_ == Pixels::kRadiance ? GL_RGBA16F : GL_SRGB8_ALPHA8;
  glGenFramebuffers(1, &target.resolved_);
  glBindFramebuffer(GL_FRAMEBUFFER, target.resolved_);
  attach(GL_COLOR_ATTACHMENT0, format, width, height, 0);
  const bool readable = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  glGenFramebuffers(1, &target.drawn_);
  glBindFramebuffer(GL_FRAMEBUFFER, target.drawn_);
  target.samples_ = std::uint32_t(std::max(attach(GL_COLOR_ATTACHMENT0, format, width, height, used_samples), 1));
  attach(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT24, width, height, used_samples);
  if (readable && glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE) return target;
  if (target.pixels_ == Pixels::kRadiance) return create(width, height, samples);
  return failure(ToolError::Kind::kUnsupported, "the driver has no framebuffer of " + std::to_string(width) + " x " +
                                                    std::to_string(height) + " pixels; ask for a smaller picture");
}

void OffscreenTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
  glViewport(0, 0, static_cast<GLsizei>(width_), static_cast<GLsizei>(height_));
}

void OffscreenTarget::resolve() const {
  const GLint width = static_cast<GLint>(width_);
  const GLint height = static_cast<GLint>(height_);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, drawn_);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved_);
  glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
  glBindFramebuffer(GL_READ_FRAMEBUFFER, resolved_);
}

std::vector<std::uint8_t> OffscreenTarget::read() const {
  resolve();
  const std::size_t row = std::size_t{4} * width_;
  std::vector<std::uint8_t> pixels(row * height_);
  glReadPixels(0, 0, GLsizei(width_), GLsizei(height_), GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
  return top_down(std::move(pixels), row);
}

std::vector<float> OffscreenTarget::read_radiance() const {
  const std::size_t row = std::size_t{4} * width_;
  if (pixels_ == Pixels::kSrgb) {
    std::vector<float> pixels;
    for (const std::uint8_t value : read())
      pixels.push_back(pixels.size() % 4 == 3 ? float(value) / 255 : decode_srgb(float(value) / 255));
    return pixels;
  }
  resolve();
  std::vector<float> pixels(row * height_);
  glReadPixels(0, 0, GLsizei(width_), GLsizei(height_), GL_RGBA, GL_FLOAT, pixels.data());
  glBindFramebuffer(GL_FRAMEBUFFER, drawn_);
  return top_down(std::move(pixels), row);
}

}  // namespace coif::render
