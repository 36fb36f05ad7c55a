#include "gl/binding_points.h"
#include "gl/draw_block.h"
#include "gl/gl_functions.h"
#include "gl/palette.h"
#include "gl/passes.h"
#include "gl/shader_variant.h"

#include <coif/renderer.h>

#include <cstddef>
#include <cstdint>

namespace coif {
namespace {

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

void bind_texture(const GlFunctions& gl, GLint unit, GLuint texture) {
  if (texture == 0) return;
  const auto place = static_cast<GLuint>(unit);
  gl.BindSampler(place, 0);  // one of the host's would override the texture's own filters
  gl.ActiveTexture(GL_TEXTURE0 + place);
  gl.BindTexture(GL_TEXTURE_2D, texture);
}

void unbind_texture(const GlFunctions& gl, GLint unit) {
  gl.ActiveTexture(GL_TEXTURE0 + static_cast<GLuint>(unit));
  gl.BindTexture(GL_TEXTURE_2D, 0);
}

bool is_skinned(std::uint32_t needs) { return (needs & (variant::kFourBones | variant::kOneBone)) != 0; }

}  // namespace

Status HairRenderer::draw(const HairModel& model, const DrawDesc& desc) {
  if (!created_ || model.renderer_ != this) return Status::kNotCreated;
  const bool rigid = !is_skinned(model.needs_);
  if (desc.palette.size() != model.bone_count_ && !(rigid && desc.palette.empty())) return Status::kSizeMismatch;
  const MaterialRecord& material = desc.material != nullptr ? *desc.material : model.material_;
  if (desc.lod >= model.lod_count_) return Status::kBadArgument;
  DrawBlock block;
  if (const Status status = fill_draw_block(desc, material, block); status != Status::kOk) return status;

  const PassList passes = plan_passes(material, {model.lowest_alpha_, model.highest_alpha_}, desc.transparency);
  if (passes.passes().empty()) return Status::kOk;
  const Status built = build_missing(passes, model.needs_, material, desc.component);
  if (built != Status::kOk) return built;
  send_uniforms(model, block, desc.palette);
  bind(model);
  draw_passes(model, passes, material, desc);
  leave_initial_state(model);
  return Status::kOk;
}

void HairRenderer::send_uniforms(const HairModel& model, const DrawBlock& block, std::span<const Mat34> palette) const {
  const GlFunctions& gl = functions();
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kDrawIndex, draw_buffer_);
  gl.BufferData(GL_UNIFORM_BUFFER, sizeof block, &block, GL_STREAM_DRAW);
  if (!is_skinned(model.needs_)) return;
  if ((model.needs_ & variant::kBonesInTexture) != 0) {
    send_palette_texture(gl, palette_texture_, palette);
  } else {
    send_palette_block(gl, palette_buffer_, palette);
  }
}

void HairRenderer::bind(const HairModel& model) const {
  const GlFunctions& gl = functions();
  gl.BindVertexArray(model.vertex_array_);
  bind_texture(gl, kShiftMaskUnit, model.shift_mask_texture_);
  bind_texture(gl, kBaseUnit, model.base_texture_);
  gl.BlendEquation(GL_FUNC_ADD);
  gl.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // premultiplied
  gl.FrontFace(GL_CCW);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);  // of cards in one place the later, outer one wins
}

void HairRenderer::draw_passes(const HairModel& model, const PassList& passes, const MaterialRecord& material,
                               const DrawDesc& desc) const {
  const HairModel::IndexRange range = model.lods_[desc.lod];
  const auto count = static_cast<GLsizei>(range.count);
  const void* const first = reinterpret_cast<const void*>(std::size_t{range.first} * sizeof(std::uint32_t));
  const GlFunctions& gl = functions();
  for (const Pass& pass : passes.passes()) {
    const Program& program = *find_program(variant_of(pass, model.needs_, material, desc.component));
    set_pass_state(gl, pass);
    gl.UseProgram(program.name);
    gl.Uniform3f(program.alpha_range, pass.alpha_min, pass.alpha_max, pass.blended ? 0.0f : 1.0f);
    gl.DrawElements(GL_TRIANGLES, count, GL_UNSIGNED_INT, first);
  }
}

void HairRenderer::leave_initial_state(const HairModel& model) const {
  const GlFunctions& gl = functions();
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  gl.Disable(GL_BLEND);
  gl.BlendFunc(GL_ONE, GL_ZERO);
  gl.Disable(GL_CULL_FACE);
  gl.CullFace(GL_BACK);
  gl.Disable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LESS);
  gl.DepthMask(GL_TRUE);
  if ((model.needs_ & variant::kBonesInTexture) != 0) unbind_texture(gl, kPaletteUnit);
  if (model.shift_mask_texture_ != 0) unbind_texture(gl, kShiftMaskUnit);
  if (model.base_texture_ != 0) unbind_texture(gl, kBaseUnit);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kDrawIndex, 0);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kPaletteIndex, 0);
  gl.BindVertexArray(0);
  gl.UseProgram(0);
}

}  // namespace coif
