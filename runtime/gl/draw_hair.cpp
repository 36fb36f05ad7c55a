#include "gl/binding_points.h"
#include "gl/draw_block.h"
#include "gl/gl_functions.h"
#include "gl/palette.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>

namespace coif {
namespace {

// Of everything that is hidden by hair and drawn later, a texel of alpha a should show 1 - a. Writing depth shows 0 of
// it, not writing shows 1, so half is where one error becomes smaller than the other. Lower, the faint borders of cards
// would punch holes into smoke or glass behind them; higher, it would shine through hair that is nearly solid.
constexpr float kDepthAlpha = 0.5f;
constexpr float kNoLimit = 2.0f;  // above every alpha

struct Pass {
  bool shaded;      // colour is written; otherwise depth only
  bool blended;
  bool writes_depth;
  GLenum culled;    // GL_NONE: both faces are drawn
  float alpha_min;  // drawn: alpha_min <= alpha < alpha_max
  float alpha_max;
};

void set_enabled(const GlFunctions& gl, GLenum capability, bool enabled) {
  enabled ? gl.Enable(capability) : gl.Disable(capability);
}

void set_pass_state(const GlFunctions& gl, const Pass& pass) {
  set_enabled(gl, GL_BLEND, pass.blended);
  set_enabled(gl, GL_CULL_FACE, pass.culled != GL_NONE);
  if (pass.culled != GL_NONE) gl.CullFace(pass.culled);
  gl.DepthMask(pass.writes_depth ? GL_TRUE : GL_FALSE);
  const GLboolean color = pass.shaded ? GL_TRUE : GL_FALSE;
  gl.ColorMask(color, color, color, color);
}

}  // namespace

Status HairRenderer::draw(const HairModel& model, const DrawDesc& desc) {
  if (!created_ || model.renderer_ != this) return Status::kNotCreated;
  if (desc.palette.size() != model.bone_count_) return Status::kSizeMismatch;
  const MaterialRecord& material = desc.material != nullptr ? *desc.material : model.material_;
  if (desc.lod >= model.lod_count_) return Status::kBadArgument;
  DrawBlock block;
  if (const Status status = fill_draw_block(desc, material, block); status != Status::kOk) return status;

  send_uniforms(block, desc.palette);
  bind(model);
  draw_passes(model, material, desc);
  leave_initial_state(fits_uniform_block(desc.palette));
  return Status::kOk;
}

void HairRenderer::send_uniforms(const DrawBlock& block, std::span<const Mat34> palette) const {
  const GlFunctions& gl = functions();
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kDrawIndex, draw_buffer_);
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
  send_palette_block(gl, palette_buffer_, palette);
  if (!fits_uniform_block(palette)) send_palette_texture(gl, palette_texture_, palette);
}

void HairRenderer::bind(const HairModel& model) const {
  const GlFunctions& gl = functions();
  gl.BindVertexArray(model.vertex_array_);
  // A sampler object of the host's would override the texture's own filters.
  gl.BindSampler(kBaseUnit, 0);
  gl.BindSampler(kShiftMaskUnit, 0);
  gl.ActiveTexture(GL_TEXTURE0 + kShiftMaskUnit);
  gl.BindTexture(GL_TEXTURE_2D, model.shift_mask_texture_);
  gl.ActiveTexture(GL_TEXTURE0 + kBaseUnit);
  gl.BindTexture(GL_TEXTURE_2D, model.base_texture_);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // premultiplied
  gl.FrontFace(GL_CCW);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);  // of cards in one place the later, outer one wins
}

void HairRenderer::draw_passes(const HairModel& model, const MaterialRecord& material, const DrawDesc& desc) const {
  const float opaque = material.opaque_threshold;
  const float faintest = material.discard_threshold;
  const float solid = faintest > kDepthAlpha ? faintest : kDepthAlpha;
  // Texels from the opaque threshold on count as solid; what is fainter blends, back faces first, since over most of a
  // head they are the far side; below the discard threshold nothing is drawn, which spares the blend unit the empty
  // parts of the texture. Within a pass the index list's order is all the sorting there is: inner patches first.
  const bool double_sided = (material.flags & kMaterialDoubleSided) != 0;
  const GLenum unseen = double_sided ? GL_NONE : GL_BACK;
  const Pass passes[] = {
      {true, false, true, unseen, opaque, kNoLimit},
      {true, true, false, GL_FRONT, faintest, double_sided ? opaque : faintest},
      {true, true, false, GL_BACK, faintest, opaque},
      {false, false, true, unseen, solid, opaque},
  };
  const HairModel::IndexRange range = model.lods_[desc.lod];
  const auto count = static_cast<GLsizei>(range.count);
  const void* const first = reinterpret_cast<const void*>(std::size_t{range.first} * sizeof(std::uint32_t));
  const GlFunctions& gl = functions();
  for (const Pass& pass : passes) {
    if (pass.alpha_min >= pass.alpha_max) continue;
    set_pass_state(gl, pass);
    gl.UseProgram(pass.shaded ? shaded_program_ : depth_program_);
    gl.Uniform3f(pass.shaded ? shaded_alpha_range_ : depth_alpha_range_, pass.alpha_min, pass.alpha_max,
                 pass.blended ? 0.0f : 1.0f);
    gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, first);
    if (!desc.transparency) return;
  }
}

void HairRenderer::leave_initial_state(bool palette_was_in_block) const {
  const GlFunctions& gl = functions();
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ZERO);
  gl.Disable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.Disable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  if (!palette_was_in_block) {
    gl.ActiveTexture(GL_TEXTURE0 + kPaletteUnit);
    gl.BindTexture(GL_TEXTURE_2D, 0);
  }
  gl.ActiveTexture(GL_TEXTURE0 + kShiftMaskUnit);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.ActiveTexture(GL_TEXTURE0 + kBaseUnit);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kDrawIndex, 0);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kPaletteIndex, 0);
  gl.BindVertexArray(0);
  gl.UseProgram(0);
}

}  // namespace coif
