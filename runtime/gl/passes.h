#pragma once

#include "gl/alpha_range.h"
#include "gl/fragment_code.h"
#include "gl/gl_functions.h"

#include <coif/asset_records.h>

#include <cfloat>
#include <cstddef>
#include <span>

namespace coif {

struct ShadowLookup;

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
  void add_for(const AlphaRange& alpha, Pass pass);
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
[[nodiscard]] AlphaRange drawn_alpha(const MaterialRecord& material, const AlphaRange& texture);

/// What is culled where both faces are wanted: back faces of one-sided hair.
[[nodiscard]] GLenum unseen_faces(const MaterialRecord& material);

/// Texels from the opaque threshold on, as solid, sorted by the depth buffer.
[[nodiscard]] Pass solid_pass(const MaterialRecord& material);

/// Texels between the thresholds, blended over what is there.
[[nodiscard]] Pass soft_pass(const MaterialRecord& material);

/// Depth of those soft texels that hide most of what is behind them. For what is drawn after the hair.
[[nodiscard]] Pass soft_depth_pass(const MaterialRecord& material);

/// Texels from the discard threshold on, those below the opaque one thinned by `code`, all sorted by the depth buffer.
[[nodiscard]] Pass thinned_pass(const MaterialRecord& material, const FragmentCode& code);

}  // namespace coif
