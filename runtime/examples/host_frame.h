#pragma once
// Stands for the engine: its OpenGL ES context, and its renderer with a framebuffer of its own, a camera, and things
// that it draws itself. Nothing here is about hair.

#include <coif/renderer.h>

#include <GLES3/gl3.h>

#include <array>
#include <cstdint>
#include <vector>

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

inline constexpr int kSize = 256;  // pixels each way

using Pixels = std::vector<std::uint32_t>;  ///< RGBA bytes, rows from the bottom.

/// A flat thing that faces the camera; world, metres.
struct Rectangle {
  float left, bottom, right, top, z;
  std::array<float, 4> color;  ///< Linear; alpha below 1: seen through.
};

/// Looks along -Z.
struct Camera {
  std::array<float, 3> eye{0.0f, 1.62f, 0.9f};
  [[nodiscard]] std::array<float, 16> clip_from_world() const;  ///< Column-major.
};

class Frame {
 public:
  /// Textures for colour (sRGB) and depth, and a program. False where the driver refuses.
  bool create();

  void begin() const;
  /// Sets all the state that it needs, and believes nothing about what was set before.
  void draw(const Camera& camera, const Rectangle& rectangle) const;
  [[nodiscard]] Pixels read() const;

  /// Whether it is still the target, with the viewport and the scissor of begin().
  [[nodiscard]] bool is_as_begun() const;

 private:
  GLuint framebuffer_ = 0;
  GLuint program_ = 0;
};

}  // namespace host
