#pragma once
// Stands for the engine: its OpenGL ES context, and its renderer with a framebuffer, a camera and things that it draws.
// Nothing here is about hair.

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

  /// False if no driver offers one.
  bool open();

  /// Lets coif find OpenGL's functions by the host's own means.
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
  std::array<float, 4> color;  ///< Linear; transparent if alpha is below 1.
};

/// Looks along -Z.
struct Camera {
  std::array<float, 3> eye{0.0f, 1.62f, 0.9f};
  [[nodiscard]] std::array<float, 16> clip_from_world() const;  ///< Column-major.
};

class Frame {
 public:
  /// Creates textures for colour (sRGB) and depth, and a program. False if the driver refuses.
  bool create();

  void begin() const;
  /// Sets all the state that it needs and relies on nothing that was set before.
  void draw(const Camera& camera, const Rectangle& rectangle) const;
  [[nodiscard]] Pixels read() const;

  /// Whether this is still the target, with the viewport and the scissor of begin().
  [[nodiscard]] bool is_as_begun() const;

 private:
  GLuint framebuffer_ = 0;
  GLuint program_ = 0;
};

}  // namespace host
