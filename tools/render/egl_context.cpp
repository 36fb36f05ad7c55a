#include "render/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

namespace coif {
namespace {

EGLConfig choose_config(EGLDisplay display) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (eglChooseConfig(display, wanted, &config, 1, &found) == EGL_FALSE || found == 0) return nullptr;
  return config;
}

void* find_function(const char* name, void*) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

}  // namespace

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
  const EGLDisplay displays[] = {
      eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr),
      eglGetDisplay(EGL_DEFAULT_DISPLAY),
  };
  for (const EGLDisplay display : displays) {
    Handles handles;
    if (open(display, handles)) return EglContext(handles);
    release(handles);
  }
  return tl::unexpected(ToolError{ToolError::Kind::kUnsupported,
                                  "no EGL display with OpenGL ES 3.0; install a driver, for example Mesa's "
                                  "software renderer (Debian: libegl-mesa0, libgl1-mesa-dri)"});
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

}  // namespace coif
