#include "gl/binding_points.h"
#include "gl/crowd_draw.h"
#include "gl/draw_block.h"
#include "gl/draw_state.h"
#include "gl/gl_functions.h"
#include "gl/shader_variant.h"
#include "gl/shadow/shadow_lookup.h"
#include "gl/transparency_mode.h"

#include <coif/renderer.h>

namespace coif {

Status HairModel::check(const HairInstance& instance) const {
  const bool is_rigid = (needs_ & (variant::kFourBones | variant::kOneBone)) == 0;
  if (instance.palette.size() != bone_count_ && !(is_rigid && instance.palette.empty())) return Status::kSizeMismatch;
  if (instance.lod >= lod_count_) return Status::kBadArgument;
  return is_valid(instance.head) ? Status::kOk : Status::kBadPose;
}

Status HairRenderer::draw(const HairModel& model, std::span<const HairInstance> instances, const DrawDesc& desc) {
  if (!created_ || model.renderer_ != this) return Status::kNotCreated;
  if (desc.transparency == nullptr) return Status::kBadArgument;
  if (desc.shadow != nullptr && (!desc.shadow->is_ready(*this) || desc.shadowed_light >= desc.lights.size())) {
    return Status::kBadArgument;
  }
  for (const HairInstance& instance : instances) {
    if (const Status status = model.check(instance); status != Status::kOk) return status;
  }
  const MaterialRecord& material = desc.material != nullptr ? *desc.material : model.material_;
  DrawBlock block;
  const Status filled = fill_draw_block(desc, material, CrowdDraw::rows_of_head(model), block);
  if (filled != Status::kOk) return filled;

  PassList passes = desc.transparency->plan_passes(material, {model.lowest_alpha_, model.highest_alpha_});
  if (desc.shadow != nullptr) {
    const ShadowLookup& lookup = *desc.shadow->lookup_;
    passes.add_shadow(lookup);
    block.shadow = lookup.uniforms(*desc.shadow, desc.eye);
    block.shadow.map[3] = static_cast<float>(desc.shadowed_light);
  }
  const Status built = build_missing(passes, model.needs_, material, desc.component);
  if (built != Status::kOk) return built;
  CrowdDraw crowd(*this, model, instances, desc, block);
  bind(model, desc.shadow);
  const auto draw_mode = desc.transparency->draw;
  const bool is_drawn =
      draw_mode == nullptr
          ? crowd.draw(passes)
          : draw_mode({functions(), crowd, passes, loader_, mode_memory_, storage_blocks_, list_bytes_, failure_});
  unbind(model, desc.shadow);
  return is_drawn ? Status::kOk : Status::kDriver;
}

void HairRenderer::bind(const HairModel& model, const HairShadow* shadow) const {
  const GlFunctions& gl = functions();
  for (std::uint32_t i = 0; shadow != nullptr && i < HairShadow::kTextures; ++i) {
    bind_texture(gl, kShadowUnit + GLint(i), shadow->textures_[i]);
  }
  gl.BindVertexArray(model.vertex_array_);
  bind_texture(gl, kShiftMaskUnit, model.shift_mask_texture_);
  bind_texture(gl, kBaseUnit, model.base_texture_);
  set_draw_state(gl);
}

void HairRenderer::unbind(const HairModel& model, const HairShadow* shadow) const {
  const GlFunctions& gl = functions();
  for (std::uint32_t i = 0; shadow != nullptr && i < HairShadow::kTextures; ++i) {
    if (shadow->textures_[i] != 0) unbind_texture(gl, kShadowUnit + GLint(i));
  }
  leave_draw_state(gl);
  if (model.palette_texture_ != 0) unbind_texture(gl, kPaletteUnit);
  if (model.shift_mask_texture_ != 0) unbind_texture(gl, kShiftMaskUnit);
  if (model.base_texture_ != 0) unbind_texture(gl, kBaseUnit);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kDrawIndex, 0);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kPaletteIndex, 0);
  gl.BindVertexArray(0);
  gl.UseProgram(0);
}

}  // namespace coif
