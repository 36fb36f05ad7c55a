#include "gl/draw_block.h"
#include "gl/gl_functions.h"
#include "gl/passes.h"
#include "gl/shader_variant.h"
#include "gl/transparency_mode.h"

#include <coif/renderer.h>

namespace coif {

const HairRenderer::Program* HairRenderer::find_program(std::uint32_t variant) const {
  for (const Program& program : std::span(programs_).first(program_count_)) {
    if (program.variant == variant) return &program;
  }
  return nullptr;
}

Status HairRenderer::build_missing(const PassList& passes, std::uint32_t needs, const MaterialRecord& material,
                                   Component component) {
  const GlFunctions& gl = functions();
  for (const Pass& pass : passes.passes()) {
    if (pass.code->storage_blocks > storage_blocks_) continue;  // Its mode has another way.
    const std::uint32_t variant = variant_of(pass, needs, material, component);
    if (find_program(variant) != nullptr) continue;
    if (program_count_ == kMaxPrograms) return Status::kDriver;
    const GLuint name = build_variant(gl, variant, pass, block_bytes_ / 16, failure_);
    if (name == 0) return Status::kDriver;
    programs_[program_count_++] = {variant, name, gl.GetUniformLocation(name, "alpha_range")};
  }
  return Status::kOk;
}

Status HairRenderer::prepare(const HairModel& model, const DrawDesc& desc) {
  if (!created_ || model.renderer_ != this) return Status::kNotCreated;
  const MaterialRecord& material = desc.material != nullptr ? *desc.material : model.material_;
  const bool is_good = is_valid(material) && desc.component <= Component::kDirection && desc.transparency != nullptr;
  if (!is_good) return Status::kBadArgument;
  const PassList passes = desc.transparency->plan_passes(material, {model.lowest_alpha_, model.highest_alpha_});
  return build_missing(passes, model.needs_, material, desc.component);
}

}  // namespace coif
