#pragma once

#include <cstdint>

namespace coif {

/// The parts of a fragment shader in which ways to draw differ, as GLSL. A way's own live in its own file, so that a
/// program which does not name it does not hold them.
struct FragmentCode {
  std::uint32_t id;    ///< Of the programs built from it, below kMaxFragmentCodes; no two codes share one.
  const char* keep;    ///< `float keep(float alpha)`: discards, or tells how solid the texel is, 0..1.
  const char* output;  ///< `void write_fragment(vec3 linear, float coverage)` and what it writes to.
  /// Instead of shading and its output, where not null: a whole `main()` that writes something else than colour.
  const char* other = nullptr;
  const char* shared = "";  ///< Comes before all of these: what they have in common.
  /// Lines before the vertex shader: which of its outputs `keep` reads, COIF_REST_PLACE or COIF_CORNER.
  const char* vertex = "";
  /// Further textures that the shader reads. Null: none.
  struct Sampler {
    const char* name = nullptr;
    std::int32_t unit = 0;
  } samplers[2] = {};
  std::uint32_t storage_blocks = 0;  ///< Buffers that it writes to. Above 0 the program needs OpenGL ES 3.1.
  bool thins = false;                ///< Drops some of the texels between Pass::alpha_min and solid_from.
};

inline constexpr std::uint32_t kMaxFragmentCodes = 16;

/// Keeps a range of alpha (Pass::alpha_min to alpha_max) and writes premultiplied colour.
extern const FragmentCode kRangeCode;

}  // namespace coif
