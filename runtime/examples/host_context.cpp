#include "host_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

namespace host {
namespace {

void* find_function(const char* name, void*) { return reinterpret_cast<void*>(eglGetProcAddress(name)); }

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

}  // namespace host
