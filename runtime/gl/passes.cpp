#include "gl/passes.h"

#include <cfloat>

namespace coif {
namespace {

// Of everything that is hidden by hair and drawn later, a texel of alpha a should show 1 - a. Writing depth shows 0 of
// it, not writing shows 1, so half is where one error becomes smaller than the other. Lower, the faint borders of cards
// would punch holes into smoke or glass behind them; higher, it would shine through hair that is nearly solid.
constexpr float kDepthAlpha = 0.5f;
constexpr float kNoLimit = FLT_MAX;

AlphaRange times(const AlphaRange& range, float factor) {
  const float a = range.lowest * factor, b = range.highest * factor;
  return a < b ? AlphaRange{a, b} : AlphaRange{b, a};
}

}  // namespace

PassList plan_passes(const MaterialRecord& material, const AlphaRange& texture, bool transparency) {
  const float opaque = material.opaque_threshold;
  const float faintest = material.discard_threshold;
  const float solid = faintest > kDepthAlpha ? faintest : kDepthAlpha;
  // Texels from the opaque threshold on count as solid; what is fainter blends, back faces first, since over most of a
  // head they are the far side; below the discard threshold nothing is drawn, which spares the blend unit the empty
  // parts of the texture. Within a pass the index list's order is all the sorting there is: inner patches first.
  const bool double_sided = (material.flags & kMaterialDoubleSided) != 0;
  const GLenum unseen = double_sided ? GL_NONE : GL_BACK;
  const Pass all[PassList::kMost] = {
      {true, false, true, unseen, opaque, kNoLimit},
      {true, true, false, GL_FRONT, faintest, double_sided ? opaque : faintest},
      {true, true, false, GL_BACK, faintest, opaque},
      {false, false, true, unseen, solid, opaque},
  };
  const AlphaRange alpha = times(texture, material.base_color[3]);
  PassList drawn;
  for (Pass pass : std::span(all).first(transparency ? PassList::kMost : 1)) {
    const bool empty =
        pass.alpha_min >= pass.alpha_max || alpha.highest < pass.alpha_min || alpha.lowest >= pass.alpha_max;
    if (empty) continue;
    pass.tests_alpha = alpha.lowest < pass.alpha_min || alpha.highest >= pass.alpha_max;
    drawn.add(pass);
  }
  return drawn;
}

}  // namespace coif
