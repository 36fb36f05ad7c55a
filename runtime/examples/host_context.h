#pragma once
// Stands for the engine's window and its OpenGL ES context; nothing here is about hair.

#include <coif/renderer.h>

namespace host {

/// An OpenGL ES 3.0 context without a window, current until the program ends.
class Context {
 public:
  Context() = default;
  Context(const Context&) = delete;
  Context& operator=(const Context&) = delete;
  ~Context();

  /// False where there is no driver for it.
  bool open();

  /// How coif finds OpenGL's functions: by the host's own means, whatever they are.
  static coif::GlLoader loader();

 private:
  void* display_ = nullptr;
  void* context_ = nullptr;
};

}  // namespace host
