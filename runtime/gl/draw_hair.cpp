#include "gl/crowd_draw.h"
#include "gl/renderer_state.h"
#include "gl/shader_programs.h"
#include "gl/shadow/shadow_state.h"
#include "gl/textures.h"

namespace coif {
namespace {

const MaterialRecord& material_of(const DrawDesc& desc, const ModelState& model) {
  return desc.material != nullptr ? *desc.material : model.hair.material;
}

DrawView view_of(const DrawDesc& desc) {
  DrawView view;
  for (int i = 0; i < 16; ++i) view.clip_from_world[i] = desc.clip_from_world[i];
  view.eye = desc.eye;
  view.lights = desc.lights;
  view.sky = desc.sky;
  view.component = desc.component;
  view.framebuffer_is_srgb = desc.framebuffer_is_srgb;
  return view;
}

bool can_order(const DrawDesc& desc, const RendererState& renderer, const ModelState& model) {
  if (desc.order == nullptr) return true;
  if (renderer.webgl != nullptr) return false;
  return desc.order->fits(model.hair) && bytes_of_ordered_head(renderer, model) <= renderer.stream.most();
}

void bind_shadow(const GlFunctions& gl, const ShadowState& shadow) {
  for (std::uint32_t i = 0; i < HairShadow::kTextures; ++i)
    bind_texture(gl, kShadowUnit + GLint(i), shadow.textures[i]);
}

void unbind_shadow(const GlFunctions& gl, const ShadowState& shadow) {
  for (std::uint32_t i = 0; i < HairShadow::kTextures; ++i) {
    if (shadow.textures[i] != 0) unbind_texture(gl, kShadowUnit + GLint(i));
  }
}

}  // namespace

const RendererState::Program* RendererState::find_program(std::uint32_t variant) const {
  for (const Program& program : std::span(programs).first(program_count)) {
    if (program.variant == variant) return &program;
  }
  return nullptr;
}

bool RendererState::takes(const FragmentCode& code) const {
  using SampleMask = FragmentCode::SampleMask;
  const SampleMask unwanted = has_sample_masks ? SampleMask::kMissing : SampleMask::kWritten;
  return code.storage_blocks <= storage_blocks && code.sample_mask != unwanted;
}

Status RendererState::build_missing(const PassList& passes, std::uint32_t needs, const MaterialRecord& material,
                                    Component component) {
  for (const Pass& pass : passes.passes()) {
    if (!takes(*pass.code)) continue;
    const std::uint32_t variant = variant_of(pass, needs, material, component);
    if (find_program(variant) != nullptr) continue;
    if (program_count == kMaxPrograms) return Status::kDriver;
    const GLuint name = build_variant(gl, variant, pass, block_bytes / 16, failure);
    if (name == 0) return Status::kDriver;
    programs[program_count++] = {variant, name, gl.GetUniformLocation(name, "alpha_range")};
  }
  return Status::kOk;
}

Status HairRenderer::prepare(const HairModel& hair_model, const DrawDesc& desc) {
  const ModelState* const model = ModelState::of(hair_model);
  if (!is_created() || model == nullptr || model->renderer != state_) return Status::kNotCreated;
  const MaterialRecord& material = material_of(desc, *model);
  const bool is_good = is_valid(material) && desc.component <= Component::kDirection && desc.transparency != nullptr;
  if (!is_good) return Status::kBadArgument;
  const PassList passes = desc.transparency->plan_passes(material, model->hair.alpha);
  return state_->build_missing(passes, model->needs, material, desc.component);
}

Status HairRenderer::draw(const HairModel& hair_model, std::span<const HairInstance> instances, const DrawDesc& desc) {
  const ModelState* const model = ModelState::of(hair_model);
  if (!is_created() || model == nullptr || model->renderer != state_) return Status::kNotCreated;
  if (desc.transparency == nullptr) return Status::kBadArgument;
  const ShadowState* const shadow = desc.shadow == nullptr ? nullptr : ShadowState::of(*desc.shadow);
  if (desc.shadow != nullptr) {
    const bool is_ready = shadow != nullptr && shadow->renderer == state_ && shadow->view.radius > 0;
    if (!is_ready || desc.shadowed_light >= desc.lights.size()) return Status::kBadArgument;
  }
  if (!can_order(desc, *state_, *model)) return Status::kBadArgument;
  for (const HairInstance& instance : instances) {
    if (const Status status = check_instance(model->hair, instance); status != Status::kOk) return status;
  }
  const MaterialRecord& material = material_of(desc, *model);
  DrawBlock block;
  const Status filled = fill_draw_block(view_of(desc), material, model->layout.rows_of_head, block);
  if (filled != Status::kOk) return filled;

  PassList passes = desc.transparency->plan_passes(material, model->hair.alpha);
  if (shadow != nullptr) {
    passes.add_shadow(*shadow->lookup);
    block.shadow = shadow->lookup->uniforms(*shadow, desc.eye);
    block.shadow.map[3] = static_cast<float>(desc.shadowed_light);
  }
  const Status built = state_->build_missing(passes, model->needs, material, desc.component);
  if (built != Status::kOk) return built;
  const GlFunctions& gl = state_->gl;
  CrowdDraw crowd(*state_, *model, instances, material, desc.component, desc.eye, block, desc.order);
  if (shadow != nullptr) bind_shadow(gl, *shadow);
  bind_model(gl, *model);
  const auto draw_mode = desc.transparency->draw;
  const bool is_drawn = draw_mode == nullptr ? crowd.draw(passes) : draw_mode({*state_, crowd, passes});
  if (shadow != nullptr) unbind_shadow(gl, *shadow);
  unbind_model(gl, *model);
  return is_drawn ? Status::kOk : Status::kDriver;
}

void bind_model(const GlFunctions& gl, const ModelState& model) {
  gl.BindVertexArray(model.vertex_array);
  bind_texture(gl, kStrandUnit, model.strand_texture);
  bind_texture(gl, kNormalUnit, model.normal_texture);
  bind_texture(gl, kShiftMaskUnit, model.shift_mask_texture);
  bind_texture(gl, kBaseUnit, model.base_texture);
  set_draw_state(gl);
}

void unbind_model(const GlFunctions& gl, const ModelState& model) {
  leave_draw_state(gl);
  if (model.palette_texture != 0) unbind_texture(gl, kPaletteUnit);
  if (model.strand_texture != 0) unbind_texture(gl, kStrandUnit);
  if (model.normal_texture != 0) unbind_texture(gl, kNormalUnit);
  if (model.shift_mask_texture != 0) unbind_texture(gl, kShiftMaskUnit);
  if (model.base_texture != 0) unbind_texture(gl, kBaseUnit);
  gl.ActiveTexture(GL_TEXTURE0);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kDrawIndex, 0);
  gl.BindBufferBase(GL_UNIFORM_BUFFER, kPaletteIndex, 0);
  gl.BindVertexArray(0);
  gl.UseProgram(0);
}

}  // namespace coif
