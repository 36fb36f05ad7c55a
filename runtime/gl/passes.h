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
  const char* vertex_end = "";  ///< Comes after the vertex shader: functions that it calls.
  /// Further textures that the shader reads. Null: none.
  struct Sampler {
    const char* name = nullptr;
    std::int32_t unit = 0;
  } samplers[2] = {};
  std::uint32_t storage_blocks = 0;  ///< Buffers that it writes to. Above 0 the program needs OpenGL ES 3.1.
  /// Whether it says which samples are drawn, for which the program needs OpenGL ES 3.2, or takes the place of one that
  /// does.
  enum class SampleMask : std::uint8_t { kNotUsed, kWritten, kMissing } sample_mask = SampleMask::kNotUsed;
  bool thins = false;  ///< Drops some of the texels between Pass::alpha_min and solid_from.
};

inline constexpr std::uint32_t kMaxFragmentCodes = 32;

/// Keeps a range of alpha (Pass::alpha_min to alpha_max) and writes premultiplied colour.
extern COIF_API const FragmentCode kRangeCode;

inline constexpr float kNoAlphaLimit = FLT_MAX;

/// One draw call over a level of detail.
struct Pass {
  bool shaded;  ///< Colour is written; otherwise depth only.
  bool blended;
  bool writes_depth;
  GLenum culled;    ///< GL_NONE: both faces are drawn.
  float alpha_min;  ///< Drawn: alpha_min <= alpha < alpha_max.
  float alpha_max;
  float solid_from = 0;     ///< Texels of at least this alpha cover all that is behind them.
  bool tests_alpha = true;  ///< False: every texel is in that range and none is thinned.
  const FragmentCode* code = &kRangeCode;
  const ShadowLookup* shadow = nullptr;  ///< Looked up where light is summed, or by `code`.

  [[nodiscard]] bool writes_color() const { return code->storage_blocks == 0 && (shaded || code->other != nullptr); }
};

/// The passes that draw something, in their order.
class PassList {
 public:
  static constexpr std::size_t kMost = 6;

  /// Leaves the pass out if no texel of these alphas is in its range, and the test if all are.
  COIF_API void add_for(const AlphaRange& alpha, Pass pass);
  /// At most kMost.
  void add(const Pass& pass) { passes_[count_++] = pass; }
  /// Where light is summed, one of the lights has this shadow.
  void add_shadow(const ShadowLookup& shadow);
  [[nodiscard]] std::span<const Pass> passes() const { return std::span(passes_).first(count_); }

 private:
  Pass passes_[kMost] = {};
  std::size_t count_ = 0;
};

/// Of the texture times the material's own alpha.
[[nodiscard]] COIF_API AlphaRange drawn_alpha(const MaterialRecord& material, const AlphaRange& texture);

/// What is culled where both faces are wanted: back faces of one-sided hair.
[[nodiscard]] GLenum unseen_faces(const MaterialRecord& material);

/// Texels from the opaque threshold on, as solid, sorted by the depth buffer.
[[nodiscard]] COIF_API Pass solid_pass(const MaterialRecord& material);

/// Texels between the thresholds, blended over what is there.
[[nodiscard]] COIF_API Pass soft_pass(const MaterialRecord& material);

/// Depth of those soft texels that hide most of what is behind them. For what is drawn after the hair.
[[nodiscard]] COIF_API Pass soft_depth_pass(const MaterialRecord& material);

/// Texels from the discard threshold on, those below the opaque one thinned by `code`, all sorted by the depth buffer.
[[nodiscard]] COIF_API Pass thinned_pass(const MaterialRecord& material, const FragmentCode& code);

/// The passes of those modes that take one and do not blend.
template <const FragmentCode& code>
PassList plan_thinned(const MaterialRecord& material, const AlphaRange& texture) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), thinned_pass(material, code));
  return drawn;
}

/// What passes share: premultiplied blending, depth test, winding.
COIF_API void set_draw_state(const GlFunctions& gl);

/// What this pass wants beside.
void set_pass_state(const GlFunctions& gl, const Pass& pass);

/// Everything that the two above set, at OpenGL's initial values.
void leave_draw_state(const GlFunctions& gl);

/// One call of HairRenderer::draw(): everything is checked, built and bound. The renderer is there for modes with
/// objects of their own.
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
  /// Null: all passes, once. Leaves what it sets at OpenGL's initial values. False where the driver refuses.
  bool (*draw)(const ModeDraw& draw) = nullptr;
};

}  // namespace coif
