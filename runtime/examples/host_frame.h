#pragma once
// Stands for the engine's renderer: a framebuffer of its own, a camera, and things that it draws itself.

#include <GLES3/gl3.h>

#include <array>
#include <cstdint>
#include <vector>

namespace host {

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
