// What a shadow takes of the host's OpenGL, what it leaves, and what it refuses.

#include "gl/shadow_scene.h"

#include <GLES3/gl3.h>

#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace coif::shadow_state_test {

GLint query(GLenum name) {
  GLint value[4] = {};
  glGetIntegerv(name, value);
  return value[0];
}

// After HairShadow::draw(), as a context begins with them.
const std::vector<std::pair<GLenum, GLint>> kLeft = {
    {GL_CURRENT_PROGRAM, 0},
    {GL_VERTEX_ARRAY_BINDING, 0},
    {GL_ACTIVE_TEXTURE, GL_TEXTURE0},
    {GL_UNIFORM_BUFFER_BINDING, 0},
    {GL_DRAW_FRAMEBUFFER_BINDING, 0},
    {GL_READ_FRAMEBUFFER_BINDING, 0},
    {GL_SCISSOR_TEST, 0},
    {GL_POLYGON_OFFSET_FILL, 0},
    {GL_POLYGON_OFFSET_FACTOR, 0},
    {GL_BLEND, 0},
    {GL_BLEND_SRC_RGB, GL_ONE},
    {GL_BLEND_DST_RGB, GL_ZERO},
    {GL_BLEND_EQUATION_RGB, GL_FUNC_ADD},
    {GL_DEPTH_TEST, 0},
    {GL_DEPTH_FUNC, GL_LESS},
    {GL_DEPTH_WRITEMASK, GL_TRUE},
    {GL_CULL_FACE, 0},
    {GL_COLOR_WRITEMASK, GL_TRUE},
};

// And of these it knows nothing.
const std::vector<GLenum> kForeign = {GL_RENDERBUFFER_BINDING,
                                      GL_ARRAY_BUFFER_BINDING,
                                      GL_PIXEL_PACK_BUFFER_BINDING,
                                      GL_PIXEL_UNPACK_BUFFER_BINDING,
                                      GL_STENCIL_TEST,
                                      GL_STENCIL_WRITEMASK,
                                      GL_SAMPLE_ALPHA_TO_COVERAGE,
                                      GL_DITHER,
                                      GL_TEXTURE_BINDING_CUBE_MAP,
                                      GL_PACK_ALIGNMENT,
                                      GL_COLOR_CLEAR_VALUE,
                                      GL_DEPTH_CLEAR_VALUE};

void set_hostile_state() {
  glEnable(GL_SCISSOR_TEST);
  glScissor(0, 0, 3, 3);
  glEnable(GL_BLEND);
  glBlendFunc(GL_DST_COLOR, GL_ZERO);
  glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
  glDepthFunc(GL_NEVER);
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT_AND_BACK);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  glClearColor(1, 1, 1, 1);
  glClearDepthf(0.25f);
  glActiveTexture(GL_TEXTURE6);
}

class ShadowState : public ShadowScene {
 protected:
  void SetUp() override {
    ShadowScene::SetUp();
    if (!context_) return;
    ASSERT_EQ(caster_.upload(renderer_, *DrawnAsset(card_contents(std::array{card_above(0.5f, 0.5)}))), Status::kOk);
  }
  void TearDown() override {
    caster_.destroy();
    ShadowScene::TearDown();
  }
  [[nodiscard]] ShadowCrowd crowd() const { return {&caster_, {&head_, 1}, nullptr}; }
  void create(HairShadow& shadow, const ShadowDesc& desc) {
    ASSERT_EQ(shadow.create(renderer_, calls_->loader(), desc), Status::kOk) << renderer_.failure();
  }

  HairModel caster_;
  const HeadDraw rest_ = at_rest();
  const HairInstance head_{rest_.head, rest_.palette, 0};
};

TEST_F(ShadowState, IsLeftAsPromised) {
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    create(shadow, desc);
    EXPECT_EQ(query(GL_DRAW_FRAMEBUFFER_BINDING), 0);
    ASSERT_EQ(shadow.begin(lamp(), kBall), Status::kOk);
    set_hostile_state();
    const ShadowCrowd one = crowd();
    ASSERT_EQ(shadow.draw({&one, 1}), Status::kOk);
    for (const auto& [name, value] : kLeft) EXPECT_EQ(query(name), value) << std::hex << name;
    EXPECT_EQ(query(GL_VIEWPORT), 0);
    for (GLuint unit = 0; unit < 14; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      EXPECT_EQ(query(GL_TEXTURE_BINDING_2D), 0) << unit;
      EXPECT_EQ(query(GL_SAMPLER_BINDING), 0) << unit;
    }
    bind_target();
    HeadDraw draw = rest_;
    const Light light = lamp();
    draw.lights = {&light, 1};
    draw.shadow = &shadow;
    ASSERT_EQ(draw_head(renderer_, receiver_, draw), Status::kOk);
    for (GLuint unit = 0; unit < 14; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      EXPECT_EQ(query(GL_TEXTURE_BINDING_2D), 0) << unit << " after the hair that is shaded";
    }
    shadow.destroy();
  }
}

TEST_F(ShadowState, DoesNotDependOnWhatTheHostLeft) {
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    create(shadow, desc);
    cast(shadow, std::array{card_above(0.5f, 0.7)});
    const double expected = light_at_middle(shadow);
    set_hostile_state();
    GLuint sampler = 0;
    glGenSamplers(1, &sampler);
    glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    for (GLuint unit = 0; unit < 14; ++unit) glBindSampler(unit, sampler);
    cast(shadow, std::array{card_above(0.5f, 0.7)});
    glClearDepthf(1);
    EXPECT_EQ(light_at_middle(shadow), expected);
    glDeleteSamplers(1, &sampler);
    shadow.destroy();
  }
}

