#include "gl/crowd_draw.h"
#include "gl/passes.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr FragmentCode kSharpenedCode = {
    .id = 1, .keep = kShaderKeepSharpenedGlsl, .output = kShaderCoverageOutputGlsl};

// The alpha at which hair covers half: there the part of an edge that is wrongly drawn is as large as the part that is
// missing. With a cut at the opaque threshold hair would be too thin.
constexpr float kCut = 0.5f;

PassList plan(const MaterialRecord& material, const AlphaRange& texture) {
  Pass pass = solid_pass(material);
  if (pass.alpha_min > kCut) pass.alpha_min = kCut > material.discard_threshold ? kCut : material.discard_threshold;
  pass.blended = true;  // Blends for the target's alpha, see draw_covered().
  pass.code = &kSharpenedCode;
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

}  // namespace

bool draw_covered(const ModeDraw& draw) {
  const GlFunctions& gl = draw.renderer.gl;
  gl.BlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  const bool is_drawn = draw.crowd.draw(draw.passes);
  gl.Disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  return is_drawn;
}

const TransparencyMode kCoverageMode = {"coverage", plan, draw_covered};

}  // namespace coif
