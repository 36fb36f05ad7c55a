#pragma once
// What ways to draw by alpha to coverage share: fragments' alpha becomes a number of samples.

#include "gl/passes.h"

namespace coif {

/// Draws the passes with alpha to coverage. Samples that are drawn get the whole colour. Their alpha, which says how
/// many are drawn, would be left in the target too and let the picture through a second time where it is shown; over
/// what is opaque it stays 1 this way.
bool draw_covered(const ModeDraw& draw);

/// The same, and shaders find in the place of Pass::alpha_max how many samples a pixel of the bound framebuffer has, 1
/// without multisampling.
bool draw_counted(const ModeDraw& draw);

/// thinned_pass(), for draw_counted(): of a soft texel some of the samples are drawn.
template <const FragmentCode& code>
PassList plan_counted(const MaterialRecord& material, const AlphaRange& texture) {
  Pass pass = thinned_pass(material, code);
  pass.blended = true;  // for the target's alpha
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

}  // namespace coif
