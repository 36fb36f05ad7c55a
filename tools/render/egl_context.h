#pragma once

#include "tool_error.h"

#include <coif/renderer.h>

#include <tl/expected.hpp>

#include <string>

namespace coif {

/// An OpenGL ES 3.0 context without a window, current on the thread that made it, freed with this object. All objects
/// made in it die with it. One at a time.
class EglContext {
 public:
  /// Tries Mesa's surfaceless platform, then the default display. kUnsupported when neither gives a context.
  static tl::expected<EglContext, ToolError> create();

  EglContext(EglContext&& other) noexcept;
  EglContext& operator=(EglContext&&) = delete;
  ~EglContext();

  [[nodiscard]] GlLoader loader() const;
  [[nodiscard]] std::string device() const;  ///< GL_RENDERER.

 private:
  struct Handles {  // EGLDisplay and the like; their header stays in the .cpp
    void* display = nullptr;
    void* surface = nullptr;
    void* context = nullptr;
  };
  explicit EglContext(const Handles& handles) : handles_(handles) {}
  static void release(Handles& handles);
  static bool open(void* display, Handles& handles);

  Handles handles_;
};

}  // namespace coif
