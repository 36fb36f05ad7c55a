#include "gl/shader_programs.h"
#include "gl/shadow/shadow_state.h"
#include "gl/textures.h"

#include <hair_shaders.h>

#include <cstdio>

namespace coif {
namespace {

constexpr std::uint32_t kFewestPeels = 2, kUsualPeels = 6, kMostPeels = 6;
// The map is made part by part, so that the peeled layers take little extra memory.
constexpr std::uint32_t kPartsEachWay = 4, kSmallestPart = 64;
constexpr GLint kDepthUnit = 0, kAlphaUnit = kMostPeels, kUnpeeledUnit = 2 * kMostPeels, kSolidUnit = kUnpeeledUnit + 1;
static_assert(kSolidUnit < 16, "OpenGL ES 3.0 promises as many units");

std::uint32_t peels_of(const ShadowDesc& desc) { return desc.layers == 0 ? kUsualPeels : desc.layers; }

std::uint32_t part_size(const ShadowDesc& desc) {
  const std::uint32_t part = (desc.size + kPartsEachWay - 1) / kPartsEachWay;
  const std::uint32_t least = desc.size < kSmallestPart ? desc.size : kSmallestPart;
  return part < least ? least : part;
}

const FragmentCode kPeelCode = {.id = 16,
                                .keep = kShaderKeepRangeGlsl,
                                .output = nullptr,
                                .other = kShaderHairPeelFrag,
                                .samplers = {{"hair_shadow_peeled", kPeeledUnit}, {}}};
const FragmentCode kUnpeeledCode = {.id = 17,
                                    .keep = kShaderKeepRangeGlsl,
                                    .output = nullptr,
                                    .other = kShaderHairUnpeeledFrag,
                                    .samplers = {{"hair_shadow_peeled", kPeeledUnit}, {}}};

constexpr ShadowLookup kStepsLookup = {
    4, {"", kShaderHairShadowStepsGlsl}, {"hair_shadow_solid", nullptr, "hair_shadow_steps"}, uniforms_of};

const ShadowLookup* choose_steps(const ShadowDesc& desc) {
  const std::uint32_t peels = peels_of(desc);
  return peels < kFewestPeels || peels > kMostPeels ? nullptr : &kStepsLookup;
}

PassList plan_peel(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&) {
  Pass pass = caster_pass(material, material.discard_threshold);
  pass.code = &kPeelCode;
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

PassList plan_unpeeled(const MaterialRecord& material, const AlphaRange& texture, const ShadowLookup&) {
  Pass pass = caster_pass(material, material.discard_threshold);
  pass.code = &kUnpeeledCode;
  pass.blended = true;
  pass.writes_depth = false;
  PassList drawn;
  drawn.add_for(drawn_alpha(material, texture), pass);
  return drawn;
}

/// The textures of the part that is being made.
struct Peeled {
  explicit Peeled(const ShadowState& shadow) : depth(shadow.scratch), alpha(depth + kMostPeels) {}
  const GLuint* depth;
  const GLuint* alpha;  ///< After the last layer: the opacity of the hair that is not peeled.
};

bool build_program_of_steps(ShadowState& shadow) {
  char define[48];
  std::snprintf(define, sizeof define, "#define COIF_SHADOW_PEELS %u\n", unsigned{peels_of(shadow.desc)});
  const char* const vertex[] = {kShaderHairStepsVert};
  const char* const fragment[] = {define, kShaderHairStepsFrag};
  const GlFunctions& gl = shadow.gl();
  shadow.program = build_program(gl, kGlsl300, vertex, fragment, shadow.renderer->failure);
  if (shadow.program == 0) return false;
  gl.UseProgram(shadow.program);
  const auto set_unit = [&](const char* name, GLint unit) {
    gl.Uniform1i(gl.GetUniformLocation(shadow.program, name), unit);
  };
  set_unit("hair_shadow_solid", kSolidUnit);
  set_unit("hair_unpeeled", kUnpeeledUnit);
  for (std::uint32_t i = 0; i < peels_of(shadow.desc); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "hair_peeled_depth[%u]", unsigned{i});
    set_unit(name, kDepthUnit + GLint(i));
    std::snprintf(name, sizeof name, "hair_peeled_alpha[%u]", unsigned{i});
    set_unit(name, kAlphaUnit + GLint(i));
  }
  gl.UseProgram(0);
  return true;
}

bool make_scratch(ShadowState& shadow) {
  const auto size = static_cast<GLsizei>(part_size(shadow.desc));
  for (std::uint32_t i = 0; i < peels_of(shadow.desc); ++i) {
    shadow.scratch[i] = make_texture(shadow.gl(), GL_DEPTH_COMPONENT16, size, size);
    shadow.scratch[kMostPeels + i] = make_texture(shadow.gl(), GL_R8, size, size);
  }
  shadow.scratch[kUnpeeledUnit] = make_texture(shadow.gl(), GL_R8, size, size);
  const Peeled peeled(shadow);
  const ShadowFunctions& functions = shadow.functions;
  shadow.framebuffers[kFrontFramebuffer] = make_framebuffer(functions, peeled.depth[0]);
  functions.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, peeled.alpha[0], 0);
  return functions.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool make_steps(ShadowState& shadow) {
  const ShadowFunctions& functions = shadow.functions;
  const auto size = static_cast<GLsizei>(shadow.desc.size);
  shadow.textures[kLayersTexture] = make_texture(shadow.gl(), GL_R32UI, size, size);
  functions.GenFramebuffers(1, &shadow.framebuffers[kLayersFramebuffer]);
  functions.BindFramebuffer(GL_FRAMEBUFFER, shadow.framebuffers[kLayersFramebuffer]);
  functions.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, shadow.textures[kLayersTexture],
                                 0);
  if (functions.CheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return false;
  return make_scratch(shadow) && build_program_of_steps(shadow);
}

constexpr ShadowStage kPeelStage = {kFrontFramebuffer, 0, false, plan_peel};
constexpr ShadowStage kUnpeeledStage = {kFrontFramebuffer, 0, true, plan_unpeeled};

/// Makes one part of the map after the other.
class Peeling {
 public:
  Peeling(const ShadowState& shadow, std::span<const ShadowCrowd> crowds)
      : shadow_(shadow),
        functions_(shadow.functions),
        crowds_(crowds),
        peeled_(shadow),
        peels_(peels_of(shadow.desc)),
        part_{0, 0, part_size(shadow.desc)} {}

