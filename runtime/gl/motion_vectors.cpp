#include "gl/crowd_draw.h"
#include "gl/renderer_state.h"
#include "gl/shader_programs.h"
#include "gl/textures.h"

#include <coif/motion_vectors.h>

#include <hair_shaders.h>

#include <cstring>

namespace coif {
namespace {

constexpr FragmentCode kMotionCode = {.id = 21,
                                      .keep = kShaderKeepRangeGlsl,
                                      .output = nullptr,
                                      .other = kShaderHairMotionFrag,
                                      .vertex_end = kShaderHairMotionVert};

PassList plan_motion(const MaterialRecord& material, const AlphaRange& texture, float alpha) {
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), {.shaded = false,
                                                 .blended = false,
                                                 .writes_depth = true,
                                                 .culled = unseen_faces(material),
                                                 .alpha_min = alpha,
                                                 .alpha_max = kNoAlphaLimit,
                                                 .code = &kMotionCode});
  return drawn;
}

DrawView view_of_frame(const float (&clip_from_world)[16], const Vec3& eye) {
  DrawView view;
  std::memcpy(view.clip_from_world, clip_from_world, sizeof clip_from_world);
  view.eye = eye;
  return view;
}

/// One call: its arguments, and the values derived from them.
struct MotionDraw {
  RendererState& renderer;
  const ModelState& model;
  const MaterialRecord& material;
  PassList passes;
  LastFrame last;

  MotionDraw(RendererState& state, const ModelState& of, const MotionDesc& desc)
      : renderer(state), model(of), material(desc.material != nullptr ? *desc.material : of.hair.material) {
    passes = plan_motion(material, model.hair.alpha, desc.alpha);
    last.layout = matrix_layout_of(model.hair, renderer.block_bytes, 2);
    last.needs = model.needs | variant::kMotion | (last.layout.bones_in_texture ? variant::kBonesInTexture : 0);
    last.eye = desc.previous_eye;
  }

  [[nodiscard]] bool has_room() const {
    const std::uint64_t bones = last.layout.bones_in_texture ? 2 * model.hair.bone_count * sizeof(Mat34) : 0;
    const StreamBuffer& stream = renderer.stream;
    return stream.aligned(sizeof(DrawBlock)) + stream.aligned(last.layout.batch_bytes()) + bones <= stream.most();
  }

  Status build() {
    const Status built = renderer.build_missing(passes, last.needs, material, Component::kAll);
    if (built != Status::kOk || !last.layout.bones_in_texture || model.motion_texture != 0) return built;
    renderer.gl.ActiveTexture(GL_TEXTURE0);
    model.motion_texture = make_palette_texture(renderer.gl, model.hair.bone_count, last.layout.frames);
    return Status::kOk;
  }
};

Status check(const DrawnHair& hair, std::span<const HairInstance> instances, std::span<const HairInstance> previous) {
  if (instances.size() != previous.size()) return Status::kSizeMismatch;
  for (std::size_t i = 0; i < instances.size(); ++i) {
    if (const Status now = check_instance(hair, instances[i]); now != Status::kOk) return now;
    const Status before = check_instance(hair, {previous[i].head, previous[i].palette, 0});
    if (before != Status::kOk) return before;
  }
  return Status::kOk;
}

bool is_good(const MotionDraw& draw, const MotionDesc& desc) {
  return desc.alpha >= 0.0f && desc.alpha <= 1.0f && is_valid(draw.material) && draw.has_room();
}

}  // namespace

Status prepare_motion_vectors(HairRenderer& hair_renderer, const HairModel& hair_model, const MotionDesc& desc) {
  RendererState* const renderer = RendererState::of(hair_renderer);
  const ModelState* const model = ModelState::of(hair_model);
  if (!hair_renderer.is_created() || model == nullptr || model->renderer != renderer) return Status::kNotCreated;
  MotionDraw draw(*renderer, *model, desc);
  return is_good(draw, desc) ? draw.build() : Status::kBadArgument;
}

Status draw_motion_vectors(HairRenderer& hair_renderer, const HairModel& hair_model,
                           std::span<const HairInstance> instances, std::span<const HairInstance> previous,
                           const MotionDesc& desc) {
  RendererState* const renderer = RendererState::of(hair_renderer);
  const ModelState* const model = ModelState::of(hair_model);
  if (!hair_renderer.is_created() || model == nullptr || model->renderer != renderer) return Status::kNotCreated;
  if (const Status checked = check(model->hair, instances, previous); checked != Status::kOk) return checked;
  MotionDraw draw(*renderer, *model, desc);
  if (!is_good(draw, desc)) return Status::kBadArgument;
  draw.last.instances = previous;
  const std::uint32_t rows = draw.last.layout.rows_of_head;
  DrawBlock block, before;
  Status filled = fill_draw_block(view_of_frame(desc.clip_from_world, desc.eye), draw.material, rows, block);
  if (filled != Status::kOk) return filled;
  filled =
      fill_draw_block(view_of_frame(desc.previous_clip_from_world, desc.previous_eye), draw.material, rows, before);
  if (filled != Status::kOk) return filled;
  std::memcpy(block.shadow.map_from_origin, before.clip_from_view, sizeof before.clip_from_view);

  if (const Status built = draw.build(); built != Status::kOk) return built;
  CrowdDraw crowd(*renderer, *model, instances, draw.material, Component::kAll, desc.eye, block, nullptr, &draw.last);
  bind_model(renderer->gl, *model);
  const bool is_drawn = crowd.draw(draw.passes);
  if (draw.last.layout.bones_in_texture) unbind_texture(renderer->gl, kPaletteUnit);
  unbind_model(renderer->gl, *model);
  return is_drawn ? Status::kOk : Status::kDriver;
}

}  // namespace coif
