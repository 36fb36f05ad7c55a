// What shades what, and how much.

#include "gl/shadow_scene.h"

#include <GLES3/gl3.h>

#include <array>
#include <string>
#include <vector>

namespace coif::shadow_test {

std::string named(const ShadowDesc& desc) {
  return std::string(name_of(*desc.technique)) + ", " + std::to_string(desc.layers) + " layers";
}

class Shadow : public ShadowScene {
 protected:
  void create(HairShadow& shadow, const ShadowDesc& desc) {
    ASSERT_EQ(shadow.create(renderer_, calls_->loader(), desc), Status::kOk) << renderer_.failure();
  }
};

TEST_F(Shadow, ACardTakesItsAlphaOfTheLightInLayers) {
  for (const std::uint32_t layers : {4u, 8u}) {
    HairShadow shadow;
    create(shadow, {.technique = &kDeepOpacityShadow, .size = 256, .layers = layers});
    for (const double alpha : {0.2, 0.5, 0.8}) {
      cast(shadow, std::array{card_above(0.5f, alpha)});
      EXPECT_NEAR(light_at_middle(shadow), 1 - alpha, 0.02) << layers << " layers";
    }
    cast(shadow, std::array{card_above(0.5f, 1)});
    EXPECT_LT(light_at_middle(shadow), 0.03) << layers << " layers";
    shadow.destroy();
  }
}

TEST_F(Shadow, CardsAboveEachOtherTakeOfWhatIsLeft) {
  for (const std::uint32_t layers : {4u, 8u}) {
    HairShadow shadow;
    create(shadow, {.technique = &kDeepOpacityShadow, .size = 256, .layers = layers, .depth = 3});
    cast(shadow, std::array{card_above(0.3f, 0.5), card_above(0.5f, 0.4), card_above(0.7f, 0.3)});
    EXPECT_NEAR(light_at_middle(shadow), 0.5 * 0.6 * 0.7, 0.03) << layers << " layers";
    shadow.destroy();
  }
}

// Their steps keep 5 bits of light.
TEST_F(Shadow, ADeepMapKnowsEachOfItsLayersAndTheRest) {
  for (const std::uint32_t layers : {0u, 2u, 4u, 6u}) {
    HairShadow shadow;
    create(shadow, {.technique = &kDeepShadow, .size = 256, .layers = layers});
    for (const double alpha : {0.2, 0.5, 0.8, 1.0}) {
      cast(shadow, std::array{card_above(0.5f, alpha)});
      EXPECT_NEAR(light_at_middle(shadow), 1 - alpha, 0.03) << layers << " layers";
    }
    cast(shadow, std::array{card_above(0.3f, 0.5), card_above(0.5f, 0.4), card_above(0.7f, 0.3)});
    EXPECT_NEAR(light_at_middle(shadow), 0.5 * 0.6 * 0.7, 0.04) << layers << " layers";
    shadow.destroy();
  }
}

TEST_F(Shadow, PlanesAddUpWhatLiesBeforeThem) {
  for (const std::uint32_t layers : {0u, 4u, 8u, 12u}) {
    HairShadow shadow;
    create(shadow, {.technique = &kOpacityShadow, .size = 256, .layers = layers});
    cast(shadow, std::array{card_above(0.8f, 0.3), card_above(0.9f, 0.5)});
    EXPECT_NEAR(light_at_middle(shadow), 0.7 * 0.5, 0.03) << layers << " planes";
    shadow.destroy();
  }
}

// Less than the two texels of a plain map's bias beneath each other, as hair's cards lie.
TEST_F(Shadow, ADeepMapTellsCardsThatLieCloseApart) {
  HairShadow shadow;
  create(shadow, {.technique = &kDeepShadow, .size = 256});  // texels of 12 mm
  // What hides the light of hair lies 8 mm and more above it: shadows are looked up half way there.
  cast(shadow, std::array{DrawnCard{}, card_above(0.009f, 1)});
  EXPECT_LT(light_at_middle(shadow), 0.1) << "beneath";
  EXPECT_GT(light_at(9, 16, shadow), 0.9) << "beside";
  cast(shadow, std::array{DrawnCard{}, card_above(-0.002f, 1)});
  EXPECT_GT(light_at_middle(shadow), 0.9) << "above";
  cast(shadow, std::array{DrawnCard{}, card_above(0.007f, 1)});
  EXPECT_GT(light_at_middle(shadow), 0.9) << "in the same lock";
  shadow.destroy();
}

TEST_F(Shadow, WhatLiesBehindACardTakesNothingOfItsLight) {
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    create(shadow, desc);
    cast(shadow, std::array{card_above(0.5f, 0.3), card_above(-0.6f, 1), card_above(-0.9f, 1)});
    EXPECT_GT(light_at_middle(shadow), 0.67) << named(desc);
    shadow.destroy();
  }
}

