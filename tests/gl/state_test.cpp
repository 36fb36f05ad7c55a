#include "gl/gl_test.h"
#include "render/picture.h"

#include <GLES3/gl31.h>

#include <array>
#include <span>
#include <vector>

namespace coif::state_test {

struct Value {
  GLenum name;
  std::array<GLint, 4> initial{};
};

// What draw() sets, with OpenGL's initial values.
const std::vector<Value> kOwned = {
    {GL_CURRENT_PROGRAM},
    {GL_VERTEX_ARRAY_BINDING},
    {GL_ACTIVE_TEXTURE, {GL_TEXTURE0}},
    {GL_UNIFORM_BUFFER_BINDING},
    {GL_BLEND},
    {GL_BLEND_SRC_RGB, {GL_ONE}},
    {GL_BLEND_DST_RGB, {GL_ZERO}},
    {GL_BLEND_SRC_ALPHA, {GL_ONE}},
    {GL_BLEND_DST_ALPHA, {GL_ZERO}},
    {GL_BLEND_EQUATION_RGB, {GL_FUNC_ADD}},
    {GL_BLEND_EQUATION_ALPHA, {GL_FUNC_ADD}},
    {GL_DEPTH_TEST},
    {GL_DEPTH_FUNC, {GL_LESS}},
    {GL_DEPTH_WRITEMASK, {GL_TRUE}},
    {GL_CULL_FACE},
    {GL_CULL_FACE_MODE, {GL_BACK}},
    {GL_FRONT_FACE, {GL_CCW}},
    {GL_COLOR_WRITEMASK, {GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE}},
};

// What a host might have set and draw() must leave alone.
const std::vector<GLenum> kForeign = {
    GL_VIEWPORT,
    GL_SCISSOR_TEST,
    GL_SCISSOR_BOX,
    GL_DRAW_FRAMEBUFFER_BINDING,
    GL_READ_FRAMEBUFFER_BINDING,
    GL_RENDERBUFFER_BINDING,
    GL_ARRAY_BUFFER_BINDING,
    GL_PIXEL_PACK_BUFFER_BINDING,
    GL_PIXEL_UNPACK_BUFFER_BINDING,
    GL_COPY_READ_BUFFER_BINDING,
    GL_STENCIL_TEST,
    GL_STENCIL_FUNC,
    GL_STENCIL_REF,
    GL_STENCIL_WRITEMASK,
    GL_POLYGON_OFFSET_FILL,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_COVERAGE,
    GL_DITHER,
    GL_RASTERIZER_DISCARD,
    GL_PRIMITIVE_RESTART_FIXED_INDEX,
    GL_UNPACK_ALIGNMENT,
    GL_PACK_ALIGNMENT,
    GL_TEXTURE_BINDING_CUBE_MAP,
    GL_TEXTURE_BINDING_3D,
};

std::array<GLint, 4> query(GLenum name) {
  std::array<GLint, 4> values{};
  glGetIntegerv(name, values.data());
  return values;
}

std::vector<std::array<GLint, 4>> query_all(std::span<const GLenum> names) {
  std::vector<std::array<GLint, 4>> values;
  for (const GLenum name : names) values.push_back(query(name));
  return values;
}

/// The opposite of everything that draw() sets.
void set_hostile_owned_state() {
  glEnable(GL_BLEND);
  glBlendFuncSeparate(GL_DST_COLOR, GL_SRC_COLOR, GL_ZERO, GL_ZERO);
  glBlendEquation(GL_FUNC_REVERSE_SUBTRACT);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glDepthMask(GL_FALSE);
  glEnable(GL_CULL_FACE);
  glCullFace(GL_FRONT_AND_BACK);
  glFrontFace(GL_CW);
  glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_FALSE);
  glActiveTexture(GL_TEXTURE5);
}

