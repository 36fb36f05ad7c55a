#include "gl/shadow_scene.h"

#include <cmath>

namespace coif {

void ShadowScene::SetUp() {
  CountedGlTest::SetUp();
  if (!context_) return;
  GLint target = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &target);
  target_ = GLuint(target);
  ASSERT_EQ(receiver_.upload(renderer_, *DrawnAsset(card_contents(std::array{DrawnCard{}}))), Status::kOk);
}

void ShadowScene::TearDown() {
  receiver_.destroy();
  CountedGlTest::TearDown();
}

DrawnCard ShadowScene::card_above(float height, double alpha, float half_size) {
  DrawnCard card;
  card.center = {height, 0, height};
  card.half_size = half_size;
  card.rgba[3] = static_cast<std::uint8_t>(std::lround(255 * alpha));
  return card;
}

void ShadowScene::cast(HairShadow& shadow, std::span<const DrawnCard> cards, const Light& light,
                       const ShadowBall& ball) {
  HairModel model;
  ASSERT_EQ(model.upload(renderer_, *DrawnAsset(card_contents(cards))), Status::kOk);
  const HeadDraw rest = at_rest();
  const HairInstance head{rest.head, rest.palette, 0};
  const ShadowCrowd crowd{&model, {&head, 1}, nullptr};
  ASSERT_EQ(shadow.begin(light, ball), Status::kOk);
  ASSERT_EQ(shadow.draw({&crowd, 1}), Status::kOk);
  model.destroy();
}

void ShadowScene::bind_target() const {
  glBindFramebuffer(GL_FRAMEBUFFER, target_);
  glViewport(0, 0, kSize, kSize);
}

double ShadowScene::light_at(int x, int y, const HairShadow& shadow, const Light& light) {
  HeadDraw desc = at_rest();
  desc.lights = {&light, 1};
  desc.component = Component::kDiffuse;
  desc.framebuffer_is_srgb = true;  // linear values, to compare
  bind_target();
  int found[2] = {};
  for (const bool shaded : {false, true}) {
    desc.shadow = shaded ? &shadow : nullptr;
    clear();
    EXPECT_EQ(draw_head(renderer_, receiver_, desc), Status::kOk);
    found[shaded ? 1 : 0] = pixel(x, y)[1];
  }
  EXPECT_GT(found[0], 50) << "without light there is no share of it";
  return double(found[1]) / found[0];
}

std::vector<ShadowDesc> all_shadows() {
  return {{.technique = &kPlainShadow, .size = 256},
          {.technique = &kDeepOpacityShadow, .size = 256, .layers = 4, .depth = 3},
          {.technique = &kDeepOpacityShadow, .size = 256, .layers = 8, .depth = 3},
          {.technique = &kOpacityShadow, .size = 256, .layers = 12},
          {.technique = &kDeepShadow, .size = 256, .layers = 4}};
}

}  // namespace coif
