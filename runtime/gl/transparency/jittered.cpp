#include "gl/crowd_draw.h"
#include "gl/transparency/covered.h"

#include <hair_shaders.h>

namespace coif {
namespace {

constexpr char kCorner[] = "#define COIF_CORNER\n";

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

PassList plan(const MaterialRecord& material, const AlphaRange& texture) {
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

const TransparencyMode kJitteredMode = {"jittered", plan, draw_jittered};

}  // namespace coif