  Status run() {
    Status status = Status::kOk;
    for (part_.bottom = 0; part_.bottom < shadow_.desc.size; part_.bottom += part_.size) {
      for (part_.left = 0; part_.left < shadow_.desc.size; part_.left += part_.size) {
        if (status == Status::kOk) status = make_part();
      }
    }
    return status;
  }

 private:
  Status make_part() {
    functions_.BindFramebuffer(GL_FRAMEBUFFER, shadow_.framebuffers[kFrontFramebuffer]);
    functions_.Viewport(0, 0, GLsizei(part_.size), GLsizei(part_.size));
    clear_first();
    Status status = Status::kOk;
    for (std::uint32_t i = 0; i < peels_ && status == Status::kOk; ++i) status = peel(i);
    if (status == Status::kOk) status = add_unpeeled();
    unbind_texture(shadow_.gl(), kPeeledUnit);
    if (status == Status::kOk) compress();
    return status;
  }

  void attach(GLuint depth, GLuint color) const {
    functions_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    functions_.FramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
  }

  void clear(GLfloat depth) const {
    constexpr GLfloat kNothing[4] = {};
    functions_.ClearBufferfv(GL_DEPTH, 0, &depth);
    functions_.ClearBufferfv(GL_COLOR, 0, kNothing);
  }

