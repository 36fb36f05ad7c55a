#include <coif/shadow.h>

#include "gl/gl_functions.h"
#include "gl/shadow/shadow_functions.h"
#include "gl/shadow/shadow_technique.h"

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

const char* load_shadow_functions(const GlLoader& loader, ShadowFunctions& functions) {
#define COIF_GL_LOAD(name)                                                                               \
  functions.name = reinterpret_cast<decltype(functions.name)>(loader.get_proc("gl" #name, loader.user)); \
  if (functions.name == nullptr) return "gl" #name;
  COIF_SHADOW_FUNCTIONS(COIF_GL_LOAD)
#undef COIF_GL_LOAD
  return nullptr;
}

GLuint make_depth_texture(const GlFunctions& gl, std::uint32_t size) {
  GLuint texture = 0;
  gl.GenTextures(1, &texture);
  gl.BindTexture(GL_TEXTURE_2D, texture);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  gl.TexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  gl.TexStorage2D(GL_TEXTURE_2D, 1, GL_DEPTH_COMPONENT24, static_cast<GLsizei>(size), static_cast<GLsizei>(size));
  return texture;
}

GLuint make_framebuffer(const ShadowFunctions& functions, GLuint depth) {
  GLuint framebuffer = 0;
  functions.GenFramebuffers(1, &framebuffer);
  functions.BindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  functions.FramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
  return framebuffer;
}

void set_slope_bias(const GlFunctions& gl, const ShadowFunctions& functions, float texels) {
  texels > 0.0f ? gl.Enable(GL_POLYGON_OFFSET_FILL) : gl.Disable(GL_POLYGON_OFFSET_FILL);
  functions.PolygonOffset(texels, 0);
}

const ShadowFunctions& HairShadow::functions() const {
  static_assert(sizeof(ShadowFunctions) <= kFunctionBytes);
  return *std::launder(reinterpret_cast<const ShadowFunctions*>(functions_));
}

Status HairShadow::create(HairRenderer& renderer, const GlLoader& loader, const ShadowDesc& desc) {
  if (!renderer.is_created()) return Status::kNotCreated;
  if (loader.get_proc == nullptr || !is_valid(desc)) return Status::kBadArgument;
  destroy();
  ShadowFunctions* const own = new (static_cast<void*>(functions_)) ShadowFunctions;
  if (const char* missing = load_shadow_functions(loader, *own)) {
    std::snprintf(renderer.failure_, sizeof renderer.failure_, "%s is missing; OpenGL ES 3.0 is needed", missing);
    return Status::kDriver;
  }
  const GlFunctions& gl = renderer.functions();
  renderer_ = &renderer;
  desc_ = desc;
  lookup_ = desc.technique->choose_lookup(desc);
  clear_errors(gl);
  gl.ActiveTexture(GL_TEXTURE0);
  textures_[kSolidTexture] = make_depth_texture(gl, desc.size);
  framebuffers_[kSolidFramebuffer] = make_framebuffer(*own, textures_[kSolidTexture]);
  const bool is_whole =
      own->CheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE && desc.technique->make(gl, *own, *this);
  gl.BindTexture(GL_TEXTURE_2D, 0);
  own->BindFramebuffer(GL_FRAMEBUFFER, 0);
  if (is_whole && gl.GetError() == GL_NO_ERROR) return Status::kOk;
  destroy();
  std::snprintf(renderer.failure_, sizeof renderer.failure_, "no memory for a shadow of %u x %u texels",
                unsigned{desc.size}, unsigned{desc.size});
  return Status::kDriver;
}

void HairShadow::destroy() {
  if (renderer_ == nullptr) return;
  renderer_->functions().DeleteTextures(kTextures, textures_);
  functions().DeleteFramebuffers(kFramebuffers, framebuffers_);
  for (std::uint32_t& texture : textures_) texture = 0;
  for (std::uint32_t& framebuffer : framebuffers_) framebuffer = 0;
  renderer_ = nullptr;
  lookup_ = nullptr;
  opacity_unit_ = 1;
  view_ = {};
  is_begun_ = false;
}

Status HairShadow::begin(const Light& light, const ShadowBall& ball) {
  if (renderer_ == nullptr) return Status::kNotCreated;
  View view;
  if (!aim(light, ball, desc_.size, view)) return Status::kBadArgument;
  view_ = view;
  is_begun_ = true;
  const GlFunctions& gl = renderer_->functions();
  const auto side = static_cast<GLsizei>(desc_.size);
  functions().BindFramebuffer(GL_FRAMEBUFFER, framebuffers_[kSolidFramebuffer]);
  functions().Viewport(0, 0, side, side);
  gl.Disable(GL_SCISSOR_TEST);
  gl.Disable(GL_BLEND);
  set_slope_bias(gl, functions(), desc_.technique->caster_slope_bias);
  gl.Disable(GL_CULL_FACE);
  gl.Enable(GL_DEPTH_TEST);
  gl.DepthFunc(GL_LEQUAL);
  gl.DepthMask(GL_TRUE);
  gl.ColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  constexpr GLfloat kFar = 1;
  functions().ClearBufferfv(GL_DEPTH, 0, &kFar);
  return Status::kOk;
}

std::span<const char* const, 2> HairShadow::code() const {
  static constexpr const char* kNoCode[2] = {};
  return lookup_ != nullptr ? std::span(lookup_->pieces) : std::span(kNoCode);
}

const char* HairShadow::sampler(std::uint32_t texture) const {
  return lookup_ != nullptr && texture < kTextures ? lookup_->samplers[texture] : nullptr;
}

std::uint64_t HairShadow::bytes() const {
  return renderer_ == nullptr ? 0 : std::uint64_t{desc_.size} * desc_.size * desc_.technique->texel_bytes(*this);
}

}  // namespace coif