TEST_F(Shadow, APlainMapKnowsSolidAndNothing) {
  HairShadow shadow;
  create(shadow, {.technique = &kPlainShadow, .size = 256});
  cast(shadow, std::array{card_above(0.5f, 1)});
  EXPECT_EQ(light_at_middle(shadow), 0);
  cast(shadow, std::array{card_above(0.5f, 0.6)});
  EXPECT_EQ(light_at_middle(shadow), 0);
  cast(shadow, std::array{card_above(0.5f, 0.4)});
  EXPECT_EQ(light_at_middle(shadow), 1);
  shadow.destroy();
}

TEST_F(Shadow, LiesWhereTheLightPutsItAndNowhereElse) {
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    create(shadow, desc);
    cast(shadow, std::array{card_above(0.5f, 1)});  // 0.4 m wide; the receiver is 1 m wide, 16 pixels
    EXPECT_LT(light_at(18, 18, shadow), 0.1) << named(desc);
    EXPECT_GT(light_at(10, 16, shadow), 0.97) << named(desc);
    EXPECT_GT(light_at(21, 16, shadow), 0.97) << named(desc);
    EXPECT_GT(light_at(16, 22, shadow), 0.97) << named(desc);
    shadow.destroy();
  }
}

TEST_F(Shadow, NothingShadesItselfAtItsLitSide) {
  for (ShadowDesc desc : all_shadows()) {
    for (const std::uint32_t size : {64u, 512u}) {
      for (const Vec3 towards : {Vec3{0, 0, 1}, Vec3{1, 0, 1}, Vec3{-0.6f, 0.5f, 0.4f}}) {
        const Light light{Light::Kind::kDirectional, towards, {1, 1, 1}};
        HairShadow shadow;
        desc.size = size;
        create(shadow, desc);
        cast(shadow, std::array{DrawnCard{}}, light);
        for (const int x : {10, 13, 16, 20}) {
          // A coarse map's texels are nearly as wide as its first layer is thick.
          EXPECT_GT(light_at(x, 17, shadow, light), size < 512 ? 0.85 : 0.9)
              << named(desc) << ", " << size << ", pixel " << x;
        }
        shadow.destroy();
      }
    }
  }
}

// As it does most of a head's sides: from one texel of the map to the next the card is many texels nearer to the light.
TEST_F(Shadow, HairThatLightGrazesDoesNotShadeItselfInADeepMap) {
  for (const float rise : {0.2f, 0.1f, 0.05f, 0.025f}) {
    const Light light{Light::Kind::kDirectional, {1, 0.3f, rise}, {4, 4, 4}};
    HairShadow shadow;
    create(shadow, {.technique = &kDeepShadow, .size = 256});
    cast(shadow, std::array{DrawnCard{}}, light);
    for (int x = 10; x < 22; ++x) EXPECT_GT(light_at(x, 17, shadow, light), 0.9) << rise << ", pixel " << x;
    shadow.destroy();
  }
}

// The map ends across the receiver, so that it holds the nearer part of it alone.
TEST_F(Shadow, TheFarEndOfTheMapShadesNothing) {
  constexpr ShadowBall kEndsHere{{1.06066, 0, 1.06066}, 1.5f};
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    create(shadow, desc);
    cast(shadow, std::array{DrawnCard{}}, lamp(), kEndsHere);
    for (int x = 9; x < 24; ++x) EXPECT_GT(light_at(x, 16, shadow), 0.9) << named(desc) << ", pixel " << x;
    cast(shadow, std::array{card_above(0.5f, 1)}, lamp(), kEndsHere);
    for (const int x : {14, 17}) EXPECT_LT(light_at(x, 16, shadow), 0.1) << named(desc) << ", pixel " << x;
    shadow.destroy();
  }
}

TEST_F(Shadow, LightsWithAPlaceCastThemFromThere) {
  for (const ShadowDesc& desc : all_shadows()) {
    for (const Light::Kind kind : {Light::Kind::kPoint, Light::Kind::kSpot}) {
      const Light light{kind, {3, 0, 3}, {18, 18, 18}, {-1, 0, -1}};
      HairShadow shadow;
      create(shadow, desc);
      cast(shadow, std::array{card_above(0.5f, 0.7)}, light);
      const double expected = desc.technique == &kPlainShadow ? 0 : 0.3;  // of a card of alpha 0.7
      EXPECT_NEAR(light_at_middle(shadow, light), expected, 0.03) << named(desc);
      EXPECT_GT(light_at(10, 16, shadow, light), 0.97) << named(desc);
      // From 3 m the shadow of 0.4 m at 0.5 m height is 0.48 m wide.
      EXPECT_LT(light_at(16, 19, shadow, light), expected + 0.1) << named(desc);
      shadow.destroy();
    }
  }
}