void set_unusual_foreign_state() {
  GLuint buffers[3] = {};
  glGenBuffers(3, buffers);
  glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
  glBindBuffer(GL_COPY_READ_BUFFER, buffers[1]);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffers[2]);
  glViewport(1, 2, 30, 29);
  glEnable(GL_SCISSOR_TEST);
  glScissor(2, 1, 28, 30);
  glEnable(GL_POLYGON_OFFSET_FILL);
  glStencilFunc(GL_ALWAYS, 3, 0xFF);
  glDisable(GL_DITHER);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 2);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
}

class DrawState : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    DrawnCard solid, soft;
    soft.rgba[3] = 128;
    soft.center[2] = 1;
    AssetContents contents = card_contents(std::array{solid, soft});
    contents.relief_texels.assign(32, std::byte{160});
    contents.reliefs = {{TextureRole::kNormal, TexelFormat::kRg8, 1, 1, 1, 0, 0, 2},
                        {TextureRole::kStrandAxis, TexelFormat::kRg8, 1, 1, 1, 0, 16, 2}};
    ASSERT_EQ(model_.upload(renderer_, *DrawnAsset(contents)), Status::kOk);
  }
  void TearDown() override {
    model_.destroy();
    GlTest::TearDown();
  }

  HairModel model_;
};

TEST_F(DrawState, IsLeftAtInitialValuesWhereDrawSetsIt) {
  for (const TransparencyMode* mode : render::transparency_modes()) {
    set_hostile_owned_state();
    HeadDraw desc = at_rest();
    desc.transparency = mode;
    ASSERT_EQ(draw_head(renderer_, model_, desc), Status::kOk);
    for (const Value& value : kOwned) {
      EXPECT_EQ(query(value.name), value.initial) << name_of(*mode) << ", " << std::hex << value.name;
    }
  }
}

TEST_F(DrawState, DoesNotDependOnWhatTheHostLeft) {
  ASSERT_EQ(draw_head(renderer_, model_, at_rest()), Status::kOk);
  const Pixel expected = middle_pixel();
  clear();
  set_hostile_owned_state();
  GLuint sampler = 0;  // would make the textures incomplete
  glGenSamplers(1, &sampler);
  glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_NEAREST);
  glSamplerParameteri(sampler, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
  for (const GLuint unit : {0u, 1u, 9u, 10u}) glBindSampler(unit, sampler);
  ASSERT_EQ(draw_head(renderer_, model_, at_rest()), Status::kOk);
  EXPECT_EQ(middle_pixel(), expected);
}

TEST_F(DrawState, TexturesSamplersAndBuffersAreUnbound) {
  for (const TransparencyMode* mode : render::transparency_modes()) {
    HeadDraw desc = at_rest();
    desc.transparency = mode;
    ASSERT_EQ(draw_head(renderer_, model_, desc), Status::kOk);
    for (GLuint unit = 0; unit < 16; ++unit) {
      glActiveTexture(GL_TEXTURE0 + unit);
      EXPECT_EQ(query(GL_TEXTURE_BINDING_2D)[0], 0) << name_of(*mode) << ", unit " << unit;
      EXPECT_EQ(query(GL_SAMPLER_BINDING)[0], 0) << name_of(*mode) << ", unit " << unit;
    }
    for (GLuint i = 0; i < 2; ++i) {
      GLint buffer = 0;
      glGetIntegeri_v(GL_UNIFORM_BUFFER_BINDING, i, &buffer);
      EXPECT_EQ(buffer, 0) << name_of(*mode);
      glGetIntegeri_v(GL_SHADER_STORAGE_BUFFER_BINDING, i, &buffer);
      EXPECT_EQ(buffer, 0) << name_of(*mode);
    }
    glGetError();  // an OpenGL ES 3.0 context knows no storage buffers
  }
}

