// Alpha becomes a number of samples: kProportionalMode takes the nearest, kJitteredMode rounds up or down at random.

#include "gl/crowd_draw.h"
#include "gl/passes.h"

#include <coif/research.h>

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr char kCorner[] = "#define COIF_CORNER\n";

constexpr FragmentCode kProportionalCode = {
    .id = 10, .keep = kShaderKeepProportionalGlsl, .output = kShaderCoverageOutputGlsl, .thins = true};

constexpr FragmentCode kJitteredCode = {.id = 11,
                                        .keep = kShaderKeepJitteredGlsl,
                                        .output = kShaderCoverageOutputGlsl,
                                        .vertex = kCorner,
                                        .sample_mask = FragmentCode::SampleMask::kMissing,
                                        .thins = true};

constexpr FragmentCode kMaskedCode = {.id = 12,
                                      .keep = kShaderKeepMaskedGlsl,
                                      .output = kShaderHairOutputGlsl,
                                      .vertex = kCorner,
                                      .sample_mask = FragmentCode::SampleMask::kWritten,
                                      .thins = true};

/// thinned_pass(), for draw_counted(): some of a soft texel's samples are drawn.
template <const FragmentCode& code>
PassList plan_counted(const MaterialRecord& material, const AlphaRange& texture) {
  Pass pass = thinned_pass(material, code);
  pass.blended = true;  // Blends for the target's alpha.
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

/// draw_covered(), where shaders find in the place of Pass::alpha_max how many samples a pixel of the bound framebuffer
/// has, 1 without multisampling.
bool draw_counted(const ModeDraw& draw) {
  GLint samples = 0;
  draw.renderer.gl.GetIntegerv(GL_SAMPLES, &samples);
  PassList counted;
  for (Pass pass : draw.passes.passes()) {
    pass.alpha_max = samples > 1 ? float(samples) : 1.0f;
    counted.add(pass);
  }
  return draw_covered({draw.renderer, draw.crowd, counted});
}

PassList plan_jittered(const MaterialRecord& material, const AlphaRange& texture) {
  PassList drawn = plan_counted<kJitteredCode>(material, texture);
  drawn.add_for(drawn_alpha(material, texture), thinned_pass(material, kMaskedCode));
  return drawn;
}

bool draw_jittered(const ModeDraw& draw) {
  PassList taken;
  for (const Pass& pass : draw.passes.passes()) {
    if (draw.renderer.takes(*pass.code)) taken.add(pass);
  }
  return draw.renderer.has_sample_masks ? draw.crowd.draw(taken) : draw_counted({draw.renderer, draw.crowd, taken});
}

}  // namespace

const TransparencyMode kProportionalMode = {"proportional", plan_counted<kProportionalCode>, draw_counted};

const TransparencyMode kJitteredMode = {"jittered", plan_jittered, draw_jittered};

}  // namespace coif
