#include "gl/binding_points.h"
#include "gl/crowd_draw.h"
#include "gl/draw_block.h"
#include "gl/draw_state.h"
#include "gl/shadow/shadow_functions.h"
#include "gl/shadow/shadow_technique.h"

#include <coif/shadow.h>

namespace coif {
namespace {

const MaterialRecord& material_of(const ShadowCrowd& crowd) {
  return crowd.material != nullptr ? *crowd.material : crowd.model->material();
}

/// Close enough to the map that distances from it are small.
Vec3 origin_of(const double (&eye)[3]) { return {float(eye[0]), float(eye[1]), float(eye[2])}; }

void clear_stage(const ShadowFunctions& functions, ShadowFramebuffer framebuffer, bool has_far_layers) {
  constexpr GLfloat kFar = 1;
  constexpr GLfloat kNothing[4] = {};
  if (framebuffer == kFrontFramebuffer) functions.ClearBufferfv(GL_DEPTH, 0, &kFar);
  if (framebuffer != kLayersFramebuffer) return;
  functions.ClearBufferfv(GL_COLOR, 0, kNothing);
  if (has_far_layers) functions.ClearBufferfv(GL_COLOR, 1, kNothing);
}

}  // namespace

Status HairShadow::check(std::span<const ShadowCrowd> crowds) const {
  if (renderer_ == nullptr) return Status::kNotCreated;
  if (!is_begun_) return Status::kBadArgument;
  for (const ShadowCrowd& crowd : crowds) {
    if (crowd.model == nullptr || crowd.model->renderer_ != renderer_) return Status::kNotCreated;
    if (!is_valid(material_of(crowd))) return Status::kBadArgument;
    for (const HairInstance& instance : crowd.instances) {
      if (const Status status = crowd.model->check(instance); status != Status::kOk) return status;
    }
  }
  return Status::kOk;
}

Status HairShadow::build_missing(const ShadowCrowd& crowd) {
  const HairModel& model = *crowd.model;
  const ShadowTechnique& technique = *desc_.technique;
  for (const ShadowStage& stage : std::span(technique.stages).first(technique.stage_count)) {
    const PassList passes =
        stage.plan_passes(material_of(crowd), {model.lowest_alpha_, model.highest_alpha_}, *lookup_);
    const Status built = renderer_->build_missing(passes, model.needs_, material_of(crowd), Component::kAll);
    if (built != Status::kOk) return built;
  }
  return Status::kOk;
}

Status HairShadow::prepare(const HairModel& model, const MaterialRecord* material) {
  const ShadowCrowd crowd{&model, {}, material};
  if (renderer_ == nullptr || model.renderer_ != renderer_) return Status::kNotCreated;
  return is_valid(material_of(crowd)) ? build_missing(crowd) : Status::kBadArgument;
}

Status HairShadow::draw(std::span<const ShadowCrowd> crowds) {
  if (const Status checked = check(crowds); checked != Status::kOk) return checked;
  for (const ShadowCrowd& crowd : crowds) {
    if (const Status built = build_missing(crowd); built != Status::kOk) return built;
  }
  is_begun_ = false;
  const GlFunctions& gl = renderer_->functions();
  const auto side = static_cast<GLsizei>(desc_.size);
  functions().Viewport(0, 0, side, side);
  gl.Disable(GL_SCISSOR_TEST);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  Status status = Status::kOk;
  for (std::uint32_t i = 0; i < desc_.technique->stage_count && status == Status::kOk; ++i) {
    status = draw_stage(desc_.technique->stages[i], crowds);
  }
  set_slope_bias(gl, functions(), 0);
  functions().BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (textures_[kFrontTexture] != 0) unbind_texture(gl, kShadowUnit + kFrontTexture);
  gl.ActiveTexture(GL_TEXTURE0);
  return status;
}

Status HairShadow::draw_stage(const ShadowStage& stage, std::span<const ShadowCrowd> crowds) {
  const GlFunctions& gl = renderer_->functions();
  functions().BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[stage.framebuffer]);
  set_slope_bias(gl, functions(), stage.slope_bias);
  clear_stage(functions(), stage.framebuffer, textures_[kFarLayersTexture] != 0);
  for (const ShadowCrowd& crowd : crowds) {
    const HairModel& model = *crowd.model;
    // No way to draw soft hair is named: a program would hold it.
    const DrawDesc desc{.clip_from_world = {},
                        .eye = origin_of(view_.eye),
                        .lights = {},
                        .material = crowd.material,
                        .transparency = nullptr};
    DrawBlock block;
    const Status filled = fill_draw_block(desc, material_of(crowd), CrowdDraw::rows_of_head(model), block);
    if (filled != Status::kOk) return filled;
    clip_from_origin(desc.eye, block.clip_from_view);
    block.shadow = uniforms(desc.eye);
    CrowdDraw heads(*renderer_, model, crowd.instances, desc, block);
    renderer_->bind(model, nullptr);
    if (stage.framebuffer == kLayersFramebuffer) {
      bind_texture(gl, kShadowUnit + kFrontTexture, textures_[kFrontTexture]);
      gl.BlendFunc(GL_ONE, GL_ONE);
    }
    const bool is_drawn =
        heads.draw(stage.plan_passes(material_of(crowd), {model.lowest_alpha_, model.highest_alpha_}, *lookup_));
    renderer_->unbind(model, nullptr);
    if (!is_drawn) return Status::kDriver;
  }
  return Status::kOk;
}

}  // namespace coif