TEST_F(ShadowState, OfTheHostIsUntouched) {
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    create(shadow, desc);
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glClearColor(0.5f, 0.25f, 0.75f, 1);
    glClearDepthf(0.5f);
    std::vector<GLint> before;
    for (const GLenum name : kForeign) before.push_back(query(name));
    ASSERT_EQ(shadow.begin(lamp(), kBall), Status::kOk);
    const ShadowCrowd one = crowd();
    ASSERT_EQ(shadow.draw({&one, 1}), Status::kOk);
    for (std::size_t i = 0; i < kForeign.size(); ++i)
      EXPECT_EQ(query(kForeign[i]), before[i]) << std::hex << kForeign[i];
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    shadow.destroy();
  }
}

TEST_F(ShadowState, BeginsWithADepthBufferForTheHostsCasters) {
  HairShadow shadow;
  create(shadow, {.size = 64});
  set_hostile_state();
  ASSERT_EQ(shadow.begin(lamp(), kBall), Status::kOk);
  GLint viewport[4] = {};
  glGetIntegerv(GL_VIEWPORT, viewport);
  EXPECT_EQ(viewport[2], 64);
  EXPECT_EQ(viewport[3], 64);
  EXPECT_EQ(glCheckFramebufferStatus(GL_DRAW_FRAMEBUFFER), GLenum{GL_FRAMEBUFFER_COMPLETE});
  EXPECT_EQ(query(GL_DEPTH_TEST), 1);
  EXPECT_EQ(query(GL_DEPTH_WRITEMASK), 1);
  EXPECT_EQ(query(GL_SCISSOR_TEST), 0);
  EXPECT_EQ(query(GL_CULL_FACE), 0);
  EXPECT_EQ(query(GL_BLEND), 0);
  ASSERT_EQ(shadow.draw({}), Status::kOk);
  shadow.destroy();
}

TEST_F(ShadowState, RefusesWhatItCannotDraw) {
  HairShadow shadow;
  const ShadowCrowd one = crowd();
  EXPECT_EQ(shadow.begin(lamp(), kBall), Status::kNotCreated);
  EXPECT_EQ(shadow.draw({&one, 1}), Status::kNotCreated);
  HairRenderer none;
  EXPECT_EQ(shadow.create(none, calls_->loader()), Status::kNotCreated);
  EXPECT_EQ(shadow.create(renderer_, {}), Status::kBadArgument);
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (const ShadowDesc& bad : {ShadowDesc{.technique = nullptr},
                                {.size = 15},
                                {.size = 4097},
                                {.layers = 7},
                                {.depth = 0},
                                {.bias = -1},
                                {.bias = kNan}}) {
    EXPECT_EQ(shadow.create(renderer_, calls_->loader(), bad), Status::kBadArgument);
  }
  EXPECT_FALSE(shadow.is_created());

  create(shadow, {.size = 64});
  EXPECT_EQ(shadow.draw({&one, 1}), Status::kBadArgument) << "without begin()";
  Light light = lamp();
  light.from = {};
  EXPECT_EQ(shadow.begin(light, kBall), Status::kBadArgument) << "no direction";
  EXPECT_EQ(shadow.begin(lamp(), {{0, 0, 0}, 0}), Status::kBadArgument);
  EXPECT_EQ(shadow.begin(lamp(), {{0, std::nan(""), 0}, 1}), Status::kBadArgument);
  light = {Light::Kind::kPoint, {0.5f, 0.5f, 0.5f}};
  EXPECT_EQ(shadow.begin(light, kBall), Status::kBadArgument) << "a lamp within the ball";
  HeadDraw draw = rest_;
  light = lamp();
  draw.lights = {&light, 1};
  draw.shadow = &shadow;
  EXPECT_EQ(draw_head(renderer_, receiver_, draw), Status::kBadArgument) << "it has no map yet";

  ASSERT_EQ(shadow.begin(lamp(), kBall), Status::kOk);
  HairInstance bad = head_;
  bad.head.position[0] = std::nan("");
  const ShadowCrowd nowhere{&caster_, {&bad, 1}, nullptr}, no_model{nullptr, {&head_, 1}, nullptr};
  EXPECT_EQ(shadow.draw({&nowhere, 1}), Status::kBadPose);
  EXPECT_EQ(shadow.draw({&no_model, 1}), Status::kNotCreated);
  ASSERT_EQ(shadow.draw({&one, 1}), Status::kOk) << "what was refused changed nothing";
  EXPECT_EQ(shadow.draw({&one, 1}), Status::kBadArgument) << "a second time";
  bind_target();
  draw.shadowed_light = 1;
  EXPECT_EQ(draw_head(renderer_, receiver_, draw), Status::kBadArgument) << "no such light";
  draw.shadowed_light = 0;
  EXPECT_EQ(draw_head(renderer_, receiver_, draw), Status::kOk);
  shadow.destroy();
  EXPECT_EQ(draw_head(renderer_, receiver_, draw), Status::kBadArgument);
}

}  // namespace coif::shadow_state_test