TEST_F(Shadow, BelongsToOneLight) {
  HairShadow shadow;
  create(shadow, {.technique = &kPlainShadow, .size = 256});
  cast(shadow, std::array{card_above(0.5f, 1)});
  const std::array lights{Light{Light::Kind::kDirectional, {0, 0, 1}, {0.4f, 0, 0}},
                          Light{Light::Kind::kDirectional, kTowardsLight, {0, 0.4f, 0}}};
  HeadDraw desc = at_rest();
  desc.lights = lights;
  desc.component = Component::kDiffuse;
  desc.shadow = &shadow;
  for (const std::uint32_t light : {0u, 1u}) {
    desc.shadowed_light = light;
    bind_target();
    clear();
    ASSERT_EQ(draw_head(renderer_, receiver_, desc), Status::kOk);
    EXPECT_EQ(middle_pixel()[light], 0);
    EXPECT_GT(middle_pixel()[1 - light], 50);
  }
  shadow.destroy();
}

TEST_F(Shadow, AHostsCastersShadeHair) {
  const char* const vertex =
      "#version 300 es\nuniform mat4 clip;\nvoid main() {\n"
      "vec2 c = vec2(gl_VertexID % 2, gl_VertexID / 2) * 0.4 - 0.2;\n"
      "gl_Position = clip * vec4(c.x + 0.5, c.y, 0.5, 1.0); }";
  const char* const fragment = "#version 300 es\nvoid main() {}";
  const GLuint program = glCreateProgram();
  for (const auto& [stage, source] : {std::pair{GL_VERTEX_SHADER, vertex}, {GL_FRAGMENT_SHADER, fragment}}) {
    const GLuint shader = glCreateShader(stage);
    glShaderSource(shader, 1, &source, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    create(shadow, desc);
    ASSERT_EQ(shadow.begin(lamp(), kBall), Status::kOk);
    float clip[16];
    shadow.clip_from_origin({}, clip);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "clip"), 1, GL_FALSE, clip);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    ASSERT_EQ(shadow.draw({}), Status::kOk);
    EXPECT_EQ(light_at_middle(shadow), 0) << named(desc);
    EXPECT_EQ(light_at(10, 16, shadow), 1) << named(desc);
    shadow.destroy();
  }
}

TEST_F(Shadow, IsTheSameFarFromTheWorldsOrigin) {
  constexpr double kFar = 30'000;
  for (const ShadowDesc& desc : all_shadows()) {
    HairShadow shadow;
    create(shadow, desc);
    ShadowBall ball = kBall;
    ASSERT_EQ(shadow.begin(lamp(), ball), Status::kOk);
    const ShadowUniforms here = shadow.uniforms({1, 2, 3});
    ball.center[0] += kFar;
    ASSERT_EQ(shadow.begin(lamp(), ball), Status::kOk);
    const ShadowUniforms there = shadow.uniforms({1 + float(kFar), 2, 3});
    const float texel = 1.0f / float(desc.size);
    for (int i = 0; i < 16; ++i) EXPECT_NEAR(there.map_from_origin[i], here.map_from_origin[i], 1.01f * texel) << i;
    shadow.destroy();
  }
}

TEST_F(Shadow, StepsInWholeTexelsWhileTheBallMoves) {
  HairShadow shadow;
  create(shadow, {.technique = &kPlainShadow, .size = 64});
  const Vec3 point{0.3f, 0.2f, 0.1f};
  const auto place = [&](double moved) {
    ShadowBall ball = kBall;
    ball.center[0] += moved;
    EXPECT_EQ(shadow.begin(lamp(), ball), Status::kOk);
    const float x = shadow.uniforms(point).map_from_origin[12] * 64;  // in texels
    return double(x - std::floor(x));
  };
  const double still = place(0);
  for (const double moved : {0.001, 0.01, 0.03, 0.2, 0.777}) EXPECT_NEAR(place(moved), still, 1e-3) << moved;
  ASSERT_EQ(shadow.draw({}), Status::kOk);
  shadow.destroy();
}

}  // namespace coif::shadow_test