TEST_F(DrawState, IsUntouchedWhereDrawDoesNotClaimIt) {
  set_unusual_foreign_state();
  for (const TransparencyMode* mode : render::transparency_modes()) {
    const auto before = query_all(kForeign);
    HeadDraw desc = at_rest();
    desc.transparency = mode;
    ASSERT_EQ(draw_head(renderer_, model_, desc), Status::kOk);
    const auto after = query_all(kForeign);
    for (std::size_t i = 0; i < kForeign.size(); ++i) {
      EXPECT_EQ(after[i], before[i]) << name_of(*mode) << ", " << std::hex << kForeign[i];
    }
  }
}

/// The same with so many bones that their matrices go into a texture.
class ManyBonesState : public GlTest {
 protected:
  static constexpr std::uint32_t kBones = kMostInBlock + 1;

  void SetUp() override {
    GlTest::SetUp();
    if (!context_) return;
    ASSERT_EQ(model_.upload(renderer_, *DrawnAsset(card_contents(std::array{DrawnCard{}}, kBones))), Status::kOk);
  }
  void TearDown() override {
    model_.destroy();
    GlTest::TearDown();
  }

  HairModel model_;
};

TEST_F(ManyBonesState, IsLeftAtInitialValuesWhereDrawSetsIt) {
  set_hostile_owned_state();
  set_unusual_foreign_state();
  ASSERT_EQ(draw_head(renderer_, model_, at_rest(kBones)), Status::kOk);
  for (const Value& value : kOwned) EXPECT_EQ(query(value.name), value.initial) << std::hex << value.name;
  EXPECT_EQ(query(GL_PIXEL_UNPACK_BUFFER_BINDING)[0], 0);
  EXPECT_EQ(query(GL_UNPACK_ALIGNMENT)[0], 4);
  for (GLuint unit = 0; unit < 3; ++unit) {
    glActiveTexture(GL_TEXTURE0 + unit);
    EXPECT_EQ(query(GL_TEXTURE_BINDING_2D)[0], 0) << unit;
    EXPECT_EQ(query(GL_SAMPLER_BINDING)[0], 0) << unit;
  }
}

TEST_F(ManyBonesState, DoesNotDependOnWhatTheHostLeft) {
  ASSERT_EQ(draw_head(renderer_, model_, at_rest(kBones)), Status::kOk);
  const Pixel expected = middle_pixel();
  EXPECT_NE(expected, Pixel({0, 0, 0, 0}));
  clear();
  GLuint buffer = 0;  // empty: to read from it is an error
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 5000);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, 1);
  GLuint sampler = 0;
  glGenSamplers(1, &sampler);
  glSamplerParameteri(sampler, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glBindSampler(2, sampler);
  ASSERT_EQ(draw_head(renderer_, model_, at_rest(kBones)), Status::kOk);
  EXPECT_EQ(middle_pixel(), expected);
}

TEST_F(DrawState, UploadIgnoresAndResetsTheHostsUnpackState) {
  GLuint buffer = 0;
  glGenBuffers(1, &buffer);
  glBindBuffer(GL_PIXEL_UNPACK_BUFFER, buffer);
  glPixelStorei(GL_UNPACK_ROW_LENGTH, 77);
  glPixelStorei(GL_UNPACK_SKIP_PIXELS, 5);
  glPixelStorei(GL_UNPACK_SKIP_ROWS, 3);
  DrawnCard red;
  red.rgba = {255, 0, 0, 255};
  draw_cards(std::span(&red, 1));
  EXPECT_TRUE(near(middle_pixel(), {255, 0, 0, 255}));
  for (const GLenum name : {GL_PIXEL_UNPACK_BUFFER_BINDING, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_PIXELS,
                            GL_UNPACK_SKIP_ROWS, GL_ARRAY_BUFFER_BINDING, GL_VERTEX_ARRAY_BINDING}) {
    EXPECT_EQ(query(name)[0], 0) << std::hex << name;
  }
  EXPECT_EQ(query(GL_UNPACK_ALIGNMENT)[0], 4);
}

}  // namespace coif::state_test
