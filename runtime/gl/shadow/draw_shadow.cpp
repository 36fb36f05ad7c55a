#include "gl/crowd_draw.h"
#include "gl/shadow/shadow_state.h"
#include "gl/textures.h"

namespace coif {
namespace {

const MaterialRecord& material_of(const ShadowCrowd& crowd) {
  return crowd.material != nullptr ? *crowd.material : crowd.model->material();
}

void clear_stage(const ShadowState& shadow, ShadowFramebuffer framebuffer) {
  constexpr GLfloat kFar = 1;
  constexpr GLfloat kNothing[4] = {};
  if (framebuffer == kFrontFramebuffer) shadow.functions.ClearBufferfv(GL_DEPTH, 0, &kFar);
  if (framebuffer != kLayersFramebuffer) return;
  for (GLint i = 0; i < shadow.layer_targets; ++i) shadow.functions.ClearBufferfv(GL_COLOR, i, kNothing);
}

/// Scales the projection so that the part fills the whole map. Column-major.
void clip_to_part(const MapPart& part, std::uint32_t size, float (&clip)[16]) {
  const float scale = float(size) / float(part.size);
  const float offset[2] = {scale - 1 - 2 * float(part.left) / float(part.size),
                           scale - 1 - 2 * float(part.bottom) / float(part.size)};
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 2; ++row) {
      clip[4 * column + row] = scale * clip[4 * column + row] + offset[row] * clip[4 * column + 3];
    }
  }
}

Status check(const ShadowState& shadow, std::span<const ShadowCrowd> crowds) {
  if (!shadow.is_begun) return Status::kBadArgument;
  for (const ShadowCrowd& crowd : crowds) {
    const ModelState* const model = crowd.model == nullptr ? nullptr : ModelState::of(*crowd.model);
    if (model == nullptr || model->renderer != shadow.renderer) return Status::kNotCreated;
    if (!is_valid(material_of(crowd))) return Status::kBadArgument;
    for (const HairInstance& instance : crowd.instances) {
      if (const Status status = check_instance(model->hair, instance); status != Status::kOk) return status;
    }
  }
  return Status::kOk;
}

Status build_missing(const ShadowState& shadow, const ShadowCrowd& crowd) {
  const ModelState& model = *ModelState::of(*crowd.model);
  const MaterialRecord& material = material_of(crowd);
  for (const ShadowStage& stage : shadow.stages()) {
    const PassList passes = stage.plan_passes(material, model.hair.alpha, *shadow.lookup);
    const Status built = shadow.renderer->build_missing(passes, model.needs, material, Component::kAll);
    if (built != Status::kOk) return built;
  }
  return Status::kOk;
}

Status draw_crowd(const ShadowState& shadow, const ShadowStage& stage, const ShadowCrowd& crowd, const MapPart& part) {
  const GlFunctions& gl = shadow.gl();
  const ModelState& model = *ModelState::of(*crowd.model);
  const MaterialRecord& material = material_of(crowd);
  DrawView view;  // The view's origin is so close to the map that distances from it are small.
  view.eye = {float(shadow.view.eye[0]), float(shadow.view.eye[1]), float(shadow.view.eye[2])};
  DrawBlock block;
  const Status filled = fill_draw_block(view, material, model.layout.rows_of_head, block);
  if (filled != Status::kOk) return filled;
  shadow.clip_from_origin(view.eye, block.clip_from_view);
  if (part.size > 0) clip_to_part(part, shadow.desc.size, block.clip_from_view);
  block.shadow = shadow.uniforms(view.eye);
  CrowdDraw heads(*shadow.renderer, model, crowd.instances, material, Component::kAll, view.eye, block);
  bind_model(gl, model);
  if (stage.before != nullptr) stage.before(shadow);
  if (stage.adds) gl.BlendFunc(GL_ONE, GL_ONE);
  const bool is_drawn = heads.draw(stage.plan_passes(material, model.hair.alpha, *shadow.lookup));
  unbind_model(gl, model);
  return is_drawn ? Status::kOk : Status::kDriver;
}

Status draw_stage(const ShadowState& shadow, const ShadowStage& stage, std::span<const ShadowCrowd> crowds) {
  shadow.functions.BindFramebuffer(GL_FRAMEBUFFER, shadow.framebuffers[stage.framebuffer]);
  set_slope_bias(shadow, stage.slope_bias);
  clear_stage(shadow, stage.framebuffer);
  return draw_hair(shadow, stage, crowds);
}

Status draw_stages(const ShadowState& shadow, std::span<const ShadowCrowd> crowds) {
  for (const ShadowStage& stage : shadow.stages()) {
    if (const Status drawn = draw_stage(shadow, stage, crowds); drawn != Status::kOk) return drawn;
  }
  return Status::kOk;
}

}  // namespace

Status draw_hair(const ShadowState& shadow, const ShadowStage& stage, std::span<const ShadowCrowd> crowds,
                 const MapPart& part) {
  for (const ShadowCrowd& crowd : crowds) {
    if (const Status drawn = draw_crowd(shadow, stage, crowd, part); drawn != Status::kOk) return drawn;
  }
  return Status::kOk;
}

Status HairShadow::prepare(const HairModel& model, const MaterialRecord* material) {
  const ModelState* const own = ModelState::of(model);
  if (!is_created() || own == nullptr || own->renderer != state_->renderer) return Status::kNotCreated;
  const ShadowCrowd crowd{&model, {}, material};
  return is_valid(material_of(crowd)) ? build_missing(*state_, crowd) : Status::kBadArgument;
}

Status HairShadow::draw(std::span<const ShadowCrowd> crowds) {
  if (!is_created()) return Status::kNotCreated;
  ShadowState& shadow = *state_;
  if (const Status checked = check(shadow, crowds); checked != Status::kOk) return checked;
  for (const ShadowCrowd& crowd : crowds) {
    if (const Status built = build_missing(shadow, crowd); built != Status::kOk) return built;
  }
  shadow.is_begun = false;
  const GlFunctions& gl = shadow.gl();
  const auto side = static_cast<GLsizei>(shadow.desc.size);
  shadow.functions.Viewport(0, 0, side, side);
  gl.Disable(GL_SCISSOR_TEST);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  const auto draw_technique = shadow.desc.technique->draw;
  const Status status = draw_technique == nullptr ? draw_stages(shadow, crowds) : draw_technique(shadow, crowds);
  set_slope_bias(shadow, 0);
  shadow.functions.Viewport(0, 0, side, side);
  shadow.functions.BindFramebuffer(GL_FRAMEBUFFER, 0);
  for (std::uint32_t i = 0; i < HairShadow::kTextures; ++i) {
    if (shadow.textures[i] != 0) unbind_texture(gl, kShadowUnit + GLint(i));
  }
  gl.ActiveTexture(GL_TEXTURE0);
  return status;
}

}  // namespace coif
