#include "research/exact.h"

#include "gl/textures.h"

#include <cstdio>
#include <new>

namespace coif {
namespace {

ExactMemory& memory_in(ModeMemory& memory) { return *std::launder(reinterpret_cast<ExactMemory*>(memory.bytes)); }

void release_all(const GlFunctions& gl, ModeMemory& memory) {
  ExactMemory& exact = memory_in(memory);
  release(gl, exact.lists);
  release(gl, exact.functions, exact.peel);
}

/// Loads all functions except those of OpenGL ES 3.1. Null where the host lacks one, with the reason in the renderer's
/// failure.
ExactMemory* exact_memory(RendererState& renderer) {
  static_assert(sizeof(ExactMemory) <= sizeof(ModeMemory::bytes));
  if (renderer.mode_memory.release != nullptr) return &memory_in(renderer.mode_memory);
  ExactMemory* const made = new (static_cast<void*>(renderer.mode_memory.bytes)) ExactMemory;
  if (const char* missing = made->functions.load(renderer.loader)) {
    std::snprintf(renderer.failure, sizeof renderer.failure, "%s is missing; OpenGL ES 3.0 is needed", missing);
    return nullptr;
  }
  made->memory_barrier = reinterpret_cast<decltype(made->memory_barrier)>(
      renderer.loader.get_proc("glMemoryBarrier", renderer.loader.user));
  renderer.mode_memory.release = release_all;
  return made;
}

Pass peel_pass(const MaterialRecord& material, const FragmentCode& code) {
  Pass pass = soft_pass(material);
  pass.shaded = false;
  pass.blended = false;
  pass.writes_depth = true;
  pass.code = &code;
  return pass;
}

Pass soft_pass_with(const MaterialRecord& material, const FragmentCode& code) {
  Pass pass = soft_pass(material);
  pass.code = &code;
  return pass;
}

/// The passes of both ways to draw soft texels; split_passes() separates them.
PassList plan(const MaterialRecord& material, const AlphaRange& texture) {
  const AlphaRange alpha = drawn_alpha(material, texture);
  PassList drawn;
  drawn.add_for(alpha, solid_pass(material));
  drawn.add_for(alpha, soft_pass_with(material, kListCode));
  drawn.add_for(alpha, peel_pass(material, kPeelDepthCode));
  drawn.add_for(alpha, peel_pass(material, kPeelKeyCode));
  drawn.add_for(alpha, soft_pass_with(material, kPeeledCode));
  drawn.add_for(alpha, soft_depth_pass(material));
  return drawn;
}

struct ExactPasses {
  PassList solid;
  PassList listed;
  PeelPasses peeled;
  PassList depth;
};

ExactPasses split_passes(const PassList& all) {
  ExactPasses split;
  for (const Pass& pass : all.passes()) {
    PassList* const with_code[] = {&split.listed, &split.peeled.find_depth, &split.peeled.find_key,
                                   &split.peeled.draw_found};
    const bool has_own_code = pass.code->id >= kListCode.id;
    PassList& list = has_own_code ? *with_code[pass.code->id - kListCode.id] : pass.shaded ? split.solid : split.depth;
    list.add(pass);
  }
  return split;
}

PixelArea viewport(const GlFunctions& gl) {
  GLint area[4] = {};
  gl.GetIntegerv(GL_VIEWPORT, area);
  return {area[0], area[1], area[2], area[3]};
}

bool draw_soft(const ModeDraw& draw, const ExactPasses& passes, const PixelArea& area, bool lists,
               ExactMemory& memory) {
  if (lists) {
    const Listed listed = draw_lists(draw, passes.listed, area, memory);
    if (listed != Listed::kOverflow) return listed == Listed::kDrawn;
    if (!make_peel_targets(draw, area, memory)) return false;
  }
  return draw_peeled(draw, passes.peeled, memory);
}

// Solid texels come first, so that soft ones behind them get into no list and need no layer.
bool draw_exactly(const ModeDraw& draw) {
  const ExactPasses passes = split_passes(draw.passes);
  if (passes.listed.passes().empty()) return draw.crowd.draw(passes.solid);
  ExactMemory* const memory = exact_memory(draw.renderer);
  if (memory == nullptr) return false;
  const PixelArea area = viewport(draw.renderer.gl);
  if (area.width == 0 || area.height == 0) return true;
  const bool lists = has_lists(draw, *memory);
  if (!(lists ? make_lists(draw, area, memory->lists) : make_peel_targets(draw, area, *memory))) return false;
  if (!draw.crowd.draw(passes.solid) || !draw_soft(draw, passes, area, lists, *memory)) return false;
  set_draw_state(draw.renderer.gl);
  return draw.crowd.draw(passes.depth);
}

}  // namespace

const TransparencyMode kExactMode = {"exact", plan, draw_exactly};

}  // namespace coif
