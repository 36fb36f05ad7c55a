#pragma once
// Ways to draw: of which passes each consists, and what its fragment shaders do otherwise than others'. COIF_API marks
// what ways outside this library (runtime/research) call, here and in this folder's other headers.

#include "gl/gl_functions.h"

#include <coif/drawing.h>
#include <coif/export.h>
#include <coif/transparency.h>

#include <cfloat>
#include <cstddef>
#include <cstdint>
#include <span>

namespace coif {

class CrowdDraw;
struct RendererState;
struct ShadowLookup;

/// The parts of a fragment shader in which the ways to draw differ, as GLSL. Each way has its own in its own file, so
/// that a program that does not name the way does not link them.
struct FragmentCode {
  std::uint32_t id;    ///< Marks the programs built from this code; below kMaxFragmentCodes, no two codes share one.
  const char* keep;    ///< `float keep(float alpha)`: discards the texel or returns how solid it is, 0..1.
  const char* output;  ///< `void write_fragment(vec3 linear, float coverage)` and what it writes to.
  /// If not null, replaces shading and output: a whole `main()` that writes something other than colour.
  const char* other = nullptr;
  const char* shared = "";  ///< Comes before all of these: what they have in common.
  /// Lines in front of the vertex shader that enable the outputs that `keep` reads: COIF_REST_PLACE or COIF_CORNER.
  const char* vertex = "";
  const char* vertex_end = "";  ///< Comes after the vertex shader: functions that it calls.
  /// A further texture that the shader reads. Null: none.
  struct Sampler {
    const char* name = nullptr;
    std::int32_t unit = 0;
  } samplers[2] = {};
  std::uint32_t storage_blocks = 0;  ///< Number of buffers that it writes to. Above 0 the program needs OpenGL ES 3.1.
  /// kWritten: chooses the samples itself, for which the program needs OpenGL ES 3.2. kMissing: replaces such a program
  /// on older versions.
  enum class SampleMask : std::uint8_t { kNotUsed, kWritten, kMissing } sample_mask = SampleMask::kNotUsed;
  bool thins = false;  ///< Drops some of the texels between Pass::alpha_min and solid_from.
};

inline constexpr std::uint32_t kMaxFragmentCodes = 32;

/// Keeps a range of alpha (Pass::alpha_min to alpha_max) and writes premultiplied colour.
extern COIF_API const FragmentCode kRangeCode;

inline constexpr float kNoAlphaLimit = FLT_MAX;

/// One draw call over a level of detail.
struct Pass {
  bool shaded;  ///< Writes colour; otherwise depth only.
  bool blended;
  bool writes_depth;
  GLenum culled;    ///< GL_NONE: both faces are drawn.
  float alpha_min;  ///< Drawn: alpha_min <= alpha < alpha_max.
  float alpha_max;
  float solid_from = 0;     ///< Texels of at least this alpha hide everything behind them.
  bool tests_alpha = true;  ///< False: every texel is in that range and none is thinned.
  const FragmentCode* code = &kRangeCode;
  const ShadowLookup* shadow = nullptr;  ///< Used where light is summed, or by `code`.

  [[nodiscard]] bool writes_color() const { return code->storage_blocks == 0 && (shaded || code->other != nullptr); }
};

/// The passes that draw something, in their order.
class PassList {
 public:
  static constexpr std::size_t kMost = 6;

  /// Leaves the pass out if no texel of these alphas is in its range, and turns off its test if all are.
  COIF_API void add_for(const AlphaRange& alpha, Pass pass);
  /// At most kMost passes.
  void add(const Pass& pass) { passes_[count_++] = pass; }
  /// Lets one of the lights have this shadow in passes that sum light.
  void add_shadow(const ShadowLookup& shadow);
  [[nodiscard]] std::span<const Pass> passes() const { return std::span(passes_).first(count_); }

 private:
  Pass passes_[kMost] = {};
  std::size_t count_ = 0;
};

/// The range of the texture's alpha times the material's own alpha.
[[nodiscard]] COIF_API AlphaRange drawn_alpha(const MaterialRecord& material, const AlphaRange& texture);

/// The faces to cull where both are wanted: back faces for one-sided hair, else none.
[[nodiscard]] GLenum unseen_faces(const MaterialRecord& material);

/// Texels from the opaque threshold on, drawn as solid, sorted by the depth buffer.
[[nodiscard]] COIF_API Pass solid_pass(const MaterialRecord& material);

/// Texels between the thresholds, blended over what is there.
[[nodiscard]] COIF_API Pass soft_pass(const MaterialRecord& material);

/// Depth of those soft texels that hide most of what is behind them, for things that are drawn after the hair.
[[nodiscard]] COIF_API Pass soft_depth_pass(const MaterialRecord& material);

/// Texels from the discard threshold on, all sorted by the depth buffer. `code` thins those below the opaque threshold.
[[nodiscard]] COIF_API Pass thinned_pass(const MaterialRecord& material, const FragmentCode& code);

/// The passes of the modes that have one pass and do not blend.
template <const FragmentCode& code>
PassList plan_thinned(const MaterialRecord& material, const AlphaRange& texture) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), thinned_pass(material, code));
  return drawn;
}

/// Sets the state that passes share: premultiplied blending, depth test, winding.
COIF_API void set_draw_state(const GlFunctions& gl);

/// Sets the state of this pass.
void set_pass_state(const GlFunctions& gl, const Pass& pass);

/// Resets everything that the two functions above set to OpenGL's initial values.
void leave_draw_state(const GlFunctions& gl);

/// The arguments of one call of HairRenderer::draw(), after everything was checked, built and bound. Modes with objects
/// of their own need the renderer.
struct ModeDraw {
  RendererState& renderer;
  CrowdDraw& crowd;
  const PassList& passes;
};

/// Draws the passes with alpha to coverage. Samples that are drawn get the whole colour. Their alpha, which says how
/// many are drawn, would be left in the target too and let the picture through a second time where it is shown; over
/// what is opaque it stays 1 this way. Lies beside kCoverageMode.
COIF_API bool draw_covered(const ModeDraw& draw);

struct TransparencyMode {
  const char* name;
  /// The passes that draw something of an asset whose texture's alpha lies in this range.
  PassList (*plan_passes)(const MaterialRecord& material, const AlphaRange& texture);
  /// Null: all passes are drawn once. Else draws them, and leaves the state that it sets at OpenGL's initial values.
  /// False where the driver refuses.
  bool (*draw)(const ModeDraw& draw) = nullptr;
};

}  // namespace coif
