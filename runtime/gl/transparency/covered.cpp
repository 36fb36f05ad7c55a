#include "gl/transparency/covered.h"

#include "gl/crowd_draw.h"

namespace coif {

bool draw_covered(const ModeDraw& draw) {
  const GlFunctions& gl = draw.renderer.gl;
  gl.BlendFuncSeparate(GL_ONE, GL_ZERO, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  gl.Enable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  const bool is_drawn = draw.crowd.draw(draw.passes);
  gl.Disable(GL_SAMPLE_ALPHA_TO_COVERAGE);
  return is_drawn;
}

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

}  // namespace coif
