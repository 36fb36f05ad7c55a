#include "gl/shadow/shadow_state.h"
#include "gl/textures.h"

#include <cmath>
#include <cstdio>
#include <new>

namespace coif {
namespace {

constexpr std::uint32_t kLeastSize = 16, kMostSize = 4096;

bool is_valid(const ShadowDesc& desc) {
  return desc.technique != nullptr && desc.size >= kLeastSize && desc.size <= kMostSize && std::isfinite(desc.depth) &&
         desc.depth > 0.0f && std::isfinite(desc.bias) && desc.bias >= 0.0f &&
         desc.technique->choose_lookup(desc) != nullptr;
}

}  // namespace

const char* name_of(const ShadowTechnique& technique) { return technique.name; }

Pass caster_pass(const MaterialRecord& material, float alpha_min) {
  return {.shaded = false,
          .blended = false,
          .writes_depth = true,
          .culled = unseen_faces(material),
          .alpha_min = alpha_min,
          .alpha_max = kNoAlphaLimit};
}

GLuint make_depth_texture(const ShadowState& shadow) {
  const auto size = static_cast<GLsizei>(shadow.desc.size);
  return make_texture(shadow.gl(), shadow.desc.technique->depth_format, size, size);
}

GLuint make_framebuffer(const ShadowFunctions& functions, GLuint depth) {
  GLuint framebuffer = 0;
  functions.GenFramebuffers(1, &framebuffer);
  functions.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  functions.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  return framebuffer;
}

void set_slope_bias(const ShadowState& shadow, float texels) {
  texels > 0.0f ? shadow.gl().Enable(GL_POLYGON_OFFSET_FILL) : shadow.gl().Disable(GL_POLYGON_OFFSET_FILL);
  shadow.functions.PolygonOffset(texels, 0);
}

Status HairShadow::create(HairRenderer& hair_renderer, const GlLoader& loader, const ShadowDesc& desc) {
  static_assert(sizeof(ShadowState) <= kStateBytes && alignof(ShadowState) <= alignof(double));
  if (!hair_renderer.is_created()) return Status::kNotCreated;
  if (loader.get_proc == nullptr || !is_valid(desc)) return Status::kBadArgument;
  destroy();
  state_ = new (static_cast<void*>(room_)) ShadowState;
  ShadowState& state = *state_;
  ShadowFunctions& own = state.functions;
  RendererState& renderer = *RendererState::of(hair_renderer);
  if (const char* missing = own.load(loader)) {
    std::snprintf(renderer.failure, sizeof renderer.failure, "%s is missing; OpenGL ES 3.0 is needed", missing);
    return Status::kDriver;
  }
  const GlFunctions& gl = renderer.gl;
  state.renderer = &renderer;
  state.desc = desc;
  state.lookup = desc.technique->choose_lookup(desc);
  clear_errors(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  state.textures[kSolidTexture] = make_depth_texture(state);
  state.framebuffers[kSolidFramebuffer] = make_framebuffer(own, state.textures[kSolidTexture]);
  const bool is_whole =
      own.CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && desc.technique->make(state);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  own.BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (is_whole && gl.GetError() == GL_NO_ERROR) return Status::kOk;
  destroy();
  std::snprintf(renderer.failure, sizeof renderer.failure, "no memory for a shadow of %u x %u texels",
                unsigned{desc.size}, unsigned{desc.size});
  return Status::kDriver;
}

void HairShadow::destroy() {
  if (!is_created()) return;
  state_->gl().DeleteTextures(kTextures, state_->textures);
  state_->gl().DeleteTextures(ShadowState::kMostScratch, state_->scratch);
  state_->functions.DeleteFramebuffers(kShadowFramebuffers, state_->framebuffers);
  if (state_->program != 0) state_->gl().DeleteProgram(state_->program);
  const ShadowDesc desc = state_->desc;
  state_ = new (static_cast<void*>(room_)) ShadowState;
  state_->desc = desc;
}

bool HairShadow::is_created() const { return state_ != nullptr && state_->renderer != nullptr; }

Status HairShadow::begin(const Light& light, const ShadowBall& ball) {
  if (!is_created()) return Status::kNotCreated;
  ShadowState& state = *state_;
  ShadowView view;
  if (!aim(light, ball, state.desc.size, view)) return Status::kBadArgument;
  state.view = view;
  state.is_begun = true;
  const GlFunctions& gl = state.gl();
  const auto side = static_cast<GLsizei>(state.desc.size);
  state.functions.BindFramebuffer(GL_FRAMEBUFFER, state.framebuffers[kSolidFramebuffer]);
  state.functions.Viewport(0, 0, side, side);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_BLEND);
  set_slope_bias(state, state.desc.technique->caster_slope_bias);
  gl.Disable(GL_CULL_FACE);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  constexpr GLfloat kFar = 1;
  state.functions.ClearBufferfv(GL_DEPTH, 0, &kFar);
  return Status::kOk;
}

std::span<const char* const, 2> HairShadow::code() const {
  static constexpr const char* kNoCode[2] = {};
  return is_created() ? std::span(state_->lookup->pieces) : std::span(kNoCode);
}

const char* HairShadow::sampler(std::uint32_t texture) const {
  return is_created() && texture < kTextures ? state_->lookup->samplers[texture] : nullptr;
}

std::uint32_t HairShadow::texture(std::uint32_t texture) const {
  return state_ != nullptr ? state_->textures[texture] : 0;
}

std::uint64_t HairShadow::bytes() const {
  if (!is_created()) return 0;
  return state_->desc.technique->bytes(*state_);
}

const ShadowDesc& HairShadow::desc() const {
  static constexpr ShadowDesc kNothing{.technique = nullptr};
  return state_ != nullptr ? state_->desc : kNothing;
}

}  // namespace coif
