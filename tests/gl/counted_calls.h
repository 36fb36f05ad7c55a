#pragma once

#include <coif/renderer.h>

#include <GLES3/gl3.h>

#include <vector>

namespace coif {

/// A host that writes down what a renderer asks of OpenGL and passes it on. One at a time: OpenGL's functions do not know
/// who calls.
class CountedCalls {
 public:
  /// Passes calls on to the functions that `real` finds.
  explicit CountedCalls(const GlLoader& real);
  ~CountedCalls();
  CountedCalls(const CountedCalls&) = delete;
  CountedCalls& operator=(const CountedCalls&) = delete;

  [[nodiscard]] GlLoader loader();

  /// From here on no shader compiles.
  void spoil_shaders() { spoils_shaders_ = true; }
  void forget() { links = 0, draws = 0, instances = 0, textures = 0, objects = 0, storage = 0, drawn_with.clear(); }

  int links = 0;                   ///< Programs linked.
  int draws = 0;                   ///< Draw calls.
  int instances = 0;               ///< Of all draw calls.
  int textures = 0;                ///< Textures given storage.
  int objects = 0;                 ///< Buffers and textures made.
  int storage = 0;                 ///< Buffers and textures given storage.
  std::vector<GLuint> drawn_with;  ///< The program of each draw call.

 private:
  struct Hooks;
  friend struct Hooks;

  GlLoader real_;
  GLuint program_ = 0;
  bool spoils_shaders_ = false;
};

}  // namespace coif
