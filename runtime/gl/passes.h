#pragma once

#include "gl/alpha_range.h"
#include "gl/gl_functions.h"

#include <coif/asset_records.h>

#include <cstddef>
#include <span>

namespace coif {

/// One draw call over the whole level of detail.
struct Pass {
  bool shaded;  ///< Colour is written; otherwise depth only.
  bool blended;
  bool writes_depth;
  GLenum culled;    ///< GL_NONE: both faces are drawn.
  float alpha_min;  ///< Drawn: alpha_min <= alpha < alpha_max.
  float alpha_max;
  bool tests_alpha = true;  ///< False: every texel is in that range.
};

/// The passes that draw something, in their order.
class PassList {
 public:
  static constexpr std::size_t kMost = 4;

  void add(const Pass& pass) { passes_[count_++] = pass; }
  [[nodiscard]] std::span<const Pass> passes() const { return std::span(passes_).first(count_); }

 private:
  Pass passes_[kMost] = {};
  std::size_t count_ = 0;
};

/// The thesis's four passes (5.3.1), without those that no texel of the asset can be in. Without `transparency` the
/// first alone.
[[nodiscard]] PassList plan_passes(const MaterialRecord& material, const AlphaRange& texture, bool transparency);

}  // namespace coif