  /// Clears the depth that the first layer lies behind.
  void clear_first() const {
    attach(peeled_.depth[peels_ - 1], peeled_.alpha[peels_ - 1]);
    clear(0);
  }

  Status peel(std::uint32_t layer) const {
    attach(peeled_.depth[layer], peeled_.alpha[layer]);
    clear(1);
    bind_texture(shadow_.gl(), kPeeledUnit, peeled_.depth[layer > 0 ? layer - 1 : peels_ - 1]);
    return draw_hair(shadow_, kPeelStage, crowds_, part_);
  }

  /// Draws without a depth buffer, so all hair counts.
  Status add_unpeeled() const {
    attach(0, shadow_.scratch[kUnpeeledUnit]);
    clear(1);
    bind_texture(shadow_.gl(), kPeeledUnit, peeled_.depth[peels_ - 1]);
    return draw_hair(shadow_, kUnpeeledStage, crowds_, part_);
  }

  void bind_all(bool binds) const {
    const GlFunctions& gl = shadow_.gl();
    const auto one = [&](GLint unit, GLuint texture) {
      binds ? bind_texture(gl, unit, texture) : unbind_texture(gl, unit);
    };
    for (std::uint32_t i = 0; i < peels_; ++i) {
      one(kDepthUnit + GLint(i), peeled_.depth[i]);
      one(kAlphaUnit + GLint(i), peeled_.alpha[i]);
    }
    one(kUnpeeledUnit, shadow_.scratch[kUnpeeledUnit]);
    one(kSolidUnit, shadow_.textures[kSolidTexture]);
  }

  void compress() const {
    const GlFunctions& gl = shadow_.gl();
    functions_.BindFramebuffer(GL_FRAMEBUFFER, shadow_.framebuffers[kLayersFramebuffer]);
    functions_.Viewport(GLint(part_.left), GLint(part_.bottom), GLsizei(part_.size), GLsizei(part_.size));
    bind_all(true);
    gl.UseProgram(shadow_.program);
    const ShadowUniforms uniforms = shadow_.uniforms({});
    const auto set = [&](const char* name, const float(&value)[4]) {
      functions_.Uniform4f(gl.GetUniformLocation(shadow_.program, name), value[0], value[1], value[2], value[3]);
    };
    set("shadow_depth", uniforms.depth);
    set("shadow_map", uniforms.map);
    set("peeled_corner", {float(part_.left), float(part_.bottom), 0, 0});
    functions_.DrawArrays(GL_TRIANGLES, 0, 3);
    gl.UseProgram(0);
    bind_all(false);
  }

  const ShadowState& shadow_;
  const ShadowFunctions& functions_;
  std::span<const ShadowCrowd> crowds_;
  Peeled peeled_;
  std::uint32_t peels_;
  MapPart part_;
};

Status draw_steps(const ShadowState& shadow, std::span<const ShadowCrowd> crowds) {
  const GlFunctions& gl = shadow.gl();
  set_slope_bias(shadow, 0);
  gl.Disable(GL_BLEND);
  gl.Disable(GL_CULL_FACE);
  gl.Disable(GL_DEPTH_TEST);
  return Peeling(shadow, crowds).run();
}

std::uint64_t bytes_of_steps(const ShadowState& shadow) {
  const std::uint64_t part = part_size(shadow.desc);
  return texels_times(shadow.desc, 2 + 4) + part * part * (3 * peels_of(shadow.desc) + 1);
}

}  // namespace

const ShadowTechnique kDeepShadow = {.name = "deep-shadow",
                                     .caster_slope_bias = 1,
                                     .texel_bias = 0.5f,
                                     .depth_format = GL_DEPTH_COMPONENT16,
                                     .stage_count = 2,
                                     .stages = {kPeelStage, kUnpeeledStage},
                                     .choose_lookup = choose_steps,
                                     .make = make_steps,
                                     .bytes = bytes_of_steps,
                                     .draw = draw_steps};

}  // namespace coif
